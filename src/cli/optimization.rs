//! `--optimise CRITERION` of `riemap map` and `riemap flatten`: the best map of the family.

use super::CliError;
use super::named_outline::read_file;
use super::progress::Progress;
use crate::conformal::{Constraints, MapSettings, PerSide, PreparedSide};
use crate::geometry::{DVec2, SimplePolygon, Symmetries};
use crate::laplace::Deadline;
use crate::optimization::{Criterion, MOST_POLYGONS, Optimization, OptimizeError, Region, SharedSymmetries};
use crate::outline::{MAX_BYTES, OutlineError, Reading, parse, parse_geo_rings};
use std::str::FromStr;
use std::sync::Arc;
use std::time::Instant;

/// The option's name, for messages.
const OPTION: &str = "--optimise";

/// The time between two reports of the progress, in ms.
const REPORT_MS: f64 = 50.0;

/// What is minimized.
#[derive(Debug, clap::Args)]
pub struct OptimizeArguments {
    /// Of all conformal maps between the sides, take the best one, searched for from the one that is given: with the least
    /// mean (ln σ₁σ₂)² after the best scale, weighted by area (area); with the least ratio of local scales over 98 % of the
    /// area (scale); or as area within a region of the source (region:FILE: polygons in the plane, as a list of lists of
    /// points in JSON, as `GeoJSON`, or one outline in any format); or with the least deviation from the symmetries that two
    /// outlines share (symmetry).
    #[arg(long = "optimise", alias = "optimize", value_name = "area|scale|region:FILE|symmetry")]
    pub criterion: Option<OptimizeArgument>,
}

/// A criterion as it is named on the command line.
#[derive(Debug, Clone, PartialEq)]
pub enum OptimizeArgument {
    /// Area distortion.
    Area,
    /// The ratio of scales.
    Scale,
    /// Area distortion in the region of this file.
    Region(String),
    /// Kept symmetries.
    Symmetry,
}

impl FromStr for OptimizeArgument {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match (text, text.strip_prefix("region:")) {
            ("area", _) => Ok(Self::Area),
            ("scale", _) => Ok(Self::Scale),
            ("symmetry", _) => Ok(Self::Symmetry),
            (_, Some(file)) if !file.is_empty() => Ok(Self::Region(file.to_owned())),
            _ => Err("expected area, scale, region:FILE or symmetry".to_owned()),
        }
    }
}

impl OptimizeArgument {
    /// Checks that it fits the sides' kinds.
    pub fn check(&self, is_planar: PerSide<bool>) -> Result<(), CliError> {
        let text = match self {
            Self::Region(file) if !is_planar.source => {
                format!("region:{file}: a region's polygons lie in the plane, the source is a surface")
            }
            Self::Symmetry if !(is_planar.source && is_planar.target) => {
                "symmetry: symmetries are those of two outlines, and a side is a surface".to_owned()
            }
            _ => return Ok(()),
        };
        Err(CliError::Usage(format!("{OPTION} {text}")))
    }

    /// The criterion, with the region from its file or the symmetries of both outlines.
    pub fn criterion(&self, outlines: PerSide<Option<&SimplePolygon>>) -> Result<Criterion, CliError> {
        match (self, outlines.both()) {
            (Self::Area, _) => Ok(Criterion::Area),
            (Self::Scale, _) => Ok(Criterion::Scale),
            (Self::Region(file), _) => Ok(Criterion::Region(Arc::new(region(file)?))),
            (Self::Symmetry, Some(outlines)) => {
                let shared = SharedSymmetries::new(&outlines.map(Symmetries::of)).map_err(|error| refused(&error))?;
                Ok(Criterion::Symmetry(Arc::new(shared)))
            }
            (Self::Symmetry, None) => Err(refused(&OptimizeError::NoSharedSymmetry)),
        }
    }
}

fn refused(error: &OptimizeError) -> CliError {
    CliError::Input(format!("{OPTION}: {error}"))
}

/// The polygons of a file.
fn region(file: &str) -> Result<Region, CliError> {
    let refused = |error: &dyn std::fmt::Display| CliError::Input(format!("{OPTION} region: {file}: {error}"));
    let bytes = read_file(file, MAX_BYTES)?;
    let rings = match serde_json::from_slice::<Vec<Vec<[f64; 2]>>>(&bytes) {
        Ok(rings) => rings.into_iter().map(|ring| ring.into_iter().map(DVec2::from_array).collect()).collect(),
        Err(_) => geo_rings(file, &bytes),
    };
    if rings.is_empty() {
        let outline = parse(file, &bytes).map_err(|error: OutlineError| refused(&error))?;
        outline.notes().iter().for_each(|note| eprintln!("riemap: {file}: {note}"));
        return Ok(Region::of_polygons(vec![outline.into_polygon()]));
    }
    if rings.len() > MOST_POLYGONS {
        return Err(refused(&format!("it has {} polygons: up to {MOST_POLYGONS} can be given", rings.len())));
    }
    let polygon = |(k, ring): (usize, Vec<DVec2>)| {
        SimplePolygon::try_from(ring).map_err(|error| refused(&format!("polygon {}: {error}", k + 1)))
    };
    let polygons: Result<Vec<_>, CliError> = rings.into_iter().enumerate().map(polygon).collect();
    polygons.map(Region::of_polygons)
}

/// The outer rings of a `GeoJSON` file, with a note about holes; none of another file.
fn geo_rings(file: &str, bytes: &[u8]) -> Vec<Vec<DVec2>> {
    let rings = parse_geo_rings(bytes, &Reading::default()).unwrap_or_default();
    let holes: usize = rings.iter().map(|ring| ring.holes).sum();
    if holes > 0 {
        eprintln!("riemap: {file}: holes are left out: {holes}");
    }
    rings.into_iter().map(|ring| ring.points).collect()
}

/// What `--json` says of the search.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Optimized {
    criterion: &'static str,
    /// The criterion of the given map and of the best one.
    before: f64,
    after: f64,
    /// How often it was computed, and in which time.
    evaluations: usize,
    milliseconds: f64,
}

impl Optimized {
    /// In words, for the terminal.
    pub fn said(&self) -> String {
        let Self { criterion, before, after, evaluations, milliseconds } = self;
        format!("{criterion}: {before:.4} → {after:.4} ({evaluations} maps, {milliseconds:.0} ms)")
    }
}

/// Searches for the best map; returns its constraints.
pub fn optimized(
    sides: PerSide<Arc<PreparedSide>>,
    criterion: Criterion,
    start: Constraints,
    settings: MapSettings,
    progress: &Progress,
) -> Result<(Constraints, Optimized), CliError> {
    progress.enter("the best map");
    let begin = Instant::now();
    let mut search = Optimization::new(sides, criterion, start, settings);
    while !search.advance(Deadline::in_ms(REPORT_MS)).map_err(|error| refused(&error))? {
        progress.report(search.progress());
    }
    let found = search.found().ok_or_else(|| CliError::Input(format!("{OPTION}: no map was measured")))?;
    let outcome = Optimized {
        criterion: search.criterion().name(),
        before: found.before,
        after: found.after,
        evaluations: search.evaluations(),
        milliseconds: begin.elapsed().as_secs_f64() * 1e3,
    };
    Ok((found.constraints, outcome))
}
