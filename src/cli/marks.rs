//! Four marks on an outline, of `riemap invariants` and `riemap grid`.

use super::CliError;
use super::named_curve::NamedCurve;
use super::values::{Anchor, vertex_at};
use crate::conformal::Marks;
use std::str::FromStr;

/// Four marks, in both forms.
#[derive(Debug, clap::Args)]
pub struct MarkArguments {
    /// Four boundary points as fractions of the boundary's length from the outline's first point, in the cyclic
    /// order of the file's points.
    #[arg(long, value_name = "S,S,S,S", allow_hyphen_values = true)]
    pub marks: Option<Fractions>,
    /// A boundary point, four times in cyclic order, in the place of --marks: the file's point K, counted from 0, the
    /// boundary point nearest to X,Y, or the one at fraction S.
    #[arg(long = "mark", value_name = "vK|X,Y|@S", allow_hyphen_values = true, conflicts_with = "marks")]
    pub each: Vec<Anchor>,
}

/// Four numbers, separated by commas.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fractions([f64; 4]);

impl FromStr for Fractions {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers: Option<Vec<f64>> = text.split(',').map(|s| s.trim().parse().ok()).collect();
        match numbers.as_deref() {
            Some(&[a, b, c, d]) => {
                Marks::new([a, b, c, d]).map(|_| Self([a, b, c, d])).map_err(|error| error.to_string())
            }
            _ => Err("expected four finite fractions S,S,S,S, such as 0,0.25,0.5,0.75".to_owned()),
        }
    }
}

/// Four marks in counter-clockwise cyclic order.
#[derive(Debug, Clone, Copy)]
pub struct Marked {
    /// The marks as given, or if they run clockwise in the order 2, 1, 4, 3, so that the arcs from mark 1 to 2 and from mark 3
    /// to 4 stay the first and the third one.
    pub marks: Marks,
    /// Whether they run clockwise.
    is_clockwise: bool,
}

impl Marked {
    /// What belongs to the arcs from mark to mark, as the marks are given.
    pub fn as_given<T>(&self, [a, b, c, d]: [T; 4]) -> [T; 4] {
        if self.is_clockwise { [a, d, c, b] } else { [a, b, c, d] }
    }
}

impl MarkArguments {
    /// The marks on a curve; `None` if none are given.
    pub fn on(&self, given: &NamedCurve) -> Result<Option<Marked>, CliError> {
        let fraction = |anchor: &Anchor| {
            Ok(match *anchor {
                Anchor::Vertex(k) => given.curve.fraction_nearest(vertex_at(k, &given.vertices)?),
                Anchor::Nearest(x) => given.curve.fraction_nearest(x),
                Anchor::Fraction(s) if given.is_reversed => 1.0 - s,
                Anchor::Fraction(s) => s,
            })
        };
        let anchors =
            self.marks.map_or_else(|| self.each.clone(), |Fractions(marks)| marks.map(Anchor::Fraction).to_vec());
        let fractions = anchors.iter().map(fraction).collect::<Result<Vec<f64>, CliError>>()?;
        let [a, b, c, d] = match *fractions.as_slice() {
            [] => return Ok(None),
            [a, b, c, d] => [a, b, c, d],
            _ => return Err(CliError::Usage(format!("--mark: four marks are needed, not {}", self.each.len()))),
        };
        let marked = |marks: Marks, is_clockwise| Marked { marks, is_clockwise };
        match (Marks::new([a, b, c, d]), Marks::new([b, a, d, c])) {
            (Ok(marks), _) => Ok(Some(marked(marks, false))),
            (Err(_), Ok(marks)) => Ok(Some(marked(marks, true))),
            (Err(error), Err(_)) => Err(CliError::Usage(format!("the marks: {error}"))),
        }
    }
}
