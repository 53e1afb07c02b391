//! Which part of a file is meant, a shape of a drawing or a feature of a map, and which there are.

use serde::{Deserialize, Serialize};

use super::OutlineError;
use crate::geometry::{Bounds, DVec2};

/// Which part of a file is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PartChoice<'a> {
    /// The one with this name, or else of this number, counted from 1.
    Called(&'a str),
    /// The one of this number, counted from 1.
    Number(usize),
}

/// A part of a file that can be its outline: a shape of a drawing, or a feature of a map.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Part {
    /// Its number in the file, counted from 1.
    pub number: usize,
    /// The `id` of its path, or the name of the feature.
    pub name: Option<String>,
    /// Some of its points, in the square from −1 to 1 with y upwards: what a small picture needs.
    pub picture: Vec<[f32; 2]>,
}

/// The parts of a file that has several.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Parts {
    /// The number of the one that was read.
    pub taken: usize,
    /// How many there are.
    pub count: usize,
    /// The largest ones, at most 300, in the file's order.
    pub all: Vec<Part>,
}

/// The most parts to choose from.
const MOST_PARTS: usize = 300;
/// The most points of a part's picture.
const PICTURE_POINTS: usize = 96;

impl Part {
    pub(super) fn new(number: usize, name: Option<&str>, points: &[DVec2]) -> Self {
        Self { number, name: name.map(str::to_owned), picture: picture(points) }
    }
}

impl Parts {
    /// The parts of these areas, in the file's order from number 1 on, each made by `part` from its index; `None` if there
    /// are not several.
    pub(super) fn of(areas: &[f64], taken: usize, part: impl FnMut(usize) -> Option<Part>) -> Option<Self> {
        if areas.len() < 2 {
            return None;
        }
        let mut shown: Vec<usize> = (0..areas.len()).collect();
        shown.sort_by(|&i, &j| areas[j].total_cmp(&areas[i]));
        shown.truncate(MOST_PARTS);
        shown.sort_unstable();
        let parts = Self { taken, count: areas.len(), all: shown.into_iter().filter_map(part).collect() };
        Some(parts).filter(|parts| parts.all.len() > 1)
    }
}

/// Some of the points, in the square from −1 to 1.
fn picture(points: &[DVec2]) -> Vec<[f32; 2]> {
    let bounds = Bounds::of(points.iter().copied());
    let (center, half) = (bounds.min().midpoint(bounds.max()), 0.5 * bounds.size().max_element());
    let step = points.len().div_ceil(PICTURE_POINTS).max(1);
    points.iter().step_by(step).map(|&p| ((p - center) / half).as_vec2().to_array()).collect()
}

/// The index of the part that is meant.
pub(super) fn find(wanted: PartChoice, names: &[Option<&str>]) -> Result<usize, OutlineError> {
    let numbered = |number: usize| number.checked_sub(1).filter(|&k| k < names.len());
    let found = match wanted {
        PartChoice::Number(number) => numbered(number),
        PartChoice::Called(called) => {
            names.iter().position(|name| *name == Some(called)).or_else(|| numbered(called.parse().ok()?))
        }
    };
    found.ok_or_else(|| OutlineError::NoSuchPart {
        wanted: wanted.to_string(),
        count: names.len(),
        names: listed(names),
    })
}

impl std::fmt::Display for PartChoice<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Called(called) => f.write_str(called),
            Self::Number(number) => write!(f, "{number}"),
        }
    }
}

/// There is no part of any name.
pub(super) fn single(wanted: PartChoice) -> OutlineError {
    OutlineError::NoSuchPart { wanted: wanted.to_string(), count: 0, names: String::new() }
}

/// The most names that a message lists.
const MOST_NAMES: usize = 12;

fn listed(names: &[Option<&str>]) -> String {
    let mut listed: Vec<&str> = names.iter().flatten().copied().take(MOST_NAMES + 1).collect();
    if listed.len() > MOST_NAMES {
        listed[MOST_NAMES] = "…";
    }
    listed.join(", ")
}
