//! `--repair` and `--repair=largest`: what a repair of a surface may drop.

use crate::surface::{RepairNote, Surface, SurfaceMesh};

/// What `--repair` may drop.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum RepairArgument {
    /// Up to a tenth of a surface's triangles.
    Safe,
    /// All of a surface but its largest part.
    Largest,
}

/// A safe repair drops no more than one triangle in this many.
const MOST_DROPPED: usize = 10;

/// The surface as a disk, repaired if asked for, with boundary loop number `outline` around it. Errors: it is no disk, or the
/// repair would drop more than is asked for.
pub fn disk(surface: &Surface, repair: Option<RepairArgument>, outline: usize) -> Result<SurfaceMesh, String> {
    let Some(repair) = repair else { return SurfaceMesh::new(surface).map_err(|error| error.to_string()) };
    let disk = SurfaceMesh::repaired_around(surface, outline).map_err(|error| error.to_string())?;
    let all = surface.triangles().len();
    for note in disk.repairs() {
        if let RepairNote::KeptLargest { components, dropped } = note
            && repair == RepairArgument::Safe
            && MOST_DROPPED * dropped > all
        {
            let kept = all - dropped;
            return Err(format!(
                "the largest of {components} parts has {kept} of {all} triangles: --repair=largest keeps it alone"
            ));
        }
    }
    Ok(disk)
}
