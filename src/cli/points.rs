//! `riemap map A B --points FILE`: the map and its derivative at given points, as a table.

use super::CliError;
use super::output::Format;
use super::progress::Progress;
use crate::conformal::{ConformalMap, InteriorImage, Side};
use crate::geometry::DVec2;
use crate::outline::parse_points;
use std::fmt::Write as _;
use std::path::PathBuf;

/// The arguments about points.
#[derive(Debug, clap::Args)]
pub struct PointsArguments {
    /// Evaluate the map at the points of this table (rows x,y, of the source): an --out with the extension csv then gets
    /// rows x,y,u,v,re,im,error,status: the image (u, v), the derivative re + i im, an estimate of the error of (u, v),
    /// and inside, boundary or outside; outside, numbers are empty.
    #[arg(long, value_name = "FILE")]
    pub points: Option<PathBuf>,
    /// The points are of the target, and the inverse map is evaluated.
    #[arg(long, requires = "points")]
    pub inverse: bool,
}

/// Points at which to evaluate the map.
#[derive(Debug)]
pub struct Points {
    places: Vec<DVec2>,
    from: Side,
}

const HEADER: &str = "x,y,u,v,re,im,error,status\n";

impl PointsArguments {
    /// Reads the points, if any are given.
    pub fn read(&self, out: &[PathBuf]) -> Result<Option<Points>, CliError> {
        let Some(path) = &self.points else { return Ok(None) };
        if !out.iter().any(|path| matches!(Format::of(path), Ok(Format::Csv))) {
            return Err(CliError::Usage("--points writes a table: --out FILE.csv is missing".to_owned()));
        }
        let bytes =
            std::fs::read(path).map_err(|error| CliError::Input(format!("cannot read {}: {error}", path.display())))?;
        let places = parse_points(&bytes).map_err(|error| CliError::Input(format!("{}: {error}", path.display())))?;
        Ok(Some(Points { places, from: if self.inverse { Side::Target } else { Side::Source } }))
    }
}

impl Points {
    /// The table of their images.
    pub fn table(&self, map: &ConformalMap, progress: &Progress) -> Result<String, CliError> {
        progress.enter("the points");
        let interior = map.interior_map(self.from).map_err(|error| CliError::Input(format!("--points: {error}")))?;
        if interior.is_polygonal() {
            eprintln!("riemap: --points: with finite elements on a side, images have 2 to 3 digits");
        }
        let mut text = HEADER.to_owned();
        for (k, &z) in self.places.iter().enumerate() {
            progress.report(k as f64 / self.places.len() as f64);
            put_row(&mut text, z, interior.image(z));
        }
        Ok(text)
    }
}

/// Writes a row; numbers that there are not are empty.
fn put_row(text: &mut String, z: DVec2, image: InteriorImage) {
    let (value, derivative, error, status) = match image {
        InteriorImage::Inside(found) => (Some(found.value), Some(found.derivative), Some(found.error), "inside"),
        InteriorImage::Boundary { value, derivative, error } => (Some(value), derivative, Some(error), "boundary"),
        InteriorImage::Outside => (None, None, None, "outside"),
    };
    let _ = write!(text, "{},{}", z.x, z.y);
    for pair in [value, derivative] {
        let _ = match pair {
            Some(pair) => write!(text, ",{},{}", pair.x, pair.y),
            None => write!(text, ",,"),
        };
    }
    let _ = match error {
        Some(error) => write!(text, ",{error:e}"),
        None => write!(text, ","),
    };
    let _ = writeln!(text, ",{status}");
}
