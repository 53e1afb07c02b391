//! An undo history as text: each step is a session without its loaded outlines, which it refers to by their numbers.
//!
//! Consecutive steps mostly share their outlines; each of these is written once. Reading gives the sessions bit for
//! bit, with the guarantees of [`super::super::read`].

use crate::conformal::Side;
use crate::outline::Preset;
use crate::session::file::{FileError, malformed, parsed, read_object, write_object};
use crate::session::{History, OutlineSpec, Session};
use serde::{Deserialize, Serialize};

/// A list of sessions in order: those before the present one, the present one if it is included, those after it.
#[derive(Debug, Clone, PartialEq)]
pub struct Steps {
    /// The loaded outlines, each once, numbered from 0.
    pub outlines: Vec<OutlineSpec>,
    /// The steps as JSON.
    pub text: String,
}

#[derive(Serialize, Deserialize)]
struct Written {
    past: Vec<Step>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    now: Option<Step>,
    future: Vec<Step>,
}

/// A session whose loaded outlines are replaced by a preset.
#[derive(Serialize, Deserialize)]
struct Step {
    session: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    source: Option<usize>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    target: Option<usize>,
}

impl Steps {
    /// The steps of a history; `with_now`: the present session too. Errors: a number outside the range of its control.
    pub fn of(history: &History, with_now: bool) -> Result<Self, FileError> {
        let mut outlines = Vec::new();
        let mut all = |sessions: &[Session]| -> Result<Vec<Step>, FileError> {
            sessions.iter().map(|session| Step::of(session, &mut outlines)).collect()
        };
        let (past, future) = (all(history.past())?, all(history.future())?);
        let now = if with_now { all(std::slice::from_ref(history.now()))?.pop() } else { None };
        let text = serde_json::to_string(&Written { past, now, future }).map_err(|error| malformed(&error))?;
        Ok(Self { outlines, text })
    }

    /// The history; `now` is its present session if the steps do not include one. Errors: the text is not that of
    /// steps, or one of its sessions cannot be read.
    pub fn history(&self, now: Option<Session>) -> Result<History, FileError> {
        let Written { past, now: included, future } = parsed(&self.text)?;
        let all = |steps: &[Step]| steps.iter().map(|step| step.session(&self.outlines)).collect::<Result<Vec<_>, _>>();
        let now = match (included, now) {
            (Some(step), _) => step.session(&self.outlines)?,
            (None, Some(now)) => now,
            (None, None) => return Err(FileError::Malformed(String::from("the present session is missing"))),
        };
        Ok(History::from_steps(all(&past)?, now, all(&future)?))
    }
}

impl Step {
    fn of(session: &Session, outlines: &mut Vec<OutlineSpec>) -> Result<Self, FileError> {
        let (mut light, mut numbers) = (session.clone(), [None; 2]);
        for (side, number) in Side::BOTH.into_iter().zip(&mut numbers) {
            let outline = &session.domain(side).outline;
            if matches!(outline, OutlineSpec::Points { .. }) {
                // the last one first: mostly it is the same
                let known = outlines.iter().rposition(|known| known == outline);
                *number = Some(known.unwrap_or(outlines.len()));
                if known.is_none() {
                    outlines.push(outline.clone());
                }
                light = light.with_outline(side, OutlineSpec::Preset(Preset::Disk));
            }
        }
        let [source, target] = numbers;
        Ok(Self { session: write_object(&light)?, source, target })
    }

    fn session(&self, outlines: &[OutlineSpec]) -> Result<Session, FileError> {
        let mut session = read_object(&self.session)?;
        for (side, number) in Side::BOTH.into_iter().zip([self.source, self.target]) {
            let Some(number) = number else { continue };
            let outline = outlines.get(number).ok_or_else(|| FileError::MissingPart(super::outline_path(number)))?;
            session = session.with_outline(side, outline.clone());
        }
        Ok(session)
    }
}
