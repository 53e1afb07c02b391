//! A formula as JSON. Numbers have as many digits as determine them; one that is not finite is null.

use super::FormulaFile;
use crate::rational::Fit;
use num_complex::Complex64;

/// All numbers.
pub fn file(file: &FormulaFile<'_>) -> String {
    document(file, true)
}

/// Degrees, errors and digits.
pub fn summary(file: &FormulaFile<'_>) -> String {
    document(file, false)
}

fn document(file: &FormulaFile<'_>, has_numbers: bool) -> String {
    let formula = file.formula;
    let [f, inverse] = [&formula.forward, &formula.inverse].map(|fit| function(fit, has_numbers));
    let (back, error) = (formula.there_and_back, formula.boundary_error);
    let members = [
        ("riemap", string(env!("CARGO_PKG_VERSION"))),
        ("source", string(&file.names.source)),
        ("target", string(&file.names.target)),
        ("digits", file.digits.to_string()),
        ("digits_reached", formula.forward.digits().min(formula.inverse.digits()).to_string()),
        ("there_and_back", sides([back.source, back.target])),
        ("boundary_error", sides([Some(error.source), Some(error.target)])),
        ("f", f),
        ("inverse", inverse),
    ];
    object("  ", &members) + "\n"
}

/// One function; null without a digit.
fn function(fit: &Fit, has_numbers: bool) -> String {
    if fit.digits() == 0 {
        return null();
    }
    let mut members = vec![
        ("degree", fit.function().degree().to_string()),
        ("error", number(fit.error())),
        ("extent", number(fit.extent())),
        ("digits_reached", fit.digits().to_string()),
    ];
    if has_numbers {
        let function = fit.function();
        members.extend([
            ("support_points", points(function.support())),
            ("values", points(function.values())),
            ("weights", points(function.weights())),
            ("poles", points(fit.poles())),
        ]);
    }
    object("    ", &members)
}

/// An object with its members on lines of their own, behind `indent`.
fn object(indent: &str, members: &[(&str, String)]) -> String {
    let lines: Vec<String> = members.iter().map(|(name, value)| format!("{indent}\"{name}\": {value}")).collect();
    format!("{{\n{}\n{}}}", lines.join(",\n"), &indent[2..])
}

fn sides([source, target]: [Option<f64>; 2]) -> String {
    let [source, target] = [source, target].map(|value| value.map_or_else(null, number));
    format!("{{ \"source\": {source}, \"target\": {target} }}")
}

fn points(points: &[Complex64]) -> String {
    let rows: Vec<String> = points.iter().map(|z| format!("      [{}, {}]", number(z.re), number(z.im))).collect();
    format!("[\n{}\n    ]", rows.join(",\n"))
}

fn number(value: f64) -> String {
    if value.is_finite() { format!("{value:?}") } else { null() }
}

fn null() -> String {
    String::from("null")
}

fn string(text: &str) -> String {
    // text can always be written
    serde_json::to_string(text).unwrap_or_default()
}
