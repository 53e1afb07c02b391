//! Quadrilaterals in the model: the rectangle as the other side, with its corners pinned, and the grids.

use crate::conformal::{GridCells, Side};
use crate::export::GridFormat;
use crate::model::editing::{Change, Reshaping};
use crate::model::overlays::invariants::InvariantsAction;
use crate::model::overlays::orthogonal_grid::{GridAction, GridWork};
use crate::model::surface_tests::settle;
use crate::model::*;
use crate::outline::{CurveForm, Preset};
use crate::session::{Command, OutlineSpec, SurfaceSpec};
use crate::worker::Finding;
use std::borrow::Cow;

/// Answers all requests until there are none.
fn rest(model: &mut Model) {
    model.update_ms = f64::INFINITY;
    for _ in 0..8 {
        settle(model);
        for (side, request) in model.take_requests(f64::INFINITY) {
            crate::worker::run(&request, &mut |generation, response| model.accept(side, generation, response));
        }
    }
    model.refresh(false);
    while let Some(task) = model.take_invariants() {
        model.accept_invariants(task.run());
    }
    while let GridWork::Begin(task) = next_grid(model) {
        let finding = match task.run(&mut |_| true) {
            Ok(found) => Finding::Grid(Box::new(found.unwrap())),
            Err(reason) => Finding::Failed(reason),
        };
        assert_eq!(model.accept_grid(&task, finding), None, "no file is asked for");
    }
}

/// What the worker of the grids is to do once nothing has changed for a while.
fn next_grid(model: &mut Model) -> GridWork {
    match model.next_grid_work(0.0) {
        GridWork::Wait(seconds) => model.next_grid_work(seconds),
        work => work,
    }
}

/// A model of this source with four marks, whose invariants are computed.
fn marked(outline: OutlineSpec, marks: [f64; 4]) -> Model {
    let mut model = Model::new(Session::with([Command::SetOutline { side: Side::Source, outline }]));
    model.act_on_invariants(InvariantsAction::Open(Side::Source, true));
    model.dispatch(Command::SetMarks { side: Side::Source, marks: Some(marks) }, 0.0);
    rest(&mut model);
    model
}

fn rectangle(length: f64) -> (OutlineSpec, [f64; 4]) {
    let points = [(0.0, 0.0), (length, 0.0), (length, 1.0), (0.0, 1.0)].map(DVec2::from).to_vec();
    let outline =
        OutlineSpec::Points { name: "r".into(), polygon: points.try_into().unwrap(), form: CurveForm::polygon() };
    let half = 0.5 * length / (length + 1.0);
    (outline, [0.0, half, 0.5, 0.5 + half])
}

fn preset(preset: Preset, marks: [f64; 4]) -> (OutlineSpec, [f64; 4]) {
    (OutlineSpec::Preset(preset), marks)
}

#[test]
fn one_command_maps_onto_the_rectangle_and_all_four_corners_are_met() {
    for (name, (outline, marks), most) in [
        ("L", preset(Preset::LShape, [0.0, 0.25, 0.625, 0.75]), 1e-6),
        ("disk", preset(Preset::Disk, [0.0, 0.175, 0.35, 0.625]), 1e-6),
        ("gingerbread", preset(Preset::Gingerbread, [0.1, 0.35, 0.6, 0.9]), 1e-6),
        ("3:1", rectangle(3.0), 1e-6),
        ("10:1", rectangle(10.0), 1e-3),
    ] {
        let mut model = marked(outline, marks);
        let before = model.session().clone();
        let Ok(command) = model.onto_rectangle(Side::Source).unwrap() else { panic!("{name} is refused") };
        model.dispatch(command, 0.0);
        assert_eq!(*model.session(), before, "{name}: the last good map stays");
        rest(&mut model);
        let (misses, fourth) = (model.pin_misses().unwrap(), model.fourth_miss(Side::Source).unwrap());
        let worst = misses.iter().copied().fold(fourth, f64::max);
        println!("{name}: corners are missed by {misses:?} and {fourth:.1e}");
        assert!(misses.len() == 3 && worst < most, "{name}: {misses:?} and {fourth}");
    }
}

#[test]
fn a_long_quadrilateral_is_refused_and_nothing_changes() {
    let (outline, marks) = rectangle(25.0);
    let model = marked(outline, marks);
    let refused = model.onto_rectangle(Side::Source).unwrap().unwrap_err().english();
    let expected = "the side from mark 2 to 3 is too far from the side from mark 4 to 1: the quadrilateral is 25 or more \
                    times as long as wide, and 18 is the limit";
    assert!(refused == expected && model.is_too_long(Side::Source), "{refused}");
    // without marks, or with a surface in the outline's place, there is no quadrilateral
    let mut model = marked(OutlineSpec::Preset(Preset::Disk), [0.0, 0.25, 0.5, 0.75]);
    assert!(model.onto_rectangle(Side::Target).is_none());
    model.dispatch(Command::SetSurface { side: Side::Source, surface: SurfaceSpec::default() }, 0.0);
    rest(&mut model);
    assert!(model.onto_rectangle(Side::Source).is_none() && model.marks(Side::Source).is_none());
}

