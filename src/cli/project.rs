//! `riemap project`: the conformal map projection of least distortion for a region of the sphere.

use super::CliError;
use super::named_outline::read_file;
use super::output::{check_paths, print, write_all};
use super::progress::Progress;
use super::project_arguments::ProjectArguments;
use crate::counted::counted;
use crate::export::{ProjectionFormat, ProjectionReport};
use crate::geometry::DVec2;
use crate::outline::{GeoRing, MAX_BYTES, PartChoice, Reading, parse_geo_rings};
use crate::projection::{self, Projection, Region};
use std::path::{Path, PathBuf};

/// Computes the projection, writes the files and prints the summary.
pub fn run(arguments: &ProjectArguments) -> Result<(), CliError> {
    let formats = arguments.out.iter().map(|path| format_of(path)).collect::<Result<Vec<_>, _>>()?;
    check_paths(&arguments.out)?;
    let progress = Progress::new("reading");
    let refused = |error: &dyn std::fmt::Display| CliError::Input(format!("{}: {error}", arguments.region));
    let rings = match arguments.region.strip_prefix("preset:") {
        Some("island") => vec![GeoRing::new(projection::island()).named("Island")],
        Some(other) => {
            return Err(CliError::Input(format!("no region is built in by the name {other:?}: there is island")));
        }
        None => {
            let how = Reading { repair: arguments.repair, part: arguments.feature.as_deref().map(PartChoice::Called) };
            parse_geo_rings(&read_file(&arguments.region, MAX_BYTES)?, &how).map_err(|error| refused(&error))?
        }
    };
    for (ring, number) in rings.iter().zip(1..) {
        if let Some(cut) = ring.cut {
            let cut = counted!(cut, "a point was cut off", "{cut} points were cut off");
            eprintln!("riemap: {}: Ring {number} touched or crossed itself and was mended: {cut}.", arguments.region);
        }
    }
    let points: Vec<Vec<DVec2>> = rings.iter().map(|ring| ring.points.clone()).collect();
    let region = Region::new(&points).map_err(|error| refused(&error))?;
    progress.enter("the projection");
    let projection = Projection::new(region).map_err(|error| refused(&error))?;
    progress.enter("the files");
    let file = |(path, format): (&PathBuf, ProjectionFormat)| (path.clone(), format.text(&projection).into_bytes());
    let files: Vec<(PathBuf, Vec<u8>)> = arguments.out.iter().zip(formats).map(file).collect();
    write_all(&files)?;
    drop(progress);
    let stem = Path::new(&arguments.region).file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
    let report = ProjectionReport::new(stem, &rings, &projection);
    say_notes(&report, &arguments.region);
    if arguments.json {
        let text = serde_json::to_string_pretty(&report).map_err(|error| CliError::Input(error.to_string()))?;
        return print(&text);
    }
    print(&table(&report))
}

fn format_of(path: &Path) -> Result<ProjectionFormat, CliError> {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
    ProjectionFormat::from_extension(extension)
        .ok_or_else(|| CliError::Usage(format!("--out {}: the extension must be svg or csv", path.display())))
}

/// Prints to stderr what is not in the map, and what is in it twice.
fn say_notes(report: &ProjectionReport, path: &str) {
    let ProjectionReport { rings_left_out: left, holes_filled: holes, .. } = report;
    if *left > 0 {
        let share = 100.0 * report.share;
        let others = counted!(*left, "1 other boundary was left out", "{left} other boundaries were left out");
        eprintln!("riemap: {path}: The largest region was taken, {share:.1} % of the area; {others}.");
    }
    if report.rings.len() > 1 {
        eprintln!("riemap: {path}: {} rings were joined along the antimeridian.", report.rings.len());
    }
    if *holes > 0 {
        eprintln!("riemap: {path}: {}", counted!(*holes, "A hole was filled.", "{holes} holes were filled."));
    }
    if report.is_stereographic {
        eprintln!(
            "riemap: {path}: The best stereographic projection was taken: the map that was fitted to a constant scale along the boundary varies more."
        );
    }
    if let Some([longitude, latitude]) = report.overlap_at {
        eprintln!(
            "riemap: {path}: The map overlaps itself, at the boundary's longitude {longitude:.4}°, latitude {latitude:.4}° and elsewhere."
        );
    }
}

/// One line for each number.
fn table(report: &ProjectionReport) -> String {
    let [longitude, latitude] = report.least_scale_at;
    [
        format!("{:<16} {}", "region", report.name),
        format!(
            "{:<16} {} (the least possible is smaller by at most {:.1e})",
            "scale ratio", report.scale_ratio, report.scale_ratio_error
        ),
        format!("{:<16} {}", "stereographic", report.stereographic_scale_ratio),
        format!("{:<16} longitude {longitude:.4}°, latitude {latitude:.4}°", "least scale at"),
    ]
    .join("\n")
}
