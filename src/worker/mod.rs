//! Requests to a worker and its responses: files to parse, preparations, studies.
//!
//! The engine has no side effects; it runs in a web worker, and natively on a thread. Every
//! message carries the generation of its request; the receiver drops stale ones.

mod file;
mod invariants;
mod rehearsal;
mod study;
mod transfer;

pub use file::{FlatOutline, FlatSession, NamedFile, Unread};
pub use invariants::{FoundInvariants, InvariantsTask, Number, StudiedOutline};
pub use rehearsal::rehearsal;
pub use study::{Finding, Study};
pub use transfer::Transfer;

use crate::conformal::{
    KernelMode, NotFlat, PrepareSettings, PreparedSide, Stage, SurfaceSettings, prepare, prepare_surface,
};
use crate::geometry::SimplePolygon;
use crate::language::Message;
use crate::outline::Outline;
use crate::session::Session;
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
        polygon: SimplePolygon,
        /// How to discretize it.
        settings: PrepareSettings,
    },
    /// The inside of an outline that is parsed from a file first.
    OutlineFile {
        /// The file.
        file: NamedFile,
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
        /// How to discretize it.
        settings: SurfaceSettings,
    },
}

impl Task {
    /// Whether the boundary integral is requested, whose factor does not cross to the app.
    fn needs_integral(&self) -> bool {
        let kernel = match self {
            Self::Outline { settings, .. } | Self::OutlineFile { settings, .. } => settings.kernel,
            Self::Surface { settings, .. } => settings.kernel,
            Self::SessionFile(_) => return false,
        };
        kernel == KernelMode::Integral
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
    /// The outline of a file is parsed; its inside is prepared next.
    Outline(Box<Outline>),
    /// The session of a file is read.
    Session(Box<Session>),
    /// The file could not be read.
    Unread(Unread),
    /// A side is done; with what the reader of a surface noticed.
    Prepared(Box<PreparedSide>, Vec<Message>),
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
}

impl Failure {
    /// A failure that safe repairs cannot resolve.
    pub fn new<'a, E: ?Sized>(error: &'a E) -> Self
    where
        Message: From<&'a E>,
    {
        Self { text: error.into(), repairable: false }
    }
}

impl Response {
    /// Whether more responses to the same request follow.
    pub fn goes_on(&self) -> bool {
        matches!(self, Self::Progress(_) | Self::Outline(_))
    }
}

/// Processes `request`, emitting `(generation, response)`.
pub fn run(request: &Request, emit: &mut dyn FnMut(u64, Response)) {
    let answer = &mut |response| emit(request.generation, response);
    if request.task.needs_integral() {
        return answer(Response::Failed(Failure::new(&NotFlat)));
    }
    let last = match &request.task {
        Task::Outline { polygon, settings } => outline(polygon, settings, answer),
        Task::OutlineFile { file, settings } => outline_file(file, settings, answer),
        Task::SessionFile(file) => match file.session() {
            Ok(session) => Response::Session(Box::new(session)),
            Err(unread) => Response::Unread(unread),
        },
        Task::Surface { source, repair, settings } => {
            surface(source, *repair, *settings, &mut |stage| answer(Response::Progress(stage)))
                .unwrap_or_else(Response::Failed)
        }
    };
    answer(last);
}

fn outline(polygon: &SimplePolygon, settings: &PrepareSettings, answer: &mut dyn FnMut(Response)) -> Response {
    match prepare(polygon, settings, &mut |stage| answer(Response::Progress(stage))) {
        Ok(side) => Response::Prepared(Box::new(side), Vec::new()),
        Err(error) => Response::Failed(Failure::new(&error)),
    }
}

fn outline_file(file: &NamedFile, settings: &PrepareSettings, answer: &mut dyn FnMut(Response)) -> Response {
    answer(Response::Progress(Stage::Read));
    let read = match file.outline() {
        Ok(read) => read,
        Err(unread) => return Response::Unread(unread),
    };
    answer(Response::Outline(Box::new(read.clone())));
    outline(read.polygon(), settings, answer)
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

fn surface(
    source: &SurfaceSource,
    repair: bool,
    settings: SurfaceSettings,
    progress: &mut dyn FnMut(Stage),
) -> Result<Response, Failure> {
    progress(Stage::Read);
    let surface = source.surface()?;
    let disk = if repair { SurfaceMesh::repaired(&surface) } else { SurfaceMesh::new(&surface) };
    let disk = disk.map_err(|error| Failure {
        repairable: !repair && SurfaceMesh::repaired(&surface).is_ok(),
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
    use crate::language::key;
    use std::sync::Arc;

    fn last(source: SurfaceSource, repair: bool) -> Response {
        let task = Task::Surface { source, repair, settings: SurfaceSettings::default() };
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
        let task = Task::OutlineFile { file: file.clone(), settings: PrepareSettings::default() };
        let mut answers = Vec::new();
        run(&Request { generation: 3, task }, &mut |_, response| answers.push(response));
        assert!(matches!(answers[0], Response::Progress(Stage::Read)) && answers[0].goes_on());
        assert!(matches!(&answers[1], Response::Outline(outline) if **outline == file.outline().unwrap()));
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
    fn the_integral_kernel_is_refused_and_never_dropped() {
        let settings = PrepareSettings::default().with_kernel(KernelMode::Integral);
        let polygon = crate::outline::Preset::Square.outline().into_polygon();
        let side = prepare(&polygon, &settings, &mut |_| ()).unwrap();
        assert!(side.curve_boundary().is_some());
        assert_eq!(Transfer::try_from(&side), Err(NotFlat));
        let task = Task::Outline { polygon, settings };
        let mut answers = Vec::new();
        run(&Request { generation: 1, task }, &mut |_, response| answers.push(response));
        let [Response::Failed(failure)] = answers.as_slice() else { panic!("{answers:?}") };
        assert_eq!(*failure, Failure::new(&NotFlat));
    }

    #[test]
    fn a_repair_is_offered_where_it_would_help_and_only_there() {
        let loose = "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 2 3 4\n";
        let Response::Failed(failure) = last(file(loose), false) else { panic!() };
        assert!(failure.repairable && failure.text == key::topology_unreferenced(1_u32, 0_u32), "{failure:?}");
        assert!(matches!(last(file(loose), true), Response::Prepared(..)));
        let closed = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
        let Response::Failed(failure) = last(file(closed), false) else { panic!() };
        assert!(!failure.repairable && failure.text.key() == key::topology_closed(0_u32).key(), "{failure:?}");
        assert!(matches!(last(file("f 1 2"), false), Response::Failed(_)));
    }
}
