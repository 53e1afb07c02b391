//! The distortion of the map that is shown, measured at once or a frame's share at a time.

use crate::conformal::{ConformalMap, Quality, TriangleDistortion};
use crate::laplace::Deadline;
use web_time::Instant;

/// What was measured last, and what is being measured.
///
/// Invariants: quality and triangles are of one map, that of `generation`; `coming` is of the map of
/// `coming_generation` alone.
#[derive(Debug, Default)]
pub struct Measurement {
    quality: Option<Quality>,
    triangles: Vec<TriangleDistortion>,
    generation: u64,
    /// What a measurement under way has come to.
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

    /// The generation of the map that was measured.
    pub fn generation(&self) -> u64 {
        self.generation
    }

    /// How long it took, in ms.
    pub fn milliseconds(&self) -> f64 {
        self.milliseconds
    }

    /// Whether the map has moved since.
    pub fn is_stale(&self) -> bool {
        self.is_stale
    }

    /// The map has moved.
    pub fn expire(&mut self) {
        self.is_stale = true;
    }

    /// Another mesh is mapped: nothing that was measured fits its triangles.
    pub fn clear(&mut self) {
        self.triangles.clear();
        self.quality = None;
    }

    /// Begins anew with what is under way.
    pub fn restart(&mut self) {
        self.coming.clear();
    }

    /// Goes on until `deadline` is over with the map of a generation, anew if what is under way is of another one.
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

    /// Takes a measurement to have taken this long.
    #[cfg(test)]
    pub fn set_milliseconds(&mut self, milliseconds: f64) {
        self.milliseconds = milliseconds;
    }
}
