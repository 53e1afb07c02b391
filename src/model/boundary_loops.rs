//! The boundary loops of a repaired surface with several: one is the outline, the others are holes.

use crate::conformal::{MeshedSurface, Side};
use crate::geometry::DVec3;
use crate::model::Model;
use crate::session::{Command, SurfaceSpec};

/// A boundary loop of a surface.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundaryLoop {
    /// Its number among the surface's loops, counted from 0 by falling length.
    pub number: u16,
    /// Whether it is the outline; the others are filled.
    pub is_outline: bool,
    /// Its length, in the units of the file.
    pub length: f64,
    /// The positions of its vertices, in their order.
    pub places: Vec<DVec3>,
}

impl Model {
    /// The boundary loops of a side's surface, the longest first; empty unless there are several. Cost O(their
    /// vertices).
    pub fn boundary_loops(&self, side: Side) -> Vec<BoundaryLoop> {
        let Some((surface, state)) = self.surface(side) else { return Vec::new() };
        let Some(surface) = surface.surface().filter(|surface| !surface.holes().is_empty()) else { return Vec::new() };
        let outline = state.spec().outline_loop;
        let numbers = (0..).filter(|&number| number != outline);
        let holes = numbers.zip(surface.holes()).map(|(number, hole)| one(surface, number, false, hole));
        let boundary: Vec<u32> = (0..surface.mesh().boundary_count()).collect();
        let mut loops: Vec<BoundaryLoop> = holes.chain([one(surface, outline, true, &boundary)]).collect();
        loops.sort_by_key(|each| each.number);
        loops
    }

    /// The command that makes the boundary loop of this number the outline of a side's surface.
    pub fn choose_outline(&self, side: Side, number: u16) -> Option<Command> {
        let spec: SurfaceSpec = self.surface_settings(side)?.clone();
        Some(Command::SetSurface { side, surface: spec.with_outline_loop(number) })
    }
}

fn one(surface: &MeshedSurface, number: u16, is_outline: bool, vertices: &[u32]) -> BoundaryLoop {
    let positions = surface.mesh().vertices();
    let places = vertices.iter().map(|&v| positions[v as usize]).collect();
    BoundaryLoop { number, is_outline, length: surface.surface().loop_length(vertices), places }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests {
    use super::*;
    use crate::model::surface_tests::settle;
    use crate::session::{Holes, Session, SurfaceShape, SurfaceState};
    use std::fmt::Write as _;

    const SIDE: Side = Side::Target;

    /// A square of 6 × 6 cells in space with two holes, of two cells and of one.
    fn holed() -> Vec<u8> {
        let (mut text, vertex) = (String::new(), |i: usize, j: usize| 1 + 7 * j + i);
        for (i, j) in (0..7).flat_map(|j| (0..7).map(move |i| (i, j))) {
            let _ = writeln!(text, "v {i} {j} {}", 0.1 * (i * j) as f64);
        }
        for (i, j) in (0..6).flat_map(|j| (0..6).map(move |i| (i, j))) {
            if ![(1, 1), (2, 1), (4, 4)].contains(&(i, j)) {
                let [a, b, c, d] = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| vertex(i, j));
                let _ = writeln!(text, "f {a} {b} {c} {d}");
            }
        }
        text.into_bytes()
    }

    /// Until the map is complete.
    fn rest(model: &mut Model) {
        for _ in 0..1000 {
            settle(model);
            if model.is_ready() {
                return;
            }
        }
        panic!("the map is not complete: {:?}", model.map_error());
    }

    fn state(outline_loop: u16) -> SurfaceState {
        let shape = SurfaceShape::File { name: "holed.obj".into() };
        SurfaceState::new(SurfaceSpec::new(shape).with_repair(true).with_outline_loop(outline_loop))
    }

    fn model(outline_loop: u16) -> Model {
        let mut model = Model::new(Session::default());
        model.open_surface_file(SIDE, state(outline_loop), holed());
        rest(&mut model);
        model
    }

    #[test]
    fn any_loop_can_become_the_outline_and_back_again() {
        let mut model = model(0);
        let loops = |model: &Model| -> Vec<_> {
            model.boundary_loops(SIDE).iter().map(|each| (each.is_outline, each.places.len())).collect()
        };
        assert_eq!(loops(&model), [(true, 24), (false, 6), (false, 4)]);
        let before = model.surface_point(SIDE);
        for (number, expected) in [(1, [(false, 24), (true, 6), (false, 4)]), (2, [(false, 24), (false, 6), (true, 4)])]
        {
            let command = model.choose_outline(SIDE, number).unwrap();
            model.dispatch(command, 0.0);
            rest(&mut model);
            assert_eq!(loops(&model), expected);
            assert_eq!(model.map().unwrap().mapped().boundary_count(), expected[number as usize].1);
        }
        let command = model.choose_outline(SIDE, 0).unwrap();
        model.dispatch(command, 0.0);
        rest(&mut model);
        assert_eq!((loops(&model)[0], model.surface_point(SIDE)), ((true, 24), before));
    }

    #[test]
    fn open_holes_are_not_painted_and_the_map_stays() {
        let mut model = model(0);
        let (all, images) = (model.shown().unwrap().triangles.len(), model.shown().unwrap().images.to_vec());
        model.dispatch(Command::SetHoles { side: SIDE, holes: Holes::Open }, 0.0);
        rest(&mut model);
        let shown = model.shown().unwrap();
        // a fan of six triangles in one hole, of four in the other
        assert_eq!((shown.triangles.len(), shown.images), (all - 10, &images[..]));
        assert_eq!(model.painted(SIDE, model.shown_surface(SIDE).unwrap()), shown.triangles);
        let notes = model.surface_notes(SIDE);
        assert!(notes.iter().any(|note| note.english().contains("open")), "{notes:?}");
        let file = crate::session::file::write(model.session()).unwrap();
        assert_eq!(crate::session::file::read(file.as_bytes()).as_ref(), Ok(model.session()));
    }

    #[test]
    fn a_loop_that_the_file_does_not_have_is_refused_with_those_it_has() {
        let mut model = Model::new(Session::default());
        model.open_surface_file(SIDE, state(7), holed());
        while let Some((side, request)) = model.take_requests(f64::INFINITY).into_iter().find(|(side, _)| *side == SIDE)
        {
            crate::worker::run(&request, &mut |generation, response| model.accept(side, generation, response));
        }
        let error = model.surface_side(SIDE).preparation.error.clone().unwrap();
        assert!(error.text.english().contains("3 boundary loops"), "{}", error.text.english());
    }
}
