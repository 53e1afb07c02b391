//! Longer computations besides the map: rows of the paper's tables, of its convergence figure, and of the plot of
//! accuracy; the invariants and the symmetries of an outline; the formula of a map; orthogonal grids; map projections.
//!
//! A study is requested row by row, so that finished rows can be shown and the others canceled.

use super::formula::{FormulaTask, FoundFormula};
use super::grid::{FoundGrid, GridTask};
use super::invariants::{FoundInvariants, InvariantsTask, StudiedOutline};
use super::projection::{FoundProjection, ProjectionTask, RefusedProjection};
use super::symmetry::FoundSymmetries;
use crate::figures::{BenchRow, ConvergenceRow, ConvergenceStudy, Detail, FigureError, LadderRow, Measurement, Rung};
use crate::language::{Message, key};

/// One row of a study, or what its worker computes as a whole.
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
    /// The symmetries of an outline.
    Symmetry(Box<StudiedOutline>),
    /// The file of a map as a formula.
    Formula(Box<FormulaTask>),
    /// The orthogonal grid of a marked outline.
    Grid(Box<GridTask>),
    /// The map projection of a region.
    Projection(Box<ProjectionTask>),
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
    Ladder(#[serde(with = "ladder_row")] Box<LadderRow>),
    /// The conformal invariants of an outline.
    Invariants(Box<FoundInvariants>),
    /// The symmetries of an outline.
    Symmetry(Box<FoundSymmetries>),
    /// The file of a map as a formula.
    Formula(Box<FoundFormula>),
    /// The orthogonal grid of a marked outline.
    Grid(Box<FoundGrid>),
    /// The map projection of a region.
    Projection(Box<FoundProjection>),
    /// Why there is no map projection.
    NoProjection(Box<RefusedProjection>),
    /// The share that is done; more findings of the same study follow.
    Progress(f64),
    /// Why there is no result.
    Failed(Message),
}

/// A row of the plot of accuracy as a list: as JSON its parts are flattened.
mod ladder_row {
    use crate::figures::LadderRow;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    #[derive(Serialize, Deserialize)]
    struct Parts(crate::figures::Rung, [usize; 2], crate::figures::Errors, Option<crate::figures::Errors>, [f64; 2]);

    pub fn serialize<S: Serializer>(row: &LadderRow, serializer: S) -> Result<S::Ok, S::Error> {
        let durations = [row.prepare_ms, row.point_ms];
        Parts(row.rung, [row.m, row.unknowns], row.omega, row.image, durations).serialize(serializer)
    }

    pub fn deserialize<'a, D: Deserializer<'a>>(deserializer: D) -> Result<Box<LadderRow>, D::Error> {
        let Parts(rung, [m, unknowns], omega, image, [prepare_ms, point_ms]) = Parts::deserialize(deserializer)?;
        Ok(Box::new(LadderRow { rung, m, unknowns, omega, image, prepare_ms, point_ms }))
    }
}

impl Finding {
    /// Whether more findings of the same study follow.
    pub fn goes_on(&self) -> bool {
        matches!(self, Self::Progress(_))
    }
}

/// The least difference of two shares that are sent.
const LEAST_ADVANCE: f64 = 0.01;

/// Selects the shares of progress that are worth sending: ascending, and at most a hundred.
#[derive(Debug, Default)]
pub struct Advance(f64);

impl Advance {
    /// Whether the share is larger than the last selected one by a hundredth.
    pub fn selects(&mut self, done: f64) -> bool {
        let selects = done >= self.0 + LEAST_ADVANCE;
        if selects {
            self.0 = done;
        }
        selects
    }
}

