//! `riemap project`: the conformal map projection of least distortion for a region of the sphere.

use super::CliError;
use super::named_outline::read_file;
use super::output::{check_paths, print, write_all};
use super::progress::Progress;
use super::project_arguments::ProjectArguments;
use crate::counted::counted;
use crate::export::ProjectionFormat;
use crate::geometry::DVec2;
use crate::outline::{GeoRing, MAX_BYTES, parse_geo_rings};
use crate::projection::{Projection, Region};
use std::path::{Path, PathBuf};

/// Computes the projection, writes the files and prints the summary.
pub fn run(arguments: &ProjectArguments) -> Result<(), CliError> {
    let formats = arguments.out.iter().map(|path| format_of(path)).collect::<Result<Vec<_>, _>>()?;
    check_paths(&arguments.out)?;
    let progress = Progress::new("reading");
    let refused = |error: &dyn std::fmt::Display| CliError::Input(format!("{}: {error}", arguments.region));
    let bytes = read_file(&arguments.region, MAX_BYTES)?;
    let rings = parse_geo_rings(&bytes).map_err(|error| refused(&error))?;
    let points: Vec<Vec<DVec2>> = rings.iter().map(|ring| ring.points.clone()).collect();
    let region = Region::new(&points).map_err(|error| refused(&error))?;
    progress.enter("the projection");
    let projection = Projection::new(region).map_err(|error| refused(&error))?;
    progress.enter("the files");
    let file = |(path, format): (&PathBuf, ProjectionFormat)| (path.clone(), format.text(&projection).into_bytes());
    let files: Vec<(PathBuf, Vec<u8>)> = arguments.out.iter().zip(formats).map(file).collect();
    write_all(&files)?;
    drop(progress);
    let report = Report::new(&arguments.region, &rings, &projection);
    report.say_notes(&arguments.region);
    if arguments.json {
        let text = serde_json::to_string_pretty(&report).map_err(|error| CliError::Input(error.to_string()))?;
        return print(&text);
    }
    print(&report.table())
}

fn format_of(path: &Path) -> Result<ProjectionFormat, CliError> {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
    ProjectionFormat::from_extension(extension)
        .ok_or_else(|| CliError::Usage(format!("--out {}: the extension must be svg or csv", path.display())))
}

/// The report of `--json`.
#[derive(Debug, serde::Serialize)]
struct Report {
    name: String,
    /// The largest scale over the least one, of the map as it is written.
    scale_ratio: f64,
    /// By how much the least possible ratio may be smaller.
    scale_ratio_error: f64,
    stereographic_scale_ratio: f64,
    /// Longitude and latitude of the center of that projection.
    stereographic_center: [f64; 2],
    /// Longitude and latitude of the point of least scale, where x = y = 0.
    least_scale_at: [f64; 2],
    /// The area on the unit sphere.
    area: f64,
    /// The rings that the region is made of, counted from 1 in the file's order.
    rings: Vec<usize>,
    /// The number of other boundaries, which were left out.
    rings_left_out: usize,
    /// The share of the region in the area of all.
    share: f64,
    holes_filled: usize,
    /// The largest |log k| on the boundary, where a constant scale has 0.
    residual: f64,
    /// Whether the map is the best stereographic projection, which varies less than the one that was fitted.
    is_stereographic: bool,
    /// Whether the map overlaps itself.
    overlaps: bool,
    /// Longitude and latitude of a boundary point where the image meets itself.
    overlap_at: Option<[f64; 2]>,
}

impl Report {
    fn new(path: &str, rings: &[GeoRing], projection: &Projection) -> Self {
        let selection = projection.region().selection();
        let taken: Vec<&GeoRing> = selection.rings.iter().filter_map(|number| rings.get(number - 1)).collect();
        let stem = Path::new(path).file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
        let name = taken.iter().find_map(|ring| ring.name.clone()).unwrap_or_else(|| stem.to_owned());
        let stereographic = projection.stereographic();
        let scale_ratio = projection.scale_ratio();
        Self {
            name,
            scale_ratio,
            scale_ratio_error: -scale_ratio * (-2.0 * projection.residual()).exp_m1(),
            stereographic_scale_ratio: stereographic.ratio,
            stereographic_center: stereographic.center.to_array(),
            least_scale_at: projection.least_scale_at().to_array(),
            area: projection.region().area(),
            rings: selection.rings.clone(),
            rings_left_out: selection.left_out,
            share: selection.share,
            holes_filled: selection.holes + taken.iter().map(|ring| ring.holes).sum::<usize>(),
            residual: projection.residual(),
            is_stereographic: projection.is_stereographic(),
            overlaps: projection.overlap().is_some(),
            overlap_at: projection.overlap().map(|at| at.to_array()),
        }
    }

    /// Prints to stderr what is not in the map, and what is in it twice.
    fn say_notes(&self, path: &str) {
        let Self { rings_left_out: left, holes_filled: holes, .. } = self;
        if *left > 0 {
            let share = 100.0 * self.share;
            let others = counted!(*left, "1 other boundary was left out", "{left} other boundaries were left out");
            eprintln!("riemap: {path}: The largest region was taken, {share:.1} % of the area; {others}.");
        }
        if self.rings.len() > 1 {
            eprintln!("riemap: {path}: {} rings were joined along the antimeridian.", self.rings.len());
        }
        if *holes > 0 {
            eprintln!("riemap: {path}: {}", counted!(*holes, "A hole was filled.", "{holes} holes were filled."));
        }
        if self.is_stereographic {
            eprintln!(
                "riemap: {path}: The best stereographic projection was taken: the map that was fitted to a constant scale along the boundary varies more."
            );
        }
        if let Some([longitude, latitude]) = self.overlap_at {
            eprintln!(
                "riemap: {path}: The map overlaps itself, at the boundary's longitude {longitude:.4}°, latitude {latitude:.4}° and elsewhere."
            );
        }
    }

    /// One line for each number.
    fn table(&self) -> String {
        let [longitude, latitude] = self.least_scale_at;
        [
            format!("{:<16} {}", "region", self.name),
            format!(
                "{:<16} {} (the least possible is smaller by at most {:.1e})",
                "scale ratio", self.scale_ratio, self.scale_ratio_error
            ),
            format!("{:<16} {}", "stereographic", self.stereographic_scale_ratio),
            format!("{:<16} longitude {longitude:.4}°, latitude {latitude:.4}°", "least scale at"),
        ]
        .join("\n")
    }
}
