//! Messages for errors of a formula.

use crate::language::{Message, Value, key};
use crate::rational::{FormulaError, MAX_DEGREE};

impl From<&FormulaError> for Message {
    fn from(error: &FormulaError) -> Self {
        match error {
            FormulaError::Surface { side } => key::formula_of_surface(*side),
            FormulaError::FiniteElements { side, reason } => key::formula_finite_elements(*side, Self::from(&**reason)),
            FormulaError::NoIntegral { side } => key::formula_no_integral(*side),
            FormulaError::NoDigit { errors } => key::formula_no_digit(
                MAX_DEGREE,
                Value::number(format!("{:.1e}", errors.source)),
                Value::number(format!("{:.1e}", errors.target)),
            ),
            FormulaError::Cancelled(_) => key::formula_cancelled().into(),
        }
    }
}
