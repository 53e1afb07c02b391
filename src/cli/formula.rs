//! `riemap formula`: a map between two outlines and its inverse as rational functions, in files of numbers or code.
//!
//! Exit status 0 also where fewer digits are reached than were asked for: the summary, the files and a warning on stderr
//! say how many. A function without any digit is left out; without both, the status is 1 and nothing
//! is written.

use super::CliError;
use super::formula_arguments::FormulaArguments;
use super::output::{check_paths, print, write_all};
use super::progress::Progress;
use super::side::{self, Asked, NamedSide, Reading, is_surface};
use crate::conformal::{ConformalMap, Constraints, MapSettings, PerSide};
use crate::export::{FormulaFile, FormulaFormat};
use crate::rational::{Formula, FormulaError};
use std::path::Path;
use std::sync::Arc;

/// Computes the formula, writes the files and prints the summary.
pub fn run(arguments: &FormulaArguments) -> Result<(), CliError> {
    let formats = arguments.out.iter().map(|path| format_of(path)).collect::<Result<Vec<_>, _>>()?;
    check_paths(&arguments.out)?;
    let progress = Progress::new("reading");
    let map = map(arguments, &progress)?;
    let refused = |error: FormulaError| CliError::Input(error.to_string());
    progress.enter("the formula");
    let formula = Formula::new(&map, arguments.digits, &mut reporting(&progress)).map_err(refused)?;
    let single = if formats.contains(&FormulaFormat::Glsl) {
        progress.enter("the formula in single precision");
        Some(Formula::single(&map, arguments.digits, &mut reporting(&progress)).map_err(refused)?)
    } else {
        None
    };
    progress.enter("writing");
    let names = PerSide::new(arguments.source.as_str(), arguments.target.as_str());
    let file = FormulaFile::new(names, arguments.digits, &formula);
    let encoded = |&format: &FormulaFormat| match (format, &single) {
        (FormulaFormat::Glsl, Some(single)) => FormulaFile::new(names, arguments.digits, single).text(format),
        _ => file.text(format),
    };
    let texts = formats.iter().map(|format| encoded(format).into_bytes());
    let files: Vec<_> = arguments.out.iter().cloned().zip(texts).collect();
    write_all(&files)?;
    drop(progress);
    let asked = [(arguments.digits, &formula)];
    let warned =
        asked.into_iter().chain(single.as_ref().map(|single| (single.digits_at_most(arguments.digits), single)));
    warned.for_each(|(digits, formula)| warn(formula, digits));
    print(&if arguments.json { file.summary_json() } else { file.summary() })
}

fn reporting(progress: &Progress) -> impl FnMut(f64) -> bool {
    |done| {
        progress.report(done);
        true
    }
}

fn format_of(path: &Path) -> Result<FormulaFormat, CliError> {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default().to_ascii_lowercase();
    FormulaFormat::of_extension(&extension).ok_or_else(|| {
        CliError::Usage(format!("--out {}: the extension must be json, py, jl, js or glsl", path.display()))
    })
}

/// The map, by the boundary integral.
fn map(arguments: &FormulaArguments, progress: &Progress) -> Result<ConformalMap, CliError> {
    let titles = arguments.titles();
    let asked = arguments.asked(&titles)?;
    if let Some(surface) = asked.iter().find(|side| is_surface(side.name)) {
        return Err(CliError::Usage(format!("{} is a surface; a formula is for two outlines", surface.title)));
    }
    asked.iter().try_for_each(Asked::check)?;
    let discretization = arguments.discretization();
    let reading = Reading {
        repair: arguments.reading.repair,
        intrinsic_delaunay: true,
        discretization: &discretization,
        subdivide: false,
    };
    let how = arguments.reading.each(&[asked[0].name, asked[1].name])?;
    let [first, second] = [side::read(asked[0].name, &how[0])?, side::read(asked[1].name, &how[1])?];
    let source = NamedSide::prepare(&asked[0], first, reading, progress)?;
    let target = NamedSide::prepare(&asked[1], second, reading, progress)?;
    let constraints = Constraints::new(source.constraint(&asked[0])?, target.constraint(&asked[1])?);
    progress.enter("the map");
    let sides = (Arc::clone(&source.prepared), Arc::clone(&target.prepared));
    let map = ConformalMap::new(sides.0, sides.1, &constraints, MapSettings::default());
    let map = map.map_err(|error| CliError::Input(error.to_string()))?;
    for side in [&source, &target] {
        side.say_notes(&discretization);
    }
    Ok(map)
}

/// Says on stderr which function has fewer digits than were asked for.
fn warn(formula: &Formula, digits: u32) {
    let reached = formula.reached(digits);
    let functions = [("f", reached.source, &formula.forward), ("the inverse of f", reached.target, &formula.inverse)];
    for (name, reached, fit) in functions {
        if reached.digits < digits {
            let precision = if formula.is_single { " in single precision" } else { "" };
            eprintln!("riemap: {name}{precision} reaches {} of {digits} digits", reached.digits);
            if fit.jump() > 0.0 {
                let arithmetic = if formula.is_single { "single" } else { "double" };
                eprintln!(
                    "riemap: points whose images under {name} are {:.1e} apart are one point in {arithmetic} precision",
                    fit.jump()
                );
            }
        }
        if !reached.is_boundary_exact {
            eprintln!("riemap: the boundary values of {name} may be off by {:.1e}", reached.boundary_error);
        }
    }
}
