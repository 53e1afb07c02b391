//! Figures 14, 16 and 17: a surface over several planar domains, or with several constraints (section 5.3).
//!
//! The scenes of a figure share one surface, which is prepared once: riemap's own, or a given one instead.

use super::{Cell, Detail, Figure, FigureError, Scene, Table, planar, prepare_spec};
use crate::conformal::{
    ConformalMap, Constraints, MapSettings, MeshedDomain, MeshedSurface, PrepareError, PreparedSide, Quality, Side,
    SurfaceSettings, prepare_surface,
};
use crate::geometry::{DVec2, DVec3};
use crate::mesh::{BarycentricPoint, VertexId};
use crate::session::{DomainSpec, Session, SurfaceShape, SurfaceState};
use crate::surface::{Surface, SurfaceMesh, at_vertex};
use std::sync::Arc;

/// The parameterization of one scene.
#[derive(Debug)]
#[non_exhaustive]
pub struct SurfaceStudy {
    /// The label of the scene.
    pub label: String,
    /// The session of the scene, without a given surface.
    pub session: Session,
    /// The map.
    pub map: ConformalMap,
    /// Its constraints.
    pub constraints: Constraints,
    /// The planar domain, and x₁ in it.
    pub source: (Arc<MeshedDomain>, DVec2),
    /// The surface, and x₂ on it.
    pub surface: (Arc<MeshedSurface>, BarycentricPoint),
}

impl SurfaceStudy {
    /// Computes all scenes of a figure, with the `given` surface instead of their own if there is one.
    ///
    /// Where the session does not set x₂, it is the hemisphere's pole, or the vertex farthest from the boundary. A
    /// given surface is expected with y up and z to the front: y₂ is the highest vertex of its loop, and on a face x₂
    /// is the foremost inner vertex. Errors: [`FigureError::NoSurface`] for a planar figure; an unsuitable surface.
    pub fn all(figure: Figure, detail: Detail, given: Option<&Surface>) -> Result<Vec<Self>, FigureError> {
        let scenes = figure.scenes(detail);
        let first = scenes.first().and_then(|scene| scene.session.surface(Side::Target));
        let state = first.cloned().ok_or(FigureError::NoSurface)?;
        let surface = match given {
            Some(surface) => prepared(surface, SurfaceSettings::default())?,
            None => own(&state)?,
        };
        let prepared = surface;
        let surface = Arc::clone(prepared.surface().ok_or(FigureError::NoSurface)?);
        let anchor = given.map_or(state.anchor, |_| top(&surface));
        let wanted = match (figure, given) {
            (Figure::LShapes, None) => surface.tree().nearest(DVec3::Z).map(|(pole, _)| pole),
            (Figure::Face, Some(_)) => foremost(&surface),
            _ => state.point,
        };
        let surface_point = wanted.unwrap_or(surface.centre());
        let mut sources: Vec<(DomainSpec, Arc<PreparedSide>)> = Vec::new();
        let study = |Scene { label, session }: Scene| {
            let side = session.side(Side::Source);
            let (spec, interior, source_anchor) = (side.domain(), side.interior(), side.anchor());
            let known = sources.iter().find(|(known, _)| known == spec).map(|(_, source)| Arc::clone(source));
            let source = match known {
                Some(source) => source,
                None => prepare_spec(spec)?,
            };
            sources.push((spec.clone(), Arc::clone(&source)));
            let domain = planar(&source)?;
            let point = interior.unwrap_or(domain.default_point());
            let constraints = Constraints::new((point, source_anchor), (surface_point, anchor));
            let map = ConformalMap::new(source, Arc::clone(&prepared), &constraints, MapSettings::default())?;
            let (source, surface) = ((domain, point), (Arc::clone(&surface), surface_point));
            Ok(Self { label: label.to_string(), session, map, constraints, source, surface })
        };
        scenes.into_iter().map(study).collect()
    }

    /// A table of counts, constraints and quality with a row for each scene.
    pub fn table(studies: &[Self]) -> Table {
        let mut table = Table::new(&[
            "scene",
            "m1",
            "triangles1",
            "m2",
            "triangles2",
            "delaunay_flips",
            "x1_x",
            "x1_y",
            "y1",
            "x2_x",
            "x2_y",
            "x2_z",
            "y2",
            "q_mean",
            "q_max",
            "flipped",
            "collapsed",
        ]);
        table.rows.extend(studies.iter().map(Self::row));
        table
    }

    fn row(&self) -> Vec<Cell> {
        let ((source, x1), (surface, x2)) = (&self.source, &self.surface);
        let (source, mesh) = (source.mesh(), surface.mesh());
        let mut row: Vec<Cell> = vec![self.label.as_str().into()];
        row.extend([source.boundary_count().into(), source.triangles().len().into()]);
        row.extend([mesh.boundary_count().into(), mesh.triangles().len().into(), surface.flips().flips.into()]);
        let (anchors, place) = (self.constraints.anchors, surface.position(*x2));
        let constraints = [x1.x, x1.y, anchors.source, place.x, place.y, place.z, anchors.target];
        row.extend(constraints.map(Cell::from));
        let Quality { q_mean, q_max, flipped, collapsed, .. } = self.map.quality();
        row.extend([q_mean, q_max].map(Cell::from));
        row.extend([flipped, collapsed].map(Cell::from));
        row
    }
}

