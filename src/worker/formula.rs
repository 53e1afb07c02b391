//! The formula of a session's map, as a study: the request and its result, which cross to the worker as bytes.
//!
//! The sides are prepared anew with the boundary integral, resolved from the interior points that are set, as
//! `riemap formula` does: for the same outlines, points and digits the file is the same to the byte. The session's
//! resolution and kernel are not used.

use crate::conformal::{
    ConformalMap, Constraints, InteriorPoint, KernelMode, MapSettings, PerSide, PrepareSettings, PreparedSide, Side,
    prepare_curve,
};
use crate::export::{FormulaFile, FormulaFormat};
use crate::language::{Message, key};
use crate::rational::{Formula, FormulaError, Reached};
use crate::session::{OutlineSpec, Session, SideState, file};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// The share of the work that prepares a side: blob → disk takes 0.1 s of 0.9 s.
const PREPARED: f64 = 0.05;

/// The map of a session, and the file to make of it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct FormulaTask {
    session: String,
    format: FormulaFormat,
    digits: u32,
}

/// The file of a formula, and what it reaches.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FoundFormula {
    /// The file.
    pub text: String,
    /// What f (source) and its inverse (target) reach.
    pub reached: PerSide<Reached>,
}

impl FormulaTask {
    /// The task for a session between two outlines, and a number of digits in [`FormulaFormat::digits`].
    ///
    /// Errors: a session that has no file.
    pub fn new(session: &Session, format: FormulaFormat, digits: u32) -> Result<Self, Message> {
        let session = file::write_compact(session).map_err(|error| Message::from(&error))?;
        Ok(Self { session, format, digits })
    }

    /// The format of the file.
    pub fn format(&self) -> FormulaFormat {
        self.format
    }

    /// The number of digits to reach.
    pub fn digits(&self) -> u32 {
        self.digits
    }

    /// Makes the file. `report` gets the share that is done and returns whether to go on; `None` if it said no. It is
    /// called before every step of a fit, which takes up to 20 ms, and between preparations.
    ///
    /// Errors: why there is no map or no formula.
    pub fn run(&self, report: &mut dyn FnMut(f64) -> bool) -> Result<Option<FoundFormula>, Message> {
        let session = file::read(self.session.as_bytes()).map_err(|error| Message::from(&error))?;
        let (source, first) = prepared(&session, Side::Source)?;
        if !report(PREPARED) {
            return Ok(None);
        }
        let (target, second) = prepared(&session, Side::Target)?;
        let map = ConformalMap::new(source, target, &Constraints::new(first, second), MapSettings::default());
        let map = map.map_err(|error| Message::from(&error))?;
        let begun = 2.0 * PREPARED;
        let fit = if self.format.is_single() { Formula::single } else { Formula::new };
        match fit(&map, self.digits, &mut |done| report(begun + (1.0 - begun) * done)) {
            Ok(formula) => Ok(Some(self.found(&session, &formula))),
            Err(FormulaError::Cancelled(_)) => Ok(None),
            Err(error) => Err(Message::from(&error)),
        }
    }

    fn found(&self, session: &Session, formula: &Formula) -> FoundFormula {
        let [source, target] = Side::BOTH.map(|side| name(&session.domain(side).outline));
        let text = FormulaFile::new(PerSide::new(&source, &target), self.digits, formula).text(self.format);
        FoundFormula { text, reached: formula.reached(self.digits) }
    }
}

/// The name of an outline on the command line, for a file that is in the present folder.
fn name(outline: &OutlineSpec) -> String {
    match outline {
        OutlineSpec::Preset(preset) => format!("preset:{}", preset.name()),
        OutlineSpec::Points { name, .. } => name.clone(),
    }
}

/// A side with its interior point and its boundary point.
fn prepared(session: &Session, side: Side) -> Result<(Arc<PreparedSide>, (InteriorPoint, f64)), Message> {
    if session.surface(side).is_some() {
        return Err(Message::from(&FormulaError::Surface { side }));
    }
    let state = session.side(side);
    let prepared = prepare(state)?;
    let interior = state.interior().map_or_else(|| prepared.default_point(), InteriorPoint::from);
    Ok((Arc::new(prepared), (interior, state.anchor())))
}

fn prepare(state: &SideState) -> Result<PreparedSide, Message> {
    let outline = &state.domain().outline;
    let curve = outline.curve().map_err(|_| key::outline_without_curve())?;
    let near: Vec<_> = state.interior().into_iter().collect();
    let settings = PrepareSettings::default().with_kernel(KernelMode::Integral);
    prepare_curve((&outline.polygon(), curve.curve()), &near, &settings, &mut |_| ())
        .map_err(|error| Message::from(&error))
}
