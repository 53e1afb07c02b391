//! The best map on the screen, as a record for `window.riemap.stats()` and for tests.

use crate::model::Model;
use crate::model::best::Landscapes;
use serde::Serialize;

/// The best map: search, result, region and landscape.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct BestStats {
    /// The share of the search under way that is done.
    pub progress: Option<f64>,
    /// The criterion before and after the last search.
    pub result: Option<[f64; 2]>,
    /// Whether the points are on their way.
    pub moving: bool,
    /// How many dabs the region has.
    pub region: usize,
    /// The least value of the landscape that is shown.
    pub lowest: Option<f64>,
}

impl BestStats {
    /// Of what the model shows.
    pub fn of(model: &Model) -> Self {
        let best = model.best();
        Self {
            progress: best.progress().map(|(done, _)| done),
            result: best.outcome().map(|outcome| [outcome.before, outcome.after]),
            moving: best.is_moving(),
            region: model.session().region().len(),
            lowest: best.landscape().and_then(Landscapes::marks).map(|marks| marks.least),
        }
    }
}
