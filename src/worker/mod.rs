//! Requests to a worker and its responses: files to parse, preparations, studies.
//!
//! The engine has no side effects; it runs in a web worker, and natively on a thread. Every
//! message carries the generation of its request; the receiver drops stale ones.

mod file;
mod formula;
mod grid;
mod invariants;
mod packed;
mod projection;
mod rehearsal;
mod sketch;
mod study;
mod symmetry;
mod taken;
mod transfer;

pub use file::{FlatArchive, FlatOutline, NamedFile, Unread};
pub use formula::{FormulaTask, FoundFormula};
pub use grid::{FoundGrid, GridContent, GridTask};
pub use invariants::{FoundInvariants, InvariantsTask, Number, StudiedOutline};
pub use packed::{packed, unpacked};
pub use projection::{DrawnScale, Feature, FoundProjection, Land, ProjectionTask, RefusedProjection};
pub use rehearsal::rehearsal;
pub use sketch::{Place, Sketch};
pub use study::{Advance, Finding, Study};
pub use symmetry::FoundSymmetries;
pub use taken::{Corner, Taken};
pub use transfer::Transfer;

use crate::conformal::{
    BoundaryEquation, KernelMode, PrepareError, PrepareSettings, PreparedSide, Resampled, Stage, SurfaceSettings,
    Unsharpened, prepare, prepare_on_curve, prepare_surface,
};
use crate::geometry::{DVec2, SimplePolygon};
use crate::language::Message;
use crate::outline::{Contents, CurveForm, Outline, Parts};
use crate::session::OutlineSpec;
use crate::session::file::Archive;
use crate::surface::{Surface, SurfaceMesh, SurfacePreset, read_surface};

/// A request to read or to prepare something.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// Incremented with every request about the same side.
    pub generation: u64,
    /// What to do.
    pub task: Task,
}

impl Request {
    /// Whether the side to prepare is a surface.
    pub fn is_of_surface(&self) -> bool {
        matches!(self.task, Task::Surface { .. })
    }
}

/// A side to prepare, or a file to read.
#[derive(Debug, Clone, PartialEq)]
pub enum Task {
    /// The inside of an outline.
    Outline {
        /// The outline.
        outline: Box<Drawn>,
        /// How to discretize it.
        settings: PrepareSettings,
    },
    /// The integral equation of an outline that was prepared before with these settings.
    Equation {
        /// The outline.
        outline: Box<Drawn>,
        /// How it was discretized.
        settings: PrepareSettings,
        /// The interior point to resolve.
        point: DVec2,
    },
    /// The inside of an outline that was prepared before with these settings, with other samples of its boundary.
    Mesh {
        /// The samples.
        resampled: Box<Resampled>,
        /// How it was discretized.
        settings: PrepareSettings,
    },
    /// The inside of an outline that is parsed from a file first.
    OutlineFile {
        /// The file.
        file: NamedFile,
        /// The number of the shape or the feature that is meant, counted from 1; the largest if there is none.
        part: Option<usize>,
        /// How to discretize it.
        settings: PrepareSettings,
    },
    /// A session file, which is only read.
    SessionFile(NamedFile),
    /// A surface.
    Surface {
        /// Its triangles.
        source: SurfaceSource,
        /// Whether to make the safe repairs.
        repair: bool,
        /// The boundary loop that repairs do not fill, counted from 0 by falling length.
        outline_loop: u16,
        /// How to discretize it.
        settings: SurfaceSettings,
    },
}

/// An outline as far as a preparation needs it: its polygon, and how its curve is found.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawn {
    /// The polygon.
    pub polygon: SimplePolygon,
    /// How the curve is found.
    pub form: CurveForm,
}

impl From<&OutlineSpec> for Drawn {
    fn from(outline: &OutlineSpec) -> Self {
        match outline {
            OutlineSpec::Preset(preset) => Self::from(&preset.outline()),
            OutlineSpec::Points { polygon, form, .. } => Self { polygon: polygon.clone(), form: form.clone() },
        }
    }
}

impl From<&Outline> for Drawn {
    fn from(outline: &Outline) -> Self {
        Self { polygon: outline.polygon().clone(), form: outline.form().clone() }
    }
}

/// The source of a surface's triangles.
#[derive(Debug, Clone, PartialEq)]
pub enum SurfaceSource {
    /// A built-in surface, given by a formula.
    Preset {
        /// The name of the built-in surface.
        preset: SurfacePreset,
        /// The approximate number of boundary vertices.
        boundary: u32,
    },
    /// A file that is not read yet.
    File(NamedFile),
}

