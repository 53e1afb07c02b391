//! Runs the steps of a long command in sequence, continues after a
//! failure so that one run shows all of them, and prints a summary.

use crate::shell::Failure;
use std::time::{Duration, Instant};

/// The outcomes of the steps, in order.
#[derive(Default)]
pub struct Report {
    steps: Vec<Step>,
    left_out: Vec<LeftOut>,
}

struct Step {
    name: String,
    outcome: Result<(), Failure>,
    took: Duration,
}

/// Tests that were skipped for an acceptable reason.
struct LeftOut {
    reason: String,
    names: Vec<String>,
}

impl Report {
    /// Runs a step and records its outcome; returns whether it passed.
    pub fn step(&mut self, name: &str, work: impl FnOnce() -> Result<(), Failure>) -> bool {
        let start = Instant::now();
        let outcome = work();
        let passed = outcome.is_ok();
        self.steps.push(Step { name: name.to_owned(), outcome, took: start.elapsed() });
        passed
    }

    /// Records a step that could not run because of an earlier failure. It counts as a failure.
    pub fn not_run(&mut self, name: &str, reason: &str) {
        self.step(name, || Err(Failure::new("not run", reason)));
    }

    /// Records tests that were skipped for an acceptable reason; the summary lists them.
    pub fn left_out(&mut self, reason: &str, names: Vec<String>) {
        self.left_out.push(LeftOut { reason: reason.to_owned(), names });
    }

    /// Prints one line for each step, and the skipped tests. The error names all failed steps.
    pub fn finish(self, command: &str) -> Result<(), Failure> {
        eprintln!("\nxtask: {command}: summary");
        for step in &self.steps {
            let seconds = step.took.as_secs_f64();
            match &step.outcome {
                Ok(()) => eprintln!("  passed  {:<40} {seconds:7.1} s", step.name),
                Err(failure) => eprintln!("  FAILED  {:<40} {seconds:7.1} s  {failure}", step.name),
            }
        }
        for line in self.left_out.iter().flat_map(LeftOut::lines) {
            eprintln!("  {line}");
        }
        let failed: Vec<&str> =
            self.steps.iter().filter(|step| step.outcome.is_err()).map(|step| step.name.as_str()).collect();
        if failed.is_empty() { Ok(()) } else { Err(Failure::new(command, failed.join(", "))) }
    }
}

impl LeftOut {
    fn lines(&self) -> impl Iterator<Item = String> {
        let head = format!("did not run, because {}:", self.reason);
        let names = self.names.iter().map(|name| format!("  {name}"));
        std::iter::once(head).filter(|_| !self.names.is_empty()).chain(names)
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
    fn a_report_without_failures_passes_whatever_was_left_out() {
        let mut report = Report::default();
        report.step("only", || Ok(()));
        report.left_out("the data are absent", vec!["shared_data::maps".to_owned()]);
        let lines: Vec<String> = report.left_out.iter().flat_map(LeftOut::lines).collect();
        assert_eq!(lines, ["did not run, because the data are absent:", "  shared_data::maps"]);
        assert!(report.finish("test").is_ok());
    }
}
