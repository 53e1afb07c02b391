//! Files of a map as a formula: its numbers as JSON, or code with the functions `f` and `f_inverse`.
//!
//! The code uses nothing but its language. Numbers are written with as many digits as determine them. At a support point
//! the functions return the value there; at a pole, which lies outside, what the language makes of a division by 0.

mod code;
mod json;

use crate::conformal::{PerSide, Side};
use crate::rational::{DIGITS, Fit, Formula, SINGLE_DIGITS};
use std::fmt::Write as _;

/// The formats of a formula.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[allow(missing_docs, reason = "the variants are the languages")]
pub enum FormulaFormat {
    Json,
    Python,
    Julia,
    JavaScript,
    Glsl,
}

impl FormulaFormat {
    /// All formats.
    pub const ALL: [Self; 5] = [Self::Json, Self::Python, Self::Julia, Self::JavaScript, Self::Glsl];

    /// Its name.
    pub fn title(self) -> &'static str {
        match self {
            Self::Json => "JSON",
            Self::Python => "Python",
            Self::Julia => "Julia",
            Self::JavaScript => "JavaScript",
            Self::Glsl => "GLSL",
        }
    }

    /// Its file extension.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Json => "json",
            Self::Python => "py",
            Self::Julia => "jl",
            Self::JavaScript => "js",
            Self::Glsl => "glsl",
        }
    }

    /// Whether it is evaluated in single precision.
    pub fn is_single(self) -> bool {
        self == Self::Glsl
    }

    /// The numbers of digits that can be asked for.
    pub fn digits(self) -> std::ops::RangeInclusive<u32> {
        if self.is_single() { SINGLE_DIGITS } else { DIGITS }
    }

    /// The format of an extension in lower case.
    pub fn of_extension(extension: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.extension() == extension)
    }
}

/// A formula with the names of its sides.
#[derive(Debug, Clone)]
pub struct FormulaFile<'a> {
    names: PerSide<String>,
    digits: u32,
    formula: &'a Formula,
}

impl<'a> FormulaFile<'a> {
    /// The formula that was made for so many digits. Control characters of the names are left out.
    pub fn new(names: PerSide<&str>, digits: u32, formula: &'a Formula) -> Self {
        // U+2028 and U+2029 end a line, and so a comment, in JavaScript
        let is_plain = |c: &char| !c.is_control() && !matches!(c, '\u{2028}' | '\u{2029}');
        let names = names.map(|name| name.chars().filter(is_plain).collect());
        Self { names, digits: formula.digits_at_most(digits), formula }
    }

    /// The file. GLSL should be given a formula in single precision.
    pub fn text(&self, format: FormulaFormat) -> String {
        match format {
            FormulaFormat::Json => json::file(self),
            FormulaFormat::Python => code::python(self),
            FormulaFormat::Julia => code::julia(self),
            FormulaFormat::JavaScript => code::javascript(self),
            FormulaFormat::Glsl => code::glsl(self),
        }
    }

    /// What the functions are called, with the side that each maps; `None` for one without a digit.
    fn functions(&self) -> [(&'static str, Side, Option<&'a Fit>); 2] {
        let useful = |fit: &'a Fit| (fit.digits() > 0).then_some(fit);
        [("f", Side::Source, useful(&self.formula.forward)), ("f_inverse", Side::Target, useful(&self.formula.inverse))]
    }

    /// Degrees, errors and digits, in words.
    pub fn summary(&self) -> String {
        let mut text = String::new();
        for (name, side, fit) in self.functions() {
            let Some(fit) = fit else {
                let _ = writeln!(text, "{name}: none, since no rational function was found that has one digit");
                continue;
            };
            let _ = write!(
                text,
                "{name}: degree {}, {} digits, largest error {:.1e} on the boundary, whose values may be off by {:.1e}",
                fit.function().degree(),
                fit.digits(),
                fit.error(),
                self.formula.boundary_error[side],
            );
            if let Some(distance) = self.formula.there_and_back[side] {
                let _ = write!(text, "; there and back {distance:.1e} inside");
            }
            text.push('\n');
        }
        text.truncate(text.trim_end().len());
        text
    }

    /// The same as JSON.
    pub fn summary_json(&self) -> String {
        json::summary(self).trim_end().to_owned()
    }
}
