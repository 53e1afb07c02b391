//! Output: text on the terminal, and files that are written completely or not at all.

use super::CliError;
use crate::conformal::{PreparedSide, Quality};
use crate::counted::counted;
use crate::laplace::SolverKind;
use crate::outline::{Interpretation, Interpreted};
use std::io::Write as _;
use std::path::{Path, PathBuf};

/// For example "1 triangle", "960 triangles".
pub fn triangles(count: usize) -> String {
    counted!(count, "1 triangle", "{count} triangles")
}

/// For example "1 edge flipped", "7 edges flipped".
pub fn edges_flipped(count: usize) -> String {
    counted!(count, "1 edge flipped", "{count} edges flipped")
}

/// For example "mean Q = 1.0423, 0 flipped, 2 collapsed (0.02 % of the area)".
pub fn quality_in_words(quality: &Quality) -> String {
    let Quality { flipped, collapsed, collapsed_area, .. } = *quality;
    let share = if collapsed > 0 { format!(" ({:.2} % of the area)", 100.0 * collapsed_area) } else { String::new() };
    format!("{}, {flipped} flipped, {collapsed} collapsed{share}", mean_in_words(quality))
}

/// For example "mean Q = 1.0423", or that it is not resolved.
pub fn mean_in_words(quality: &Quality) -> String {
    quality.resolved_mean().map_or_else(|| String::from("mean Q is not resolved"), |mean| format!("mean Q = {mean:.4}"))
}

/// The formats of `riemap map --out`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs, reason = "the variants are the extensions")]
pub enum Format {
    Json,
    Csv,
    Obj,
    Ply,
    Glb,
    Svg,
    Png,
}

impl Format {
    /// The format of a file's extension.
    pub fn of(path: &Path) -> Result<Self, CliError> {
        let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default().to_ascii_lowercase();
        match extension.as_str() {
            "json" => Ok(Self::Json),
            "csv" => Ok(Self::Csv),
            "obj" => Ok(Self::Obj),
            "ply" => Ok(Self::Ply),
            "glb" => Ok(Self::Glb),
            "svg" => Ok(Self::Svg),
            "png" => Ok(Self::Png),
            _ => Err(CliError::Usage(format!(
                "--out {}: the extension must be json, csv, obj, ply, glb, svg or png",
                path.display()
            ))),
        }
    }
}

/// Rejects folders, and paths that are given twice.
pub fn check_paths(paths: &[PathBuf]) -> Result<(), CliError> {
    for (k, path) in paths.iter().enumerate() {
        if paths[..k].contains(path) {
            return Err(CliError::Usage(format!("--out {} is given twice", path.display())));
        }
        if path.is_dir() {
            return Err(CliError::Input(format!("cannot write {}: it is a folder", path.display())));
        }
    }
    Ok(())
}

/// Prints to stdout. A closed pipe (`| head`) is not an error.
pub fn print(text: &str) -> Result<(), CliError> {
    match writeln!(std::io::stdout().lock(), "{text}") {
        Err(source) if source.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(CliError::Write { path: "to stdout".to_owned(), source })
        }
        _ => Ok(()),
    }
}

/// Warns on stderr if the mesh refinement was not completed.
pub fn warn_if_coarse(name: &str, side: &PreparedSide) {
    if side.domain().is_some_and(|domain| !domain.refinement().complete) {
        eprintln!("riemap: {name}: the mesh was not refined to the end; some angles are below 20°");
    }
}

/// Writes all files, each first under a temporary name in the same folder, then renames them. If one cannot be
/// written, none of the others appears.
pub fn write_all(files: &[(PathBuf, Vec<u8>)]) -> Result<(), CliError> {
    let mut written: Vec<PathBuf> = Vec::new();
    let result = files.iter().try_for_each(|(path, bytes)| {
        let temporary = temporary_name(path);
        written.push(temporary.clone());
        std::fs::write(&temporary, bytes).map_err(|source| write_error(path, source))
    });
    let result = result.and_then(|()| {
        files.iter().zip(&written).try_for_each(|((path, _), temporary)| {
            std::fs::rename(temporary, path).map_err(|source| write_error(path, source))
        })
    });
    if result.is_err() {
        for temporary in &written {
            let _ = std::fs::remove_file(temporary); // best effort: it may not exist
        }
    }
    result
}

fn write_error(path: &Path, source: std::io::Error) -> CliError {
    CliError::Write { path: path.display().to_string(), source }
}

fn temporary_name(path: &Path) -> PathBuf {
    let mut name = path.file_name().unwrap_or_default().to_os_string();
    name.push(format!(".{}.part", std::process::id()));
    path.with_file_name(name)
}

/// Reports on stderr if the boundary integral was requested for a side but finite elements are used.
pub fn say_kernel(name: &str, side: &PreparedSide) {
    if let Some(reason) = side.unsharpened() {
        eprintln!("riemap: {name}: computed with finite elements instead of the boundary integral: {reason}");
    }
}

/// Reports on stderr if the domain uses another solver than the requested one.
pub fn say_solver(name: &str, wanted: SolverKind, used: SolverKind) {
    if used != wanted {
        eprintln!("riemap: {name}: the Cholesky factor does not fit into memory: solved iteratively, more slowly");
    }
}

/// An interpretation in words: "smooth, 2 corners".
pub fn words(interpreted: Interpreted) -> String {
    let corners = interpreted.corners;
    let corners = counted!(corners, "1 corner", "{corners} corners");
    let kind = if interpreted.interpretation == Interpretation::Smooth { "smooth" } else { "polygon" };
    format!("{kind}, {corners}")
}
