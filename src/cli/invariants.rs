//! `riemap invariants`: conformal invariants of an outline, each with its error. Capacity and modulus are the outline's; harmonic
//! measure, conformal radius and distance are seen from a point.

use super::CliError;
use super::invariants_arguments::InvariantsArguments;
use super::marks::Marked;
use super::named_curve::NamedCurve;
use super::named_outline::reach;
use super::output::print;
use crate::boundary_integral::{BoundaryIntegralError, Estimate, Invariants, InvariantsRequest, capacity, invariants};
use crate::conformal::{Quadrilateral, QuadrilateralError};
use crate::geometry::DVec2;

/// Computes and prints the invariants.
pub fn run(arguments: &InvariantsArguments) -> Result<(), CliError> {
    let given = NamedCurve::read(&arguments.outline, &arguments.reading.one(&arguments.outline)?, arguments.interpret)?;
    let marked = arguments.marks.on(&given)?;
    let seen = arguments.point.map(|point| from_point(arguments, &given, (point.0, marked))).transpose()?;
    let capacity = match &seen {
        Some(seen) => seen.capacity,
        None => capacity(&given.curve).map_err(|error| refused(arguments, &given, &error))?,
    };
    // from viewpoints of its own: it does not depend on the point
    let modulus =
        |marked: Marked| Ok(Quadrilateral::of_outline((&given.polygon, &given.curve), marked.marks)?.modulus());
    let refused = |error: QuadrilateralError| CliError::Input(format!("{}: the marks: {error}", arguments.outline));
    let modulus = marked.map(modulus).transpose().map_err(refused)?;
    let measures = seen.as_ref().map(|seen| measures(&given, seen, marked));
    if arguments.json {
        let report = Report {
            harmonic_measure: measures.map(|measures| measures.into_iter().map(Number::from).collect()),
            conformal_radius: seen.as_ref().map(|seen| seen.conformal_radius.into()),
            capacity: capacity.into(),
            modulus: modulus.map(Number::from),
            hyperbolic_distance: seen.as_ref().and_then(|seen| seen.hyperbolic_distance).map(Number::from),
            unknowns: seen.as_ref().map(|seen| seen.unknowns),
        };
        let text = serde_json::to_string_pretty(&report).map_err(|error| CliError::Input(error.to_string()))?;
        return print(&text);
    }
    let part = if marked.is_some() { "arc" } else { "side" };
    let named = |name: &str, found: Option<Estimate>| found.map(|found| (name.to_owned(), found));
    let mut lines = Vec::new();
    lines.extend(named("conformal radius", seen.as_ref().map(|seen| seen.conformal_radius)));
    lines.extend(named("capacity", Some(capacity)));
    lines.extend(named("modulus", modulus));
    lines.extend(named("hyperbolic distance", seen.and_then(|seen| seen.hyperbolic_distance)));
    let measures = measures.unwrap_or_default().into_iter().enumerate();
    lines.extend(measures.map(|(k, measure)| (format!("harmonic measure, {part} {}", k + 1), measure)));
    let line = |(name, Estimate { value, error }): &(String, Estimate)| format!("{name:<22} {value:<24} ± {error:.1e}");
    print(&lines.iter().map(line).collect::<Vec<_>>().join("\n"))
}

/// What is seen from a point, and the capacity.
fn from_point(
    arguments: &InvariantsArguments,
    given: &NamedCurve,
    (x, marked): (DVec2, Option<Marked>),
) -> Result<Invariants, CliError> {
    let point = |fraction| given.curve.point_at_fraction(fraction);
    let request = InvariantsRequest::new(x)
        .with_second_point(arguments.second_point.map(|point| point.0))
        .with_marks(marked.map(|marked| marked.marks.fractions().map(point)));
    invariants(&given.curve, &request).map_err(|error| refused(arguments, given, &error))
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
        BoundaryIntegralError::NotInside { at } if arguments.point.is_some_and(|point| point.0 == *at) => {
            ("--point: ", reach())
        }
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

/// The report of `--json`; `null` is what was not asked for, and what needs a point without one.
#[derive(Debug, serde::Serialize)]
struct Report {
    harmonic_measure: Option<Vec<Number>>,
    conformal_radius: Option<Number>,
    capacity: Number,
    modulus: Option<Number>,
    hyperbolic_distance: Option<Number>,
    unknowns: Option<[usize; 2]>,
}
