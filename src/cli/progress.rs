//! How far a long stage is, on stderr.
//!
//! As everything on stderr, whole lines that begin with "riemap:". A stage that is soon done
//! says nothing; one that is not says at what percentage it is, at most every two seconds.

use std::time::{Duration, Instant};

/// From the beginning to the first line, and from line to line.
const PAUSE: Duration = Duration::from_secs(2);

/// The progress of one stage.
#[derive(Debug)]
pub struct Progress {
    stage: &'static str,
    said_at: Instant,
}

impl Progress {
    /// Of a stage that begins now.
    pub fn new(stage: &'static str) -> Self {
        Self { stage, said_at: Instant::now() }
    }

    /// Takes in the fraction that is done, and says it if it is time.
    pub fn report(&mut self, done: f64) {
        if let Some(line) = self.line(done, Instant::now()) {
            eprintln!("{line}");
        }
    }

    fn line(&mut self, done: f64, now: Instant) -> Option<String> {
        if now.duration_since(self.said_at) < PAUSE || done >= 1.0 {
            return None;
        }
        self.said_at = now;
        Some(format!("riemap: {}: {:.0} % done", self.stage, (100.0 * done).floor()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_stages_are_silent_and_long_ones_speak_every_two_seconds() {
        let mut progress = Progress::new("a stage");
        let start = progress.said_at;
        let mut line = |seconds: f64, done| progress.line(done, start + Duration::from_secs_f64(seconds));
        assert_eq!(line(1.9, 0.3), None);
        assert_eq!(line(2.0, 0.459).as_deref(), Some("riemap: a stage: 45 % done"));
        assert_eq!(line(3.9, 0.6), None);
        assert_eq!(line(4.1, 0.7).as_deref(), Some("riemap: a stage: 70 % done"));
        assert_eq!(line(9.0, 1.0), None, "it is done");
    }
}