fn prepared(surface: &Surface, settings: SurfaceSettings) -> Result<Arc<PreparedSide>, FigureError> {
    let mesh = SurfaceMesh::new(surface)?;
    Ok(Arc::new(prepare_surface(mesh, settings, &mut |_| ())?))
}

/// The prepared surface of a scene, which is a preset.
fn own(state: &SurfaceState) -> Result<Arc<PreparedSide>, FigureError> {
    match state.spec.shape {
        SurfaceShape::Preset { preset, boundary } => {
            prepared(&preset.surface(boundary).map_err(PrepareError::from)?, state.spec.settings)
        }
        SurfaceShape::File { .. } => Err(FigureError::NoSurface),
    }
}

/// The fraction of the loop's length at its highest vertex, y up.
fn top(surface: &MeshedSurface) -> f64 {
    let on_loop = surface.mesh().vertices().iter().zip(surface.fractions());
    on_loop.max_by(|(a, _), (b, _)| a.y.total_cmp(&b.y)).map_or(0.0, |(_, fraction)| *fraction)
}

/// The inner vertex with the largest z: on a face the tip of the nose, whereas the vertex farthest from the
/// boundary may lie in a nostril.
fn foremost(surface: &MeshedSurface) -> Option<BarycentricPoint> {
    let mesh = surface.mesh();
    let inside = mesh.boundary_count()..mesh.vertices().len() as u32;
    let z = |v: &u32| mesh.vertices()[*v as usize].z;
    at_vertex(mesh, VertexId::new(inside.max_by(|a, b| z(a).total_cmp(&z(b)))?))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::geometry::DVec2;
    use crate::surface::SurfacePreset;

    /// Boundary first flattening computes this L from the six points; here the six points are computed from the L.
    #[test]
    fn six_equidistant_points_of_the_hemisphere_go_to_the_corners_of_the_first_l() {
        let studies = SurfaceStudy::all(Figure::LShapes, Detail::Paper, None).unwrap();
        let first = &studies[0];
        let polygon = first.session.domain(Side::Source).outline.polygon();
        let corners = polygon.vertices();
        let m = first.map.mapped().boundary_count();
        assert_eq!((m, corners.len()), (900, 6));
        let samples = first.source.0.samples().points();
        for (k, &corner) in corners.iter().enumerate() {
            let sample = samples.iter().position(|&p| p == corner).unwrap();
            let sixths = k as f64 / 6.0;
            let measures = [(Side::Source, sample), (Side::Target, k * m / 6)]
                .map(|(side, vertex)| first.map.measure(side).at_vertex(vertex));
            let errors = measures.map(|measure| (measure - sixths).abs());
            let distance = first.map.images()[k * m / 6].distance(corner);
            println!("corner {k}: measures {errors:?} from {k}/6, image {distance:.1e} from the corner");
            // measured errors of the kernels: 1.6e-4 with the L's 1000 samples, 2e-6 with the hemisphere's 900
            assert!(errors[0] < 4e-4 && errors[1] < 1e-5, "corner {k}: {errors:?}");
            // at a convex corner f behaves as a square root, and the square root of that error is 0.013
            assert!(distance < 0.02, "corner {k}: off by {distance:e}");
        }
        // for the other L, sixths of the loop are not mapped to corners
        assert!(studies[1].map.images()[m / 6].distance(corners[1]) > 0.05);
        let top = studies[0].surface.0.mesh().vertices().iter().zip(first.map.images());
        let (_, image) = top.max_by(|a, b| a.0.z.total_cmp(&b.0.z)).unwrap();
        assert!(image.distance(DVec2::splat(3.0_f64.sqrt().recip())) < 0.01, "{image}");
    }

    #[test]
    fn a_given_surface_takes_the_place_of_the_figure_s() {
        let given = SurfacePreset::Paraboloid.surface(60).unwrap();
        let studies = SurfaceStudy::all(Figure::Face, Detail::Quick, Some(&given)).unwrap();
        for study in &studies {
            let (surface, x2) = (&study.surface.0, study.surface.1);
            assert_eq!(surface.mesh().boundary_count(), 60);
            let top = surface.boundary_position(study.map.mapped().at_fraction(study.constraints.anchors.target));
            assert!((top.y - 1.0).abs() < 1e-12, "the top of the unit circle, not {top}");
            let front = surface.position(x2).z;
            let inside = &surface.mesh().vertices()[60..];
            assert!(inside.iter().all(|p| p.z <= front + 1e-12), "{front} is not the front");
        }
        assert_eq!(SurfaceStudy::all(Figure::Moebius, Detail::Quick, None).unwrap_err(), FigureError::NoSurface);
        let inner = given.triangles().iter().position(|t| t.iter().all(|&v| v >= 60)).unwrap();
        let mut triangles = given.triangles().to_vec();
        triangles.remove(inner);
        let torn = Surface::new(given.vertices().to_vec(), triangles);
        let error = SurfaceStudy::all(Figure::Face, Detail::Quick, Some(&torn)).unwrap_err();
        assert!(matches!(error, FigureError::Topology(_)), "{error}");
    }
}
