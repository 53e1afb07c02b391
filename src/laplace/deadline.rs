//! Until when a piece of work may go on before it lets its caller do something else.

use web_time::{Duration, Instant};

/// A moment, or none: work looks at it between its steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Deadline(Option<Instant>);

impl Deadline {
    /// The work goes on until it is done.
    pub const NEVER: Self = Self(None);

    /// In `ms` milliseconds from now: at once if that is not positive, never if it is beyond the clock.
    pub fn in_ms(ms: f64) -> Self {
        let wait = Duration::try_from_secs_f64(ms.max(0.0) * 1e-3).ok();
        Self(wait.and_then(|wait| Instant::now().checked_add(wait)))
    }

    /// Whether it has come. Cost: a look at the clock, if there is a deadline.
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