/// A message from the worker.
#[derive(Debug)]
pub enum Response {
    /// The start of a stage.
    Progress(Stage),
    /// The outline of a file is parsed; its inside is prepared next. With what else the file holds.
    Outline(Box<Outline>, Option<Parts>),
    /// What the points of an outline are taken for; it is prepared next.
    Taken(Box<Taken>),
    /// The session of a file is read, with its undo steps and the files that it uses.
    Session(Box<Archive>),
    /// The file could not be read.
    Unread(Unread),
    /// A side is done; with what the reader of a surface noticed.
    Prepared(Box<PreparedSide>, Vec<Message>),
    /// The integral equation of a side is factored, or why there is none.
    Equation(Box<Result<Transfer, Unsharpened>>),
    /// The preparation failed.
    Failed(Failure),
}

/// Why a side was not prepared.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Failure {
    /// The reason, for the user.
    pub text: Message,
    /// Whether safe repairs would turn the input into a surface that can be prepared.
    pub repairable: bool,
    /// What could not be prepared, with its faults marked.
    pub sketch: Option<Box<Sketch>>,
}

impl Failure {
    /// A failure that safe repairs cannot resolve.
    pub fn new<'a, E: ?Sized>(error: &'a E) -> Self
    where
        Message: From<&'a E>,
    {
        Self { text: error.into(), repairable: false, sketch: None }
    }
}

impl Response {
    /// Whether more responses to the same request follow.
    pub fn goes_on(&self) -> bool {
        matches!(self, Self::Progress(_) | Self::Outline(..) | Self::Taken(_))
    }
}

/// Processes `request`, emitting `(generation, response)`.
pub fn run(request: &Request, emit: &mut dyn FnMut(u64, Response)) {
    let answer = &mut |response| emit(request.generation, response);
    let last = match &request.task {
        Task::Outline { outline, settings } => prepared(outline, settings, answer),
        Task::Equation { outline, settings, point } => {
            answer(Response::Progress(Stage::Integral));
            Response::Equation(Box::new(outline.equation(*point, settings)))
        }
        Task::Mesh { resampled, settings } => {
            match resampled.prepare(settings, &mut |stage| answer(Response::Progress(stage))) {
                Ok(side) => Response::Prepared(Box::new(side), Vec::new()),
                Err(error) => Response::Failed(Failure::new(&error)),
            }
        }
        Task::OutlineFile { file, part, settings } => outline_file(file, *part, settings, answer),
        Task::SessionFile(file) => match file.archive() {
            Ok(archive) => Response::Session(Box::new(archive)),
            Err(unread) => Response::Unread(unread),
        },
        Task::Surface { source, repair, outline_loop, settings } => {
            let outline = repair.then_some(usize::from(*outline_loop));
            surface(source, outline, *settings, &mut |stage| answer(Response::Progress(stage)))
                .unwrap_or_else(Response::Failed)
        }
    };
    answer(last);
}

impl Drawn {
    /// Prepares the inside with finite elements; for the boundary integral, with samples on the curve.
    fn prepare(
        &self,
        settings: &PrepareSettings,
        answer: &mut dyn FnMut(Response),
    ) -> Result<PreparedSide, PrepareError> {
        if settings.kernel != KernelMode::Integral {
            return prepare(&self.polygon, settings, &mut |stage| answer(Response::Progress(stage)));
        }
        match self.form.curve(&self.polygon) {
            Ok(curve) => {
                answer(Response::Taken(Box::new(Taken::new(&self.polygon, &self.form, &curve))));
                let progress = &mut |stage| answer(Response::Progress(stage));
                prepare_on_curve((&self.polygon, curve.curve()), settings, progress)
            }
            Err(error) => {
                let progress = &mut |stage| answer(Response::Progress(stage));
                let side = prepare(&self.polygon, &settings.with_kernel(KernelMode::Adjoint), progress)?;
                Ok(side.with_equation(Err(error.into())))
            }
        }
    }

    /// Factors the integral equation.
    fn equation(&self, point: DVec2, settings: &PrepareSettings) -> Result<Transfer, Unsharpened> {
        let curve = self.form.curve(&self.polygon)?;
        BoundaryEquation::prepare((&self.polygon, curve.curve()), &[point], settings)
            .map(|equation| Transfer::from(&equation))
    }
}

