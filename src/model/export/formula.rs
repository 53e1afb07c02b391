//! The map as a formula: the request to the worker that computes it.

use crate::conformal::{Side, Unsharpened};
use crate::export::FormulaFormat;
use crate::language::Message;
use crate::model::Model;
use crate::rational::FormulaError;
use crate::session::Command;
use crate::worker::FormulaTask;

impl Model {
    /// Why the map that is shown has no formula, as far as that is known before its worker tries: a side is a surface,
    /// or its boundary integral does not fit.
    pub fn refused_formula(&self) -> Option<Message> {
        Side::BOTH.into_iter().find_map(|side| {
            if !self.abilities().has_outline(side) {
                return Some(Message::from(&FormulaError::Surface { side }));
            }
            let reason = self.prepared(side)?.unsharpened()?;
            // the worker does not take the session's samples
            let is_of_curve = matches!(reason, Unsharpened::Curve(_) | Unsharpened::Integral(_));
            is_of_curve.then(|| Message::from(&FormulaError::FiniteElements { side, reason: Box::new(reason.clone()) }))
        })
    }

    /// What its worker has to know for the formula of the session's map between the points that are shown, with the
    /// boundary integral whatever kernel is shown. Errors: as [`Self::refused_formula`].
    pub fn formula_task(&self, format: FormulaFormat, digits: u32) -> Result<FormulaTask, Message> {
        if let Some(reason) = self.refused_formula() {
            return Err(reason);
        }
        let shown = |side| Some(Command::MoveInterior { side, point: self.interior(side)?.into() });
        let session = self.session.clone().and(Side::BOTH.into_iter().filter_map(shown));
        FormulaTask::new(&session, format, digits)
    }
}
