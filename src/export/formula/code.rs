//! A formula as code: tables of support points, values and weights, one evaluation, two functions.

use super::FormulaFile;
use crate::rational::Fit;
use num_complex::Complex64;
use std::fmt::Write as _;

const PYTHON: &str = include_str!("template.py");
const JULIA: &str = include_str!("template.jl");
const JAVASCRIPT: &str = include_str!("template.js");
const GLSL: &str = include_str!("template.glsl");

/// Python 3, without any package.
pub fn python(file: &FormulaFile<'_>) -> String {
    filled(file, PYTHON, "#", &complex_row)
}

/// Julia, without any package.
pub fn julia(file: &FormulaFile<'_>) -> String {
    filled(file, JULIA, "#", &complex_row)
}

/// JavaScript: a script, and a module of Node.
pub fn javascript(file: &FormulaFile<'_>) -> String {
    let row = |[z, value, weight]: [Complex64; 3]| {
        let numbers = [z.re, z.im, value.re, value.im, weight.re, weight.im];
        format!("  [{}],", numbers.map(|number| format!("{number:?}")).join(", "))
    };
    filled(file, JAVASCRIPT, "//", &row)
}

/// A support point, its value and its weight in Python and Julia.
fn complex_row(row: [Complex64; 3]) -> String {
    let number = |z: Complex64| format!("complex({:?}, {:?})", z.re, z.im);
    format!("    ({}),", row.map(number).join(", "))
}

/// GLSL 3.30 or ES 3.00, in single precision.
pub fn glsl(file: &FormulaFile<'_>) -> String {
    let mut text = comments(file, "//");
    text.push_str(
        "// Single precision: support points, values and weights are rounded, and errors were measured so.\n",
    );
    let mut template = GLSL.to_owned();
    for ((name, _, fit), prefix) in file.functions().into_iter().zip(["F", "F_INVERSE"]) {
        let Some(fit) = fit else {
            template = without(&template, name);
            continue;
        };
        let function = fit.function();
        let mut table = format!("const int {prefix}_COUNT = {};\n", function.support().len());
        for (part, numbers) in
            [("SUPPORT", function.support()), ("VALUES", function.values()), ("WEIGHTS", function.weights())]
        {
            let rows: Vec<String> =
                numbers.iter().map(|z| format!("    vec2({:?}, {:?})", z.re as f32, z.im as f32)).collect();
            let _ = writeln!(
                table,
                "const vec2 {prefix}_{part}[{prefix}_COUNT] = vec2[{prefix}_COUNT](\n{}\n);",
                rows.join(",\n")
            );
        }
        template = template.replace(&format!("@{name}@\n"), &table);
    }
    text.push_str(&unmarked(&template));
    text
}

/// A template with its comments and tables.
fn filled(file: &FormulaFile<'_>, template: &str, comment: &str, row: &dyn Fn([Complex64; 3]) -> String) -> String {
    let mut text = comments(file, comment);
    let mut template = template.to_owned();
    for (name, _, fit) in file.functions() {
        template = match fit {
            Some(fit) => template.replace(&format!("@{name}@"), &rows(fit, row)),
            None => without(&template, name),
        };
    }
    text.push_str(&unmarked(&template));
    text
}

/// A template without the parts that are marked as those of a function: from a line `@if NAME@` to `@end@`.
fn without(template: &str, name: &str) -> String {
    let mark = format!("@if {name}@");
    let mut is_kept = true;
    let keeps = |line: &&str| {
        let was_kept = is_kept;
        is_kept = if *line == mark { false } else { is_kept || *line == "@end@" };
        was_kept && is_kept
    };
    template.lines().filter(keeps).fold(String::new(), |text, line| text + line + "\n")
}

/// A template without its marks.
fn unmarked(template: &str) -> String {
    let is_text = |line: &&str| !line.starts_with("@if ") && *line != "@end@";
    template.lines().filter(is_text).fold(String::new(), |text, line| text + line + "\n")
}

fn rows(fit: &Fit, row: &dyn Fn([Complex64; 3]) -> String) -> String {
    let function = fit.function();
    let parts = function.support().iter().zip(function.values()).zip(function.weights());
    let lines: Vec<String> = parts.map(|((&z, &value), &weight)| row([z, value, weight])).collect();
    lines.join("\n")
}

/// What the functions are, for which points, and how accurate. No name stands in the first two lines: there Python would
/// read one like `coding: …` as the file's encoding (PEP 263).
fn comments(file: &FormulaFile<'_>, comment: &str) -> String {
    let names = &file.names;
    let mut text = format!(
        "{comment} A conformal map f and its inverse as rational functions in barycentric form,\n\
         {comment} r(z) = sum w_k f_k/(z - z_k) / sum w_k/(z - z_k), with support points z_k, values f_k, weights w_k.\n\
         {comment} Made by riemap {}: f maps \"{}\" onto \"{}\".\n",
        env!("CARGO_PKG_VERSION"),
        names.source,
        names.target
    );
    for (name, side, fit) in file.functions() {
        let Some(fit) = fit else {
            let _ = writeln!(text, "{comment} {name} is left out: no rational function was found that has one digit.");
            continue;
        };
        let _ = write!(
            text,
            "{comment} {name}: for points of \"{}\", its boundary included, and none outside. Degree {}, no pole inside.\n\
             {comment}   Largest error {:.1e}, in the units of \"{}\", as measured on the boundary: {} digits{}.\n",
            names[side],
            fit.function().degree(),
            fit.error(),
            names[side.other()],
            fit.digits(),
            if fit.digits() < file.digits { format!(" of {} that were asked for", file.digits) } else { String::new() }
        );
        let _ = writeln!(
            text,
            "{comment}   The boundary values that it was fitted to may be off by {:.1e}.",
            file.formula.boundary_error[side]
        );
    }
    text
}
