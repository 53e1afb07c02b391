//! Runs the steps of a long command one after the other, goes on after a
//! failure so that one run shows everything, and sums up at the end.

use crate::shell::Failure;
use std::time::{Duration, Instant};

/// What became of each step, in order.
#[derive(Default)]
pub struct Report {
    steps: Vec<Step>,
}

struct Step {
    name: String,
    outcome: Result<(), Failure>,
    took: Duration,
}

impl Report {
    /// Runs a step and notes how it ended; true if it passed.
    pub fn step(&mut self, name: &str, work: impl FnOnce() -> Result<(), Failure>) -> bool {
        let start = Instant::now();
        let outcome = work();
        let passed = outcome.is_ok();
        self.steps.push(Step { name: name.to_owned(), outcome, took: start.elapsed() });
        passed
    }

    /// Notes that a step could not run because of an earlier one. That is a failure too.
    pub fn not_run(&mut self, name: &str, reason: &str) {
        self.step(name, || Err(Failure::new("not run", reason)));
    }

    /// Prints one line for each step; a failure names all the steps that failed.
    pub fn finish(self, command: &str) -> Result<(), Failure> {
        eprintln!("\nxtask: {command}: summary");
        for step in &self.steps {
            let seconds = step.took.as_secs_f64();
            match &step.outcome {
                Ok(()) => eprintln!("  passed  {:<40} {seconds:7.1} s", step.name),
                Err(failure) => eprintln!("  FAILED  {:<40} {seconds:7.1} s  {failure}", step.name),
            }
        }
        let failed: Vec<&str> =
            self.steps.iter().filter(|step| step.outcome.is_err()).map(|step| step.name.as_str()).collect();
        if failed.is_empty() { Ok(()) } else { Err(Failure::new(command, failed.join(", "))) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_report_fails_with_the_names_of_the_steps_that_failed_or_could_not_run() {
        let mut report = Report::default();
        assert!(report.step("first", || Ok(())));
        assert!(!report.step("second", || Err(Failure::new("second", "broken"))));
        report.not_run("third", "second failed");
        let message = report.finish("test").err().map(|failure| failure.to_string());
        assert_eq!(message.as_deref(), Some("test: second, third"));
    }

    #[test]
    fn a_report_without_failures_passes() {
        let mut report = Report::default();
        report.step("only", || Ok(()));
        assert!(report.finish("test").is_ok());
    }
}
