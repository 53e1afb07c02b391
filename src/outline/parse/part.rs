//! Which part of a file is meant: a shape of a drawing or a feature of a map, by its name or its number.

use super::OutlineError;

/// The index of the part with the name `wanted`, or else of number `wanted`, counted from 1.
pub(super) fn find(wanted: &str, names: &[Option<&str>]) -> Result<usize, OutlineError> {
    let named = names.iter().position(|name| *name == Some(wanted));
    let numbered = || wanted.parse().ok().and_then(|number: usize| number.checked_sub(1)).filter(|&k| k < names.len());
    named.or_else(numbered).ok_or_else(|| OutlineError::NoSuchPart {
        wanted: wanted.to_owned(),
        count: names.len(),
        names: listed(names),
    })
}

/// There is no part of any name.
pub(super) fn single(wanted: &str) -> OutlineError {
    OutlineError::NoSuchPart { wanted: wanted.to_owned(), count: 0, names: String::new() }
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
