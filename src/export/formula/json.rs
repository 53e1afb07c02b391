//! A formula as JSON.

use super::FormulaFile;
use crate::conformal::PerSide;
use crate::rational::Fit;
use num_complex::Complex64;
use serde_json::{Map, Value, json};

/// All numbers.
pub fn file(file: &FormulaFile<'_>) -> String {
    document(file, |fit| {
        let function = fit.function();
        let mut object = summary_of(fit);
        object.insert("support_points".to_owned(), points(function.support()));
        object.insert("values".to_owned(), points(function.values()));
        object.insert("weights".to_owned(), points(function.weights()));
        object.insert("poles".to_owned(), points(fit.poles()));
        object
    })
}

/// Degrees, errors and digits.
pub fn summary(file: &FormulaFile<'_>) -> String {
    document(file, summary_of)
}

fn document(file: &FormulaFile<'_>, object: impl Fn(&Fit) -> Map<String, Value>) -> String {
    let formula = file.formula;
    // null for a function without a digit
    let function = |fit: &Fit| if fit.digits() > 0 { Value::Object(object(fit)) } else { Value::Null };
    let value = json!({
        "riemap": env!("CARGO_PKG_VERSION"),
        "source": file.names.source,
        "target": file.names.target,
        "digits": file.digits,
        "digits_reached": formula.forward.digits().min(formula.inverse.digits()),
        "there_and_back": sides(&formula.there_and_back),
        "boundary_error": sides(&formula.boundary_error),
        "f": function(&formula.forward),
        "inverse": function(&formula.inverse),
    });
    format!("{value:#}\n")
}

fn sides<T: serde::Serialize>(values: &PerSide<T>) -> Value {
    json!({ "source": values.source, "target": values.target })
}

fn summary_of(fit: &Fit) -> Map<String, Value> {
    let mut object = Map::new();
    object.insert("degree".to_owned(), fit.function().degree().into());
    object.insert("error".to_owned(), fit.error().into());
    object.insert("extent".to_owned(), fit.extent().into());
    object.insert("digits_reached".to_owned(), fit.digits().into());
    object
}

fn points(points: &[Complex64]) -> Value {
    points.iter().map(|z| json!([z.re, z.im])).collect()
}