fn prepared(outline: &Drawn, settings: &PrepareSettings, answer: &mut dyn FnMut(Response)) -> Response {
    match outline.prepare(settings, answer) {
        Ok(side) => Response::Prepared(Box::new(side), Vec::new()),
        Err(error) => Response::Failed(Failure::new(&error)),
    }
}

fn outline_file(
    file: &NamedFile,
    part: Option<usize>,
    settings: &PrepareSettings,
    answer: &mut dyn FnMut(Response),
) -> Response {
    answer(Response::Progress(Stage::Read));
    let Contents { outline, parts, .. } = match file.outline(part) {
        Ok(read) => read,
        Err(unread) => return Response::Unread(unread),
    };
    let drawn = Drawn::from(&outline);
    answer(Response::Outline(Box::new(outline), parts));
    prepared(&drawn, settings, answer)
}

impl SurfaceSource {
    /// The surface, read from the file or generated. Errors: with a text for the user.
    pub fn surface(&self) -> Result<Surface, Failure> {
        match self {
            Self::Preset { preset, boundary } => preset.surface(*boundary).map_err(|error| Failure::new(&error)),
            Self::File(file) => read_surface(&file.name, &file.bytes).map_err(|error| Failure::new(&error)),
        }
    }
}

/// Prepares a surface, repaired around its boundary loop number `outline` if there is one.
fn surface(
    source: &SurfaceSource,
    outline: Option<usize>,
    settings: SurfaceSettings,
    progress: &mut dyn FnMut(Stage),
) -> Result<Response, Failure> {
    progress(Stage::Read);
    let surface = source.surface()?;
    let repaired = outline.map(|outline| SurfaceMesh::repaired_around(&surface, outline));
    let disk = repaired.unwrap_or_else(|| SurfaceMesh::new(&surface)).map_err(|error| Failure {
        repairable: outline.is_none() && SurfaceMesh::repaired(&surface).is_ok(),
        sketch: Sketch::new(&surface, &error).map(Box::new),
        ..Failure::new(&error)
    })?;
    let notes = surface.notes().iter().map(Message::from).collect();
    drop(surface);
    let prepared = prepare_surface(disk, settings, progress);
    let prepared = prepared.map_err(|error| Failure::new(&error))?;
    Ok(Response::Prepared(Box::new(prepared), notes))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests {
    use super::*;
    use crate::conformal::{NotFlat, prepare_curve};
    use crate::language::key;
    use crate::outline::Preset;
    use std::sync::Arc;

    fn last(source: SurfaceSource, repair: bool) -> Response {
        let task = Task::Surface { source, repair, outline_loop: 0, settings: SurfaceSettings::default() };
        let mut answer = None;
        run(&Request { generation: 7, task }, &mut |generation, response| {
            assert_eq!(generation, 7);
            answer = Some(response);
        });
        answer.unwrap()
    }

    fn file(text: &str) -> SurfaceSource {
        SurfaceSource::File(NamedFile { name: "a.obj".into(), bytes: Arc::new(text.into()) })
    }

    #[test]
    fn a_file_becomes_a_prepared_surface_with_the_readers_notes() {
        let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
        let Response::Prepared(side, notes) = last(file(square), false) else { panic!() };
        assert_eq!(side.surface().unwrap().mesh().triangles().len(), 2);
        assert_eq!(notes, [key::surface_note_triangulated(1_u32)]);
    }

    #[test]
    fn an_outline_of_a_file_is_said_before_its_inside_is_prepared() {
        let file = NamedFile { name: "a.csv".into(), bytes: Arc::new(b"0,0\n1,0\n0,1\n".to_vec()) };
        let task = Task::OutlineFile { file: file.clone(), part: None, settings: PrepareSettings::default() };
        let mut answers = Vec::new();
        run(&Request { generation: 3, task }, &mut |_, response| answers.push(response));
        assert!(matches!(answers[0], Response::Progress(Stage::Read)) && answers[0].goes_on());
        assert!(
            matches!(&answers[1], Response::Outline(outline, None) if **outline == file.outline(None).unwrap().outline)
        );
        let last = answers.pop().unwrap();
        assert!(matches!(&last, Response::Prepared(side, _) if side.domain().is_some()) && !last.goes_on());
        assert!(answers.iter().all(Response::goes_on));
    }

    #[test]
    fn positions_of_dropped_vertices_survive_the_transfer() {
        let text = "v 9 8 7\nv 0 0 0\nv 1 0 0\nv 6 5 4\nv 1 1 0\nf 2 3 5\n";
        let Response::Prepared(side, _) = last(file(text), true) else { panic!() };
        let back = Transfer::try_from(&*side).unwrap().into_side().unwrap();
        let given = file(text).surface().unwrap();
        for side in [&*side, &back] {
            let surface = side.surface().unwrap().surface();
            assert_eq!(surface.origin_positions().collect::<Vec<_>>(), given.vertices());
            assert_eq!(surface.origin_count(), 5);
        }
    }

    #[test]
    fn a_side_and_then_its_equation_are_those_of_one_preparation() {
        let settings = PrepareSettings::default().with_kernel(KernelMode::Integral);
        for preset in [Preset::Square, Preset::Blob, Preset::Heart] {
            let outline = preset.outline();
            let drawn = Box::new(Drawn::from(&outline));
            let Response::Prepared(side, _) = only(Task::Outline { outline: drawn.clone(), settings }) else {
                panic!()
            };
            assert!(side.awaits_equation() && side.equation().is_none());
            let side = Transfer::try_from(&*side).unwrap().into_side().unwrap();
            assert!(side.awaits_equation());
            let point = side.domain().unwrap().default_point();
            let Response::Equation(flat) = only(Task::Equation { outline: drawn, settings, point }) else { panic!() };
            let curve = outline.curve().unwrap().into_curve();
            let equation = flat.unwrap().into_equation(&curve).unwrap();
            let side = side.with_equation(Ok(equation));
            let at_once = prepare_curve((outline.polygon(), &curve), &[point], &settings, &mut |_| ()).unwrap();
            let kernels = [&side, &at_once].map(|side| {
                let x = side.domain().unwrap().default_point();
                side.boundary_integral().unwrap().harmonic_measure(x).unwrap().pieces()
            });
            assert_eq!(kernels[0], kernels[1], "{preset:?}");
            assert_eq!(side.vertices(), at_once.vertices());
            assert_eq!(Transfer::try_from(&side), Err(NotFlat));
        }
    }

    #[test]
    fn why_there_is_no_equation_travels_with_the_side() {
        let settings = PrepareSettings::default().with_kernel(KernelMode::Integral);
        let corner = |k: u32| {
            let (angle, radius) = (f64::from(k) * std::f64::consts::TAU / 600.0, 1.0 + 0.1 * f64::from(k % 2));
            radius * DVec2::from_angle(angle)
        };
        let polygon = SimplePolygon::try_from((0..600).map(corner).collect::<Vec<_>>()).unwrap();
        let outline = Box::new(Drawn { polygon, form: CurveForm::default() });
        let Response::Prepared(side, _) = only(Task::Outline { outline, settings }) else { panic!() };
        let side = Transfer::try_from(&*side).unwrap().into_side().unwrap();
        let reason = side.unsharpened().unwrap().to_string();
        assert!(!side.awaits_equation() && reason.contains("unknowns"), "{reason}");
    }

    fn only(task: Task) -> Response {
        let mut answers = Vec::new();
        run(&Request { generation: 1, task }, &mut |_, response| answers.push(response));
        assert!(answers.iter().rev().skip(1).all(Response::goes_on));
        answers.pop().unwrap()
    }

    #[test]
    fn a_repair_is_offered_where_it_would_help_and_only_there() {
        let loose = "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 2 3 4\n";
        assert!(matches!(last(file(loose), false), Response::Prepared(..)));
        let apart = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 5 0 0\nv 6 0 0\nv 6 1 0\nf 1 2 3\nf 4 5 6\n";
        let Response::Failed(failure) = last(file(apart), false) else { panic!() };
        assert!(failure.repairable, "{failure:?}");
        assert_eq!(failure.text.key(), "topology_components");
        assert_eq!(failure.sketch.map(|sketch| sketch.edges.len()), Some(3), "the second triangle is marked");
        assert!(matches!(last(file(apart), true), Response::Prepared(..)));
        let closed = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
        let Response::Failed(failure) = last(file(closed), false) else { panic!() };
        assert!(!failure.repairable && failure.text.key() == key::topology_closed(0_u32).key(), "{failure:?}");
        assert!(matches!(last(file("f 1 2"), false), Response::Failed(_)));
    }
}
