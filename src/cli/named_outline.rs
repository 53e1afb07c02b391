//! Outlines named on the command line, by `preset:NAME` or as a file: reading and preparing them.

use super::CliError;
use super::discretization::InterpretArgument;
use crate::conformal::{KernelMode, PrepareError, PrepareSettings, PreparedSide, Stage, prepare, prepare_curve};
use crate::geometry::DVec2;
use crate::outline::{self, Interpreted, Outline, Preset};
use std::io::Read as _;
use std::str::FromStr as _;

/// An outline named on the command line.
pub struct NamedOutline {
    /// The outline.
    pub outline: Outline,
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

/// Reads at most `most` + 1 bytes of a file, so that the parser sees, and rejects, one with more than `most`.
pub fn read_file(name: &str, most: usize) -> Result<Vec<u8>, CliError> {
    let mut bytes = Vec::new();
    let read = std::fs::File::open(name).and_then(|file| file.take(most as u64 + 1).read_to_end(&mut bytes));
    read.map_err(|error| CliError::Input(format!("cannot read {name}: {error}")))?;
    Ok(bytes)
}

/// Reads `preset:NAME` or a file. With `repair`, loops and spikes of an outline are cut off and noted.
pub fn read_outline(name: &str, repair: bool) -> Result<NamedOutline, CliError> {
    if let Some(preset) = name.strip_prefix("preset:") {
        let preset = Preset::from_str(preset).map_err(|error| CliError::Input(error.to_string()))?;
        return Ok(NamedOutline { outline: preset.outline(), preset: Some(preset) });
    }
    let bytes = read_file(name, outline::MAX_BYTES)?;
    let parse = if repair { outline::parse_repaired } else { outline::parse };
    let outline = parse(name, &bytes).map_err(|error| CliError::Input(format!("{name}: {error}")))?;
    Ok(NamedOutline { outline, preset: None })
}
