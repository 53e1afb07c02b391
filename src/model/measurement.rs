//! The distortion of the map that is shown, measured at once or incrementally, frame by frame.

use crate::conformal::{ConformalMap, Quality, TriangleDistortion};
use crate::laplace::Deadline;
use web_time::Instant;

/// The last complete measurement, and the one in progress.
///
/// Invariants: quality and triangles belong to the same map, that of `generation`; `coming` belongs to the map of
/// `coming_generation` alone.
#[derive(Debug, Default)]
pub struct Measurement {
    quality: Option<Quality>,
    triangles: Vec<TriangleDistortion>,
    generation: u64,
    /// The results so far of the measurement in progress.
    coming: Vec<TriangleDistortion>,
    coming_generation: u64,
    milliseconds: f64,
    is_stale: bool,
}

impl Measurement {
    /// The summary.
    pub fn quality(&self) -> Option<Quality> {
        self.quality
    }

    /// The distortion of every triangle.
    pub fn triangles(&self) -> &[TriangleDistortion] {
        &self.triangles
    }

    /// The generation of the measured map.
    pub fn generation(&self) -> u64 {
        self.generation
    }

    /// How long the measurement took, in ms.
    pub fn milliseconds(&self) -> f64 {
        self.milliseconds
    }

    /// Whether the map has changed since.
    pub fn is_stale(&self) -> bool {
        self.is_stale
    }

    /// Marks the measurement as stale, because the map has changed.
    pub fn expire(&mut self) {
        self.is_stale = true;
    }

    /// Drops the results, because another mesh is mapped and they do not belong to its triangles.
    pub fn clear(&mut self) {
        self.triangles.clear();
        self.quality = None;
    }

    /// Restarts the measurement in progress.
    pub fn restart(&mut self) {
        self.coming.clear();
    }

    /// Continues with the map of a generation until `deadline` has passed; restarts if the measurement in progress is
    /// of another one.
    pub fn advance(&mut self, map: Option<&ConformalMap>, generation: u64, deadline: Deadline) {
        let start = Instant::now();
        if std::mem::replace(&mut self.coming_generation, generation) != generation {
            self.coming.clear();
        }
        let spent = if self.coming.is_empty() { 0.0 } else { self.milliseconds };
        if map.is_none_or(|map| map.advance_distortions(&mut self.coming, deadline)) {
            std::mem::swap(&mut self.triangles, &mut self.coming);
            self.coming.clear();
            self.quality = map.map(|map| Quality::summary(map.given(&self.triangles)));
            self.generation = generation;
            self.is_stale = false;
        }
        self.milliseconds = spent + start.elapsed().as_secs_f64() * 1e3;
    }

    /// Sets the duration of the measurement.
    #[cfg(test)]
    pub fn set_milliseconds(&mut self, milliseconds: f64) {
        self.milliseconds = milliseconds;
    }
}
