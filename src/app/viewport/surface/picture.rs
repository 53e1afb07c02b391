//! The small pictures of the built-in surfaces in the menu: flat-shaded triangles, far ones first.

use crate::geometry::{DVec3, sort_by_number};
use crate::surface::SurfacePreset;
use egui::{Color32, Id, Mesh, Pos2, Rect, Shape, Ui};
use std::sync::Arc;

/// Boundary vertices of a picture: about a thousand triangles, enough for an ear at 50 points across.
const BOUNDARY: u32 = 80;

/// How bright a triangle is that is seen edge on; one that faces the eye has brightness 1.
const DARKEST: f64 = 0.3;

/// A triangle in the square from −1 to 1, y down, and its brightness.
type Facet = ([Pos2; 3], f32);

/// Draws the surface into `frame`; what faces the eye is `lit`, what is seen edge-on nearly `shade`.
pub fn surface_picture(ui: &Ui, preset: SurfacePreset, frame: Rect, [shade, lit]: [Color32; 2]) {
    let mut mesh = Mesh::default();
    for (corners, brightness) in facets(ui.ctx(), preset).iter() {
        let colour = shade.lerp_to_gamma(lit, *brightness);
        let first = mesh.vertices.len() as u32;
        for p in corners {
            mesh.colored_vertex(frame.center() + 0.5 * frame.width() * p.to_vec2(), colour);
        }
        mesh.add_triangle(first, first + 1, first + 2);
    }
    ui.painter().add(Shape::mesh(mesh));
}

/// The triangles of a preset; made once.
fn facets(context: &egui::Context, preset: SurfacePreset) -> Arc<Vec<Facet>> {
    let id = Id::unique(("surface picture", preset.name()));
    if let Some(facets) = context.data(|data| data.get_temp::<Arc<Vec<Facet>>>(id)) {
        return facets;
    }
    let facets = Arc::new(projected(preset));
    context.data_mut(|data| data.insert_temp(id, Arc::clone(&facets)));
    facets
}

fn projected(preset: SurfacePreset) -> Vec<Facet> {
    let Ok(surface) = preset.surface(BOUNDARY) else { return Vec::new() };
    let [toward, upwards] = preset.view();
    let toward = toward.normalize();
    let right = upwards.cross(toward).normalize();
    let up = toward.cross(right);
    let bounds = |axis: DVec3| {
        let along = surface.vertices().iter().map(|p| p.dot(axis));
        along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
    };
    let ((left, to_right), (bottom, top)) = (bounds(right), bounds(up));
    let (middle, scale) = ((left + to_right, bottom + top), 2.0 / (to_right - left).max(top - bottom));
    let place = |p: DVec3| {
        let (x, y) = (p.dot(right) - 0.5 * middle.0, p.dot(up) - 0.5 * middle.1);
        Pos2::new((scale * x) as f32, (-scale * y) as f32)
    };
    let mut sorted: Vec<(f64, Facet)> = surface
        .triangles()
        .iter()
        .map(|corners| {
            let corners = corners.map(|v| surface.vertices()[v as usize]);
            let [a, b, c] = corners;
            let facing = (b - a).cross(c - a).normalize_or_zero().dot(toward).abs();
            let brightness = DARKEST + (1.0 - DARKEST) * facing;
            ((a + b + c).dot(toward), (corners.map(place), brightness as f32))
        })
        .collect();
    sort_by_number(&mut sorted, |(depth, _)| *depth);
    sorted.into_iter().map(|(_, facet)| facet).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_picture_fills_its_square_in_one_direction() {
        for preset in SurfacePreset::ALL {
            let facets = projected(preset);
            assert!(facets.len() > 100, "{preset}: {} triangles", facets.len());
            let largest =
                facets.iter().flat_map(|(corners, _)| corners).map(|p| p.x.abs().max(p.y.abs())).fold(0.0, f32::max);
            assert!((largest - 1.0).abs() < 1e-5, "{preset}: {largest}");
        }
    }
}
