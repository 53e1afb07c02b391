//! The surfaces, outlines and constraints of Figures 14, 16 and 17, as sessions.

use super::scenes::{SQUARES, uniform};
use super::{Detail, Scene, SceneLabel};
use crate::conformal::Side;
use crate::geometry::{DVec2, SimplePolygon};
use crate::outline::{Preset, Sampling};
use crate::session::{Colouring, Command, OutlineSpec, Session, SurfaceShape, SurfaceSpec};
use crate::surface::SurfacePreset;

/// m of the hemisphere in Figure 14.
const HEMISPHERE_SAMPLES: u32 = 900;

/// m of riemap's head and face: gives about as many triangles (30,000) as the paper's meshes.
const SURFACE_SAMPLES: u32 = 375;

/// Samples of the planar domains.
const OUTLINE_SAMPLES: u32 = 1000;

/// The arm's width of the L of [`l_of_six_points`], relative to its side: √3 − 1.
const L_ARM: f64 = 0.732_050_807_568_877_3;

/// x₁ in that L, on the diagonal: both coordinates are 1/√3.
const L_CENTER: f64 = 0.577_350_269_189_625_8;

/// |x₁| of Figure 16.
const RADII: [f64; 3] = [0.0, 0.4, 0.8];

/// The outlines of Figure 17, the arc-length fractions of their tops, and the squares of the checkerboard across them:
/// finer ones where the middle of the face covers little of the outline.
const FACE_OUTLINES: [(Preset, f64, f64); 4] = [
    (Preset::Disk, 0.25, 24.0),
    (Preset::Gingerbread, 0.0, 36.0),
    (Preset::Heart, 0.0, 24.0),
    (Preset::MapleLeaf, 0.0, 36.0),
];

/// y₂ on riemap's face, whose boundary is an ellipse that starts at its right end: the top.
const FACE_TOP: f64 = 0.25;

/// Squares of the checkerboard across an L.
const L_SQUARES: f64 = 16.0;

/// An L in a rectangle with one corner at the origin; `inner` is its concave corner, whose distances from the axes are
/// the widths of the arms. Counter-clockwise from that corner.
fn l_shape(size: DVec2, inner: DVec2) -> Vec<DVec2> {
    let at = DVec2::new;
    vec![inner, at(inner.x, size.y), at(0.0, size.y), DVec2::ZERO, at(size.x, 0.0), at(size.x, inner.y)]
}

/// The L whose corners are the images of the disk's sixth roots of unity, the concave corner that of 1.
///
/// By Schwarz and Christoffel f′(z) = (1 − z)/√(1 − z⁶) up to a factor. With the integrals P and R of 1/√(1 − r⁶) and
/// r/√(1 − r⁶) over (0, 1), the diagonal f(1) − f(−1) has length 2P, and f(0) is at distance P + R from the outer
/// corner. The sides' lengths are integrals over arcs, which gives side : arm : notch = 1 : √3 − 1 : 2 − √3.
fn l_of_six_points() -> Vec<DVec2> {
    l_shape(DVec2::ONE, DVec2::splat(L_ARM))
}

/// A built-in surface on the target's side with y₂ at `anchor`, and the outline on the source's side.
fn over(outline: OutlineSpec, detail: Detail, preset: SurfacePreset, boundary: u32, anchor: f64) -> Session {
    let mut settings = uniform(detail.samples(OUTLINE_SAMPLES));
    if let Sampling::Uniform { keep_corners, .. } = &mut settings.sampling {
        *keep_corners = true;
    }
    let shape = SurfaceShape::Preset { preset, boundary };
    Session::with([
        Command::SetOutline { side: Side::Source, outline },
        // y₁ is the outline's first point
        Command::MoveAnchor { side: Side::Source, fraction: 0.0 },
        Command::SetSettings { side: Side::Source, settings },
        Command::SetSurface { side: Side::Target, surface: SurfaceSpec { shape, ..SurfaceSpec::default() } },
        Command::MoveAnchor { side: Side::Target, fraction: anchor },
        Command::SetTextureScale(SQUARES),
    ])
}

fn source_point(point: DVec2) -> Command {
    Command::MoveInterior { side: Side::Source, point: point.into() }
}