#[test]
fn the_lattice_lies_on_the_rectangle_until_a_pin_is_moved() {
    let (outline, marks) = preset(Preset::LShape, [0.0, 0.25, 0.625, 0.75]);
    let mut model = marked(outline, marks);
    model.act_on_grids(GridAction::Show(Side::Source, true));
    model.act_on_grids(GridAction::Cells(Side::Source, GridCells::new([4, 3]).unwrap()));
    rest(&mut model);
    let lines: Vec<Vec<DVec2>> = model.grid_lines(Side::Source).into_iter().map(Cow::into_owned).collect();
    assert_eq!((lines.len(), model.grid_lines(Side::Target).len()), (3 + 2, 0));
    let command = model.onto_rectangle(Side::Source).unwrap().unwrap();
    model.dispatch(command, 0.0);
    rest(&mut model);
    let lattice = model.grid_lines(Side::Target);
    assert_eq!(lattice.len(), 3 + 2);
    // the ends of a line and of its image are each other's images
    let map = model.map().unwrap();
    for (line, image) in lines.iter().zip(&lattice) {
        let ends = [(line[0], image[0]), (line[line.len() - 1], image[image.len() - 1])];
        for (from, onto) in ends {
            let fraction = model.anchor_near(Side::Source, from).unwrap();
            let there = map.boundary_image(Side::Source, fraction);
            let expected = model.anchor_near(Side::Target, onto).unwrap();
            assert!((there - expected).abs() < 1e-4, "{from} goes to {there}, not to {expected}");
        }
    }
    let moved = Command::MovePin { pin: 1, side: Side::Source, fraction: marks[1] + 0.01 };
    model.dispatch(moved, 0.0);
    rest(&mut model);
    assert!(model.pinned_rectangle(Side::Source).is_none() && model.grid_lines(Side::Target).is_empty());
    assert_eq!(model.grid_lines(Side::Source).len(), 3 + 2);
}

/// What is shown beside a picture belongs to its outline, however that has come to its side.
#[test]
fn marks_are_shown_with_their_outline_on_either_side() {
    let (outline, marks) = preset(Preset::LShape, [0.0, 0.25, 0.625, 0.75]);
    let mut model = marked(outline, marks);
    model.act_on_grids(GridAction::Show(Side::Source, true));
    let cells = GridCells::new([5, 3]).unwrap();
    model.act_on_grids(GridAction::Cells(Side::Source, cells));
    rest(&mut model);
    model.dispatch(Command::Swap, 0.0);
    rest(&mut model);
    assert_eq!(Side::BOTH.map(|side| model.marks(side)), [None, Some(marks)]);
    assert_eq!(model.grid_lines(Side::Target).len(), 4 + 2, "the grid goes along");
    let mut opened = Model::new(model.session().clone());
    rest(&mut opened);
    assert!(opened.marks(Side::Target) == Some(marks) && opened.invariants(Side::Target).is_some());
    model.dispatch(Command::Continue, 0.0);
    rest(&mut model);
    assert_eq!(Side::BOTH.map(|side| model.marks(side)), [Some(marks); 2]);
}

#[test]
fn a_reshaped_outline_carries_its_marks() {
    let points = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)].map(DVec2::from).to_vec();
    let outline = OutlineSpec::points("L".into(), points.try_into().unwrap());
    let corners = [0.0, 0.25, 0.375, 0.75]; // at (0, 0), (2, 0), (2, 1), (0, 2)
    let mut model = marked(outline, corners);
    let places = |model: &Model| {
        let samples = model.domain(Side::Source).unwrap().samples().clone();
        model.marks(Side::Source).unwrap().map(|mark| samples.position(samples.at_fraction(mark)))
    };
    let axis = 2.0; // twice the mirror's
    let mut reshaping = Reshaping::new(Side::Source, &model);
    reshaping.change(Change::Mirror, &mut model).unwrap();
    rest(&mut model);
    let expected = [(2.0, 0.0), (0.0, 0.0), (0.0, 2.0), (2.0, 1.0)].map(|(x, y)| DVec2::new(axis - x, y));
    for (found, expected) in places(&model).into_iter().zip(expected) {
        assert!(found.distance(expected) < 1e-9, "{found}, not {expected}");
    }
    assert!(crate::conformal::Marks::new(model.marks(Side::Source).unwrap()).is_ok());
    reshaping.change(Change::Smooth, &mut model).unwrap();
    rest(&mut model);
    let first = places(&model)[1];
    assert!(first.distance(DVec2::new(axis, 0.0)) < 0.5, "{first}");
}

#[test]
fn a_file_is_made_of_the_grid_that_is_shown() {
    let (outline, marks) = preset(Preset::Disk, [0.0, 0.25, 0.5, 0.75]);
    let mut model = marked(outline, marks);
    model.act_on_grids(GridAction::Save(Side::Source, GridFormat::Csv));
    let GridWork::Begin(task) = model.next_grid_work(0.0) else { panic!("nothing to do") };
    let found = task.run(&mut |_| true).unwrap().unwrap();
    let file = model.accept_grid(&task, Finding::Grid(Box::new(found))).unwrap().unwrap();
    assert_eq!(file.name, "riemap_grid.csv");
    assert_eq!(String::from_utf8(file.bytes).unwrap().lines().count(), 1 + 15 * 15);
    model.act_on_grids(GridAction::Save(Side::Source, GridFormat::Obj));
    assert!(!model.gives_up_grid() && matches!(model.next_grid_work(0.0), GridWork::Begin(_)));
    model.act_on_grids(GridAction::Cancel(Side::Source));
    assert!(model.gives_up_grid() && model.next_grid_work(0.0) == GridWork::Nothing);
}
