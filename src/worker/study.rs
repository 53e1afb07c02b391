//! Longer computations beside the map: rows of the paper's tables, of its convergence figure.
//!
//! A study is asked for row by row, so that what is there can be shown and the rest dropped.

use crate::figures::{BenchRow, ConvergenceRow, ConvergenceStudy, Detail, FigureError, Measurement};
use crate::language::{Message, key};

/// One row of a study.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Study {
    /// Of Table 1 or 2.
    Bench {
        /// Which one.
        row: BenchRow,
        /// How often it is measured.
        runs: usize,
    },
    /// Of Figure 15.
    Convergence {
        /// Boundary samples of the V-shape.
        m: u32,
    },
}

/// What came out.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Finding {
    /// A row of Table 1 or 2.
    Bench(Measurement),
    /// The four rows of one resolution.
    Convergence(Vec<ConvergenceRow>),
    /// Why there is nothing.
    Failed(Message),
}

impl Study {
    /// Carries it out.
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

    /// Findings cross to another thread as text.
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
