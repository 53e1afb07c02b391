//! A warm-up computation for an idle web worker, whose result is discarded: a browser compiles a function on its first
//! call.

use super::{NamedFile, Request, SurfaceSource, Task};
use crate::conformal::SurfaceSettings;
use crate::surface::SurfacePreset;
use std::fmt::Write as _;
use std::sync::Arc;

/// The number of boundary vertices: the mesh has some thousand triangles, which exercise every step in a few
/// milliseconds.
const BOUNDARY: u32 = 120;

/// A request to prepare a surface from a small file: reading, checking, flips, assembly, ordering and factorization.
pub fn rehearsal() -> Request {
    let mut text = String::new();
    if let Ok(surface) = SurfacePreset::AnimalHead.surface(BOUNDARY) {
        for p in surface.vertices() {
            let _ = writeln!(text, "v {} {} {}", p.x, p.y, p.z);
        }
        for [a, b, c] in surface.triangles() {
            let _ = writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1);
        }
    }
    let file = NamedFile { name: "rehearsal.obj".into(), bytes: Arc::new(text.into_bytes()) };
    let source = SurfaceSource::File(file);
    Request {
        generation: 0,
        task: Task::Surface { source, repair: false, outline_loop: 0, settings: SurfaceSettings::default() },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::worker::{Response, run};

    #[test]
    #[allow(clippy::panic, reason = "tests")]
    fn a_rehearsal_leaves_no_step_out() {
        let mut last = None;
        run(&rehearsal(), &mut |_, response| last = Some(response));
        let Some(Response::Prepared(side, _)) = last else { panic!("{last:?}") };
        let surface = side.surface().unwrap_or_else(|| panic!("{side:?}"));
        assert!(surface.flips().flips > 0 && side.triangles().len() > 1000, "{:?}", surface.flips());
    }
}