impl Study {
    /// Runs the study. A formula, a grid and a projection call `report` with the share that is done, which may also fall,
    /// and end if that returns false; then there is no finding.
    pub fn run(&self, report: &mut dyn FnMut(f64) -> bool) -> Option<Finding> {
        Some(match self {
            Self::Invariants(task) => {
                task.run().map_or_else(Finding::Failed, |found| Finding::Invariants(Box::new(found)))
            }
            Self::Symmetry(outline) => {
                outline.symmetries().map_or_else(Finding::Failed, |found| Finding::Symmetry(Box::new(found)))
            }
            Self::Formula(task) => match task.run(report) {
                Ok(found) => Finding::Formula(Box::new(found?)),
                Err(reason) => Finding::Failed(reason),
            },
            Self::Grid(task) => match task.run(report) {
                Ok(found) => Finding::Grid(Box::new(found?)),
                Err(reason) => Finding::Failed(reason),
            },
            Self::Projection(task) => match task.run(report) {
                Ok(found) => Finding::Projection(Box::new(found?)),
                Err(refused) => Finding::NoProjection(refused),
            },
            _ => self.try_run().unwrap_or_else(|error| Finding::Failed(Message::from(&error))),
        })
    }

    fn try_run(&self) -> Result<Finding, FigureError> {
        Ok(match *self {
            Self::Bench { row, runs } => match row.measure(runs)? {
                Some(measurement) => Finding::Bench(measurement),
                None => Finding::Failed(key::no_such_row().into()),
            },
            Self::Invariants(_) | Self::Symmetry(_) | Self::Formula(_) | Self::Grid(_) | Self::Projection(_) => {
                Finding::Failed(key::no_such_row().into())
            }
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
    use crate::worker::{packed, unpacked};

    fn ran(study: &Study) -> Finding {
        study.run(&mut |_| true).unwrap()
    }

    #[test]
    fn progress_is_sent_in_hundredths_and_only_upwards() {
        let mut advance = Advance::default();
        let sent = (0..10_000).map(|k| f64::from(k % 5_000) / 5_000.0).filter(|&done| advance.selects(done)).count();
        assert!((90..=100).contains(&sent), "{sent}");
    }

    /// Findings are sent to another thread as bytes.
    #[test]
    fn findings_survive_as_bytes() {
        let rows = [
            BenchRow::Preparation { index: 0, setting: BenchSetting::Default },
            BenchRow::Frame { index: 0, setting: BenchSetting::Default },
        ];
        for row in rows {
            let finding = ran(&Study::Bench { row, runs: 1 });
            assert!(matches!(finding, Finding::Bench(_)), "{finding:?}");
            assert_eq!(unpacked::<Finding>(&packed(&finding)).unwrap(), finding);
        }
        let rung = Rung { shape: LadderShape::Disk, method: LadderMethod::AdjointDefault, resolution: 100 };
        let finding = ran(&Study::Ladder { rung });
        assert!(matches!(&finding, Finding::Ladder(row) if row.rung == rung), "{finding:?}");
        assert_eq!(unpacked::<Finding>(&packed(&finding)).unwrap(), finding);
        let psi = Finding::Bench(Measurement::PsiTable { psi_s: None });
        assert_eq!(unpacked::<Finding>(&packed(&psi)).unwrap(), psi);
        assert_eq!(unpacked::<Finding>(b"no finding"), None);
    }

    /// All that is sent about the map, whose types other modules own.
    #[test]
    fn formulas_and_invariants_survive_as_bytes() {
        let session = crate::session::Session::default();
        let task = FormulaTask::new(&session, crate::export::FormulaFormat::Glsl, 3).unwrap();
        let studies = [
            Study::Formula(Box::new(task)),
            Study::Convergence { m: 50 },
            Study::Ladder { rung: Rung { shape: LadderShape::Disk, method: LadderMethod::Zipper, resolution: 50 } },
        ];
        for study in &studies {
            assert_eq!(unpacked::<Study>(&packed(study)).as_ref(), Some(study));
            let finding = ran(study);
            assert!(!matches!(finding, Finding::Failed(_)), "{finding:?}");
            assert_eq!(unpacked::<Finding>(&packed(&finding)), Some(finding));
        }
        for finding in [Finding::Progress(0.25), Finding::Failed(key::no_map().into())] {
            assert_eq!(unpacked::<Finding>(&packed(&finding)), Some(finding));
        }
    }

    #[test]
    fn a_row_that_is_not_there_is_refused() {
        let row = BenchRow::Frame { index: 99, setting: BenchSetting::Default };
        assert!(matches!(ran(&Study::Bench { row, runs: 1 }), Finding::Failed(_)));
    }
}
