//! What a worker is asked and what it answers.
//!
//! The engine is pure: it runs in a web worker, and natively on a thread. Every
//! message carries the generation of its request; the receiver drops stale ones.

mod study;

pub use study::{Finding, Study};

use crate::conformal::{PrepareSettings, PreparedDomain, Stage, prepare};
use crate::geometry::SimplePolygon;

/// A request to prepare one side.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// Counts up with every request of that side.
    pub generation: u64,
    /// The outline.
    pub polygon: SimplePolygon,
    /// How to discretise it.
    pub settings: PrepareSettings,
}

/// An answer.
#[derive(Debug)]
pub enum Response {
    /// A stage begins.
    Progress(Stage),
    /// Done.
    Prepared(Box<PreparedDomain>),
    /// Not to be done, and why, in words for the person.
    Failed(String),
}

/// Carries out `request`, emitting `(generation, response)`.
pub fn run(request: &Request, emit: &mut dyn FnMut(u64, Response)) {
    let generation = request.generation;
    let result = prepare(&request.polygon, &request.settings, &mut |stage| emit(generation, Response::Progress(stage)));
    emit(
        generation,
        match result {
            Ok(domain) => Response::Prepared(Box::new(domain)),
            Err(error) => Response::Failed(error.to_string()),
        },
    );
}
