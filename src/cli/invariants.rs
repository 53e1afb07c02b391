//! `riemap invariants`: conformal invariants of an outline, each with its error.

use super::CliError;
use super::invariants_arguments::InvariantsArguments;
use super::marks::Marked;
use super::named_curve::NamedCurve;
use super::named_outline::reach;
use super::output::print;
use crate::boundary_integral::{BoundaryIntegralError, Estimate, Invariants, InvariantsRequest, invariants};
use crate::conformal::Quadrilateral;
use std::fmt::Write as _;

/// Computes and prints the invariants.
pub fn run(arguments: &InvariantsArguments) -> Result<(), CliError> {
    let given = NamedCurve::read(&arguments.outline, &arguments.reading.one(&arguments.outline)?, arguments.interpret)?;
    let point = |fraction| given.curve.point_at_fraction(fraction);
    let marked = arguments.marks.on(&given)?;
    let marks = marked.map(|marked| marked.marks.fractions().map(point));
    let request = InvariantsRequest::new(arguments.point.0)
        .with_second_point(arguments.second_point.map(|point| point.0))
        .with_marks(marks);
    let mut found = invariants(&given.curve, &request).map_err(|error| refused(arguments, &given, &error))?;
    if let Some(marked) = marked {
        // from viewpoints of its own: it does not depend on the point
        let quadrilateral = Quadrilateral::of_outline((&given.polygon, &given.curve), marked.marks);
        let refused = |error| CliError::Input(format!("{}: the marks: {error}", arguments.outline));
        found.modulus = Some(quadrilateral.map_err(refused)?.modulus());
    }
    let measures = measures(&given, &found, marked);
    if arguments.json {
        let report = Report {
            harmonic_measure: measures.into_iter().map(Number::from).collect(),
            conformal_radius: found.conformal_radius.into(),
            capacity: found.capacity.into(),
            modulus: found.modulus.map(Number::from),
            hyperbolic_distance: found.hyperbolic_distance.map(Number::from),
            unknowns: found.unknowns,
        };
        let text = serde_json::to_string_pretty(&report).map_err(|error| CliError::Input(error.to_string()))?;
        return print(&text);
    }
    print(&table(&found, &measures))
}

/// The measures of the arcs from mark to mark, or else of the sides in the file's order.
fn measures(given: &NamedCurve, found: &Invariants, marked: Option<Marked>) -> Vec<Estimate> {
    let mut sides = found.of_sides(&given.sides);
    if given.is_reversed {
        // the first point stays first, so the file's side 0 is the last one
        sides.reverse();
    }
    match (found.arcs, marked) {
        (Some(arcs), Some(marked)) => marked.as_given(arcs).to_vec(),
        _ => sides,
    }
}

fn refused(arguments: &InvariantsArguments, given: &NamedCurve, error: &BoundaryIntegralError) -> CliError {
    let reach = || reach(&given.polygon);
    let (option, reach) = match error {
        BoundaryIntegralError::NotInside { at } if *at == arguments.point.0 => ("--point: ", reach()),
        BoundaryIntegralError::NotInside { .. } => ("--second-point: ", reach()),
        _ => ("", String::new()),
    };
    CliError::Input(format!("{}: {option}{error}{reach}", arguments.outline))
}

/// A number of a report, with its error.
#[derive(Debug, serde::Serialize)]
pub struct Number {
    value: f64,
    error: f64,
}

impl From<Estimate> for Number {
    fn from(Estimate { value, error }: Estimate) -> Self {
        Self { value, error }
    }
}

impl Number {
    /// The number.
    pub fn estimate(&self) -> Estimate {
        Estimate { value: self.value, error: self.error }
    }
}

/// The report of `--json`.
#[derive(Debug, serde::Serialize)]
struct Report {
    harmonic_measure: Vec<Number>,
    conformal_radius: Number,
    capacity: Number,
    modulus: Option<Number>,
    hyperbolic_distance: Option<Number>,
    unknowns: [usize; 2],
}

/// One line for each number.
fn table(found: &Invariants, measures: &[Estimate]) -> String {
    let mut text = String::new();
    let mut line = |name: &str, Estimate { value, error }: Estimate| {
        let _ = writeln!(text, "{name:<22} {value:<24} ± {error:.1e}");
    };
    line("conformal radius", found.conformal_radius);
    line("capacity", found.capacity);
    if let Some(modulus) = found.modulus {
        line("modulus", modulus);
    }
    if let Some(distance) = found.hyperbolic_distance {
        line("hyperbolic distance", distance);
    }
    let part = if found.arcs.is_some() { "arc" } else { "side" };
    for (k, measure) in measures.iter().enumerate() {
        line(&format!("harmonic measure, {part} {}", k + 1), *measure);
    }
    text.truncate(text.trim_end().len());
    text
}
