//! Longer computations besides the map: rows of the paper's tables and of its convergence figure.
//!
//! A study is requested row by row, so that finished rows can be shown and the others canceled.

use crate::figures::{BenchRow, ConvergenceRow, ConvergenceStudy, Detail, FigureError, Measurement};
use crate::language::{Message, key};

/// One row of a study.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
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
}

/// The result of a study.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Finding {
    /// A row of Table 1 or 2.
    Bench(Measurement),
    /// The four rows of one resolution.
    Convergence(Vec<ConvergenceRow>),
    /// Why there is no result.
    Failed(Message),
}

impl Study {
    /// Runs the study.
    pub fn run(self) -> Finding {
        self.try_run().unwrap_or_else(|error| Finding::Failed(Message::from(&error)))
    }

    fn try_run(self) -> Result<Finding, FigureError> {
        Ok(match self {
            Self::Bench { row, runs } => match row.measure(runs)? {
                Some(measurement) => Finding::Bench(measurement),
                None => Finding::Failed(key::no_such_row().into()),
            },
            Self::Convergence { m } => Finding::Convergence(ConvergenceStudy::new(Detail::Paper)?.rows(m)?.to_vec()),
        })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests {
    use super::*;
    use crate::figures::BenchSetting;

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
        let psi = Finding::Bench(Measurement::PsiTable { psi_s: None });
        assert_eq!(serde_json::from_str::<Finding>(&serde_json::to_string(&psi).unwrap()).unwrap(), psi);
    }

    #[test]
    fn a_row_that_is_not_there_is_refused() {
        let row = BenchRow::Frame { index: 99, setting: BenchSetting::Default };
        assert!(matches!(Study::Bench { row, runs: 1 }.run(), Finding::Failed(_)));
    }
}
