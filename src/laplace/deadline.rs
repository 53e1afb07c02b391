//! Deadlines for interruptible computations.

use web_time::{Duration, Instant};

/// A time, or none, that a computation checks between its steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Deadline(Option<Instant>);

impl Deadline {
    /// No deadline: the computation runs to completion.
    pub const NEVER: Self = Self(None);

    /// `ms` milliseconds from now: already passed if that is not positive, never if it is beyond the range of the
    /// clock.
    pub fn in_ms(ms: f64) -> Self {
        let wait = Duration::try_from_secs_f64(ms.max(0.0) * 1e-3).ok();
        Self(wait.and_then(|wait| Instant::now().checked_add(wait)))
    }

    /// Whether the deadline has passed. Cost: reading the clock, if there is a deadline.
    pub fn is_over(&self) -> bool {
        self.0.is_some_and(|end| Instant::now() >= end)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_comes_at_its_time() {
        assert!(Deadline::in_ms(0.0).is_over() && Deadline::in_ms(-1.0).is_over());
        assert!(!Deadline::in_ms(1e6).is_over() && !Deadline::NEVER.is_over());
        assert_eq!(Deadline::in_ms(f64::INFINITY), Deadline::NEVER);
    }
}
