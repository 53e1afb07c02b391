//! Longer computations besides the map: rows of the paper's tables, of its convergence figure, and of the plot of
//! accuracy.
//!
//! A study is requested row by row, so that finished rows can be shown and the others canceled.

use super::invariants::{FoundInvariants, InvariantsTask};
use crate::figures::{BenchRow, ConvergenceRow, ConvergenceStudy, Detail, FigureError, LadderRow, Measurement, Rung};
use crate::language::{Message, key};

/// One row of a study, or the invariants of an outline.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Study {
    /// A row of Table 1 or 2.
    Bench {
        /// The row to measure.
        row: BenchRow,
        /// The number of measurements.
        runs: usize,
    },
    /// A resolution of Figure 15.
    Convergence {
        /// The number of boundary samples of the V-shape.
        m: u32,
    },
    /// A method at one resolution on one outline of the plot of accuracy.
    Ladder {
        /// The row to measure.
        rung: Rung,
    },
    /// The conformal invariants of an outline.
    Invariants(Box<InvariantsTask>),
}

/// The result of a study.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Finding {
    /// A row of Table 1 or 2.
    Bench(Measurement),
    /// The four rows of one resolution.
    Convergence(Vec<ConvergenceRow>),
    /// A row of the plot of accuracy.
    Ladder(Box<LadderRow>),
    /// The conformal invariants of an outline.
    Invariants(Box<FoundInvariants>),
    /// Why there is no result.
    Failed(Message),
}

impl Study {
    /// Runs the study.
    pub fn run(&self) -> Finding {
        if let Self::Invariants(task) = self {
            return task.run().map_or_else(Finding::Failed, |found| Finding::Invariants(Box::new(found)));
        }
        self.try_run().unwrap_or_else(|error| Finding::Failed(Message::from(&error)))
    }

    fn try_run(&self) -> Result<Finding, FigureError> {
        Ok(match *self {
            Self::Bench { row, runs } => match row.measure(runs)? {
                Some(measurement) => Finding::Bench(measurement),
                None => Finding::Failed(key::no_such_row().into()),
            },
            Self::Invariants(_) => Finding::Failed(key::no_such_row().into()),
            Self::Ladder { rung } => Finding::Ladder(Box::new(rung.measure(1)?)),
            Self::Convergence { m } => Finding::Convergence(ConvergenceStudy::new(Detail::Paper)?.rows(m)?.to_vec()),
        })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests {
    use super::*;
    use crate::figures::{BenchSetting, LadderMethod, LadderShape};

    /// Findings are sent to another thread as text.
    #[test]
    fn findings_survive_as_text() {
        let rows = [
            BenchRow::Preparation { index: 0, setting: BenchSetting::Default },
            BenchRow::Frame { index: 0, setting: BenchSetting::Default },
        ];
        for row in rows {
            let finding = Study::Bench { row, runs: 1 }.run();
            assert!(matches!(finding, Finding::Bench(_)), "{finding:?}");
            let back: Finding = serde_json::from_str(&serde_json::to_string(&finding).unwrap()).unwrap();
            assert_eq!(back, finding);
        }
        let rung = Rung { shape: LadderShape::Disk, method: LadderMethod::AdjointDefault, resolution: 100 };
        let finding = Study::Ladder { rung }.run();
        assert!(matches!(&finding, Finding::Ladder(row) if row.rung == rung), "{finding:?}");
        assert_eq!(serde_json::from_str::<Finding>(&serde_json::to_string(&finding).unwrap()).unwrap(), finding);
        let psi = Finding::Bench(Measurement::PsiTable { psi_s: None });
        assert_eq!(serde_json::from_str::<Finding>(&serde_json::to_string(&psi).unwrap()).unwrap(), psi);
    }

    #[test]
    fn a_row_that_is_not_there_is_refused() {
        let row = BenchRow::Frame { index: 99, setting: BenchSetting::Default };
        assert!(matches!(Study::Bench { row, runs: 1 }.run(), Finding::Failed(_)));
    }
}