/// The scenes of Figure 14.
pub(super) fn l_shapes(detail: Detail) -> Vec<Scene> {
    // a multiple of 6, so that each sixth of the loop ends at a vertex
    let boundary = detail.samples(HEMISPHERE_SAMPLES) / 6 * 6;
    let scene = |label: SceneLabel, points: Vec<DVec2>, interior: Option<DVec2>| {
        let outline = OutlineSpec::points(String::from("L"), SimplePolygon::known_simple(points));
        let session = over(outline, detail, SurfacePreset::Hemisphere, boundary, 0.0);
        let session = session.and(interior.map(source_point)).and([Command::SetTextureScale(L_SQUARES)]);
        Scene { label, session }
    };
    let narrow = l_shape(DVec2::ONE, DVec2::splat(0.45));
    let unequal = l_shape(DVec2::new(1.0, 0.8), DVec2::new(0.3, 0.45));
    vec![
        scene(SceneLabel::SixthsToCorners, l_of_six_points(), Some(DVec2::splat(L_CENTER))),
        scene(SceneLabel::InArm, l_of_six_points(), Some(DVec2::new(0.8, 0.36))),
        scene(SceneLabel::NarrowArms, narrow, None),
        scene(SceneLabel::UnequalArms, unequal, None),
    ]
}

/// The scenes of Figure 16.
pub(super) fn heads(detail: Detail) -> Vec<Scene> {
    let boundary = detail.samples(SURFACE_SAMPLES);
    let scene = |radius: f64| {
        let session = over(OutlineSpec::Preset(Preset::Disk), detail, SurfacePreset::AnimalHead, boundary, 0.0);
        let session = session.and([source_point(DVec2::new(radius, 0.0)), Command::SetColouring(Colouring::Angle)]);
        Scene { label: SceneLabel::Radius(radius), session }
    };
    RADII.map(scene).to_vec()
}

/// The scenes of Figure 17.
pub(super) fn faces(detail: Detail) -> Vec<Scene> {
    let boundary = detail.samples(SURFACE_SAMPLES);
    let scene = |(preset, top, texture_scale): (Preset, f64, f64)| {
        let session = over(OutlineSpec::Preset(preset), detail, SurfacePreset::HeightField, boundary, FACE_TOP);
        let top = Command::MoveAnchor { side: Side::Source, fraction: top };
        Scene {
            label: SceneLabel::Outline(preset),
            session: session.and([top, Command::SetTextureScale(texture_scale)]),
        }
    };
    FACE_OUTLINES.map(scene).to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    /// ∫ g over (a, b) by the midpoint rule in an angle that makes square-root singularities at both ends smooth.
    fn integral(g: impl Fn(f64) -> f64, a: f64, b: f64) -> f64 {
        let steps = 2000;
        let term = |k: i32| {
            let angle = PI * (f64::from(k) + 0.5) / f64::from(steps);
            g(0.5 * (a + b) - 0.5 * (b - a) * angle.cos()) * angle.sin()
        };
        0.5 * (b - a) * PI / f64::from(steps) * (0..steps).map(term).sum::<f64>()
    }

    #[test]
    fn the_l_of_six_points_is_that_of_schwarz_and_christoffel() {
        // |f′| on the circle
        let speed = |t: f64| 2.0 * (0.5 * t).sin() / (2.0 * (3.0 * t).sin().abs()).sqrt();
        let sixth = |k: f64| integral(speed, k * PI / 3.0, (k + 1.0) * PI / 3.0);
        let [notch, arm, side] = [0.0, 1.0, 2.0].map(sixth);
        assert!((notch + arm - side).abs() < 1e-5 * side, "it closes: {notch} + {arm} = {side}");
        assert!((arm / side - L_ARM).abs() < 1e-5 && (L_ARM - (3.0_f64.sqrt() - 1.0)).abs() < 1e-15, "{arm} {side}");
        // along the diagonal from the outer corner, f(−1), to f(0)
        let to_center = integral(|r| (1.0 + r) / (1.0 - r.powi(6)).sqrt(), 0.0, 1.0);
        let along_axis = to_center / 2.0_f64.sqrt() / side;
        assert!(
            (along_axis - L_CENTER).abs() < 1e-5 && (3.0 * L_CENTER * L_CENTER - 1.0).abs() < 1e-15,
            "{along_axis}"
        );
    }
}
