//! Outlines named on the command line, by `preset:NAME` or as a file: reading and preparing them.

use super::CliError;
use super::discretization::InterpretArgument;
use super::repair::RepairArgument;
use super::side::is_surface;
use crate::conformal::{KernelMode, PrepareError, PrepareSettings, PreparedSide, Stage, prepare, prepare_curve};
use crate::geometry::{DVec2, SimplePolygon};
use crate::outline::{self, Contents, Interpreted, Outline, PartChoice, Preset};
use std::io::Read as _;
use std::str::FromStr as _;

/// An outline named on the command line.
pub struct NamedOutline {
    /// The outline.
    pub outline: Outline,
    /// The points of its file in its order, or of the preset.
    pub vertices: Vec<DVec2>,
    /// The preset, if it is one.
    preset: Option<Preset>,
}

impl NamedOutline {
    /// The paper's number of samples, for presets used in the paper.
    pub fn paper_samples(&self) -> Option<u32> {
        self.preset.and_then(Preset::paper_samples)
    }

    /// Prepares the inside; with the boundary integral by its curve, and resolved from the points `near`.
    pub fn prepare(
        &self,
        near: &[DVec2],
        settings: &PrepareSettings,
        progress: &mut dyn FnMut(Stage),
    ) -> Result<PreparedSide, PrepareError> {
        let polygon = self.outline.polygon();
        let is_integral = settings.kernel == KernelMode::Integral;
        match is_integral.then(|| self.outline.curve()) {
            Some(Ok(curve)) => prepare_curve((polygon, curve.curve()), near, settings, progress),
            Some(Err(_)) | None => prepare(polygon, settings, progress),
        }
    }

    /// The same outline, interpreted as requested.
    #[must_use]
    pub fn interpreted(self, interpret: InterpretArgument) -> Self {
        Self { outline: self.outline.interpreted(interpret.into()), ..self }
    }

    /// What its points were taken for; `None` if not even its polygon is a curve, as with spikes of 1e-5. Says on stderr
    /// why many points stay a polygon.
    pub fn interpretation(&self, name: &str) -> Option<Interpreted> {
        match self.outline.curve() {
            Ok(curve) => {
                if let Some(reason) = curve.stays_polygon()
                    && self.outline.polygon().vertices().len() >= outline::LEAST_SMOOTH
                {
                    eprintln!("riemap: {name}: taken as a polygon: {reason}");
                }
                Some(curve.interpreted())
            }
            Err(error) => {
                eprintln!("riemap: {name}: taken as a polygon: {error}");
                None
            }
        }
    }

    /// Prints the reader's notes to stderr.
    pub fn say_notes(&self, name: &str) {
        for note in self.outline.notes() {
            eprintln!("riemap: {name}: {note}");
        }
    }
}

/// Where an outline is, for messages about points that are not inside it.
pub fn reach(polygon: &SimplePolygon) -> String {
    let [low, high] = polygon.bounds().corners();
    format!("; it reaches from ({}, {}) to ({}, {})", low.x, low.y, high.x, high.y)
}

/// Reads at most `most` + 1 bytes of a file, so that the parser sees, and rejects, one with more than `most`.
pub fn read_file(name: &str, most: usize) -> Result<Vec<u8>, CliError> {
    let mut bytes = Vec::new();
    let read = std::fs::File::open(name).and_then(|file| file.take(most as u64 + 1).read_to_end(&mut bytes));
    read.map_err(|error| CliError::Input(format!("cannot read {name}: {error}")))?;
    Ok(bytes)
}

/// How the files of outlines are read.
#[derive(Debug, Clone, clap::Args)]
pub struct ReadingArguments {
    /// Mend outlines that touch or cross themselves by cutting off small loops, spikes and knots, and make all safe repairs
    /// of surfaces, instead of refusing them. Where more than a tenth of a surface's triangles would be dropped with all but
    /// its largest part, that must be asked for by --repair=largest.
    #[arg(long, value_name = "largest", num_args = 0..=1, require_equals = true, default_missing_value = "safe")]
    pub repair: Option<RepairArgument>,
    /// Which shape of an SVG file is read, by the id of its path or its number, or which feature of a GeoJSON file, by its
    /// name or number [default: the largest]; may be given once for each file.
    #[arg(long = "shape", visible_alias = "feature", value_name = "ID|N")]
    pub parts: Vec<String>,
}

impl ReadingArguments {
    /// How this one is read. Errors: as [`Self::each`].
    pub fn one(&self, name: &str) -> Result<outline::Reading<'_>, CliError> {
        self.each(&[name]).map(|readings| readings[0])
    }

    /// How each of these is read. Errors: more parts are named than there are files of outlines.
    pub fn each<'a>(&'a self, names: &[&str]) -> Result<Vec<outline::Reading<'a>>, CliError> {
        let mut parts = self.parts.iter();
        let of = |name: &&str| {
            let is_file = !name.starts_with("preset:") && !is_surface(name);
            let part = if is_file { parts.next().map(|part| PartChoice::Called(part)) } else { None };
            outline::Reading { repair: self.repair.is_some(), part }
        };
        let readings = names.iter().map(of).collect();
        match parts.next() {
            None => Ok(readings),
            Some(part) => Err(CliError::Usage(format!("--shape {part}: there is no file of an outline for it"))),
        }
    }
}

/// Reads `preset:NAME` or a file.
pub fn read_outline(name: &str, how: &outline::Reading) -> Result<NamedOutline, CliError> {
    if let Some(preset) = name.strip_prefix("preset:") {
        let preset = Preset::from_str(preset).map_err(|error| CliError::Input(error.to_string()))?;
        let outline = preset.outline();
        return Ok(NamedOutline { vertices: outline.polygon().vertices().to_vec(), outline, preset: Some(preset) });
    }
    let bytes = read_file(name, outline::MAX_BYTES)?;
    let refused = |error: outline::OutlineError| CliError::Input(format!("{name}: {error}"));
    let Contents { outline, vertices, .. } = outline::parse_contents(name, &bytes, how).map_err(refused)?;
    Ok(NamedOutline { outline, vertices, preset: None })
}
