//! Whether stated errors cover: 200 cases, fixed before the estimates were tuned on them, whose truth is a closed form, a
//! table of Schwarz–Christoffel integrals to 30 digits, or the same figure rotated and enlarged. Prints a table by kind.

#![cfg(feature = "io")]
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod closed;
mod invariants;
mod judge;
mod maps;

/// Cases that are not covered, each with its cause. The list must shrink: a case of it that is covered fails the test.
const KNOWN: &[(&str, &str)] = &[
    ("notch 0.5 from 0+0i", NARROW),
    ("notch 0.5 from 0.3+0.2i", NARROW),
    ("digon 0.03 π from 0+0i", CLOSE),
    ("digon 0.03 π from -0.2+0.4i", CLOSE),
    ("Digon { alpha: 0.5, from: 0.0 } of 0, Forward", ROUNDED),
];

/// Causes.
const CLOSE: &str = "two arcs next to each other in a corner, the same";
const NARROW: &str = "rounding of 3e-14 at the tip, where 2e-14 are stated";
const ROUNDED: &str = "next to a corner of the half-disk, rounding of a few images is three times what is stated";

/// Kinds whose errors are stated more than 100 times too large in the median.
const TOO_LARGE: &[&str] = &["polygons", "boundary images", "points"];

/// Makes the cases of one group.
type Group = fn() -> Vec<judge::Case>;

#[test]
fn stated_errors_cover() {
    let groups: [(&str, Group); 8] = [
        ("lists", invariants::lists),
        ("tabled", invariants::tabled),
        ("pairs", invariants::pairs),
        ("channels", invariants::channels),
        ("digons", invariants::digons),
        ("maps", maps::maps),
        ("grids", maps::grids),
        ("projections", maps::projections),
    ];
    let mut cases = Vec::new();
    for (name, group) in groups {
        let start = std::time::Instant::now();
        cases.extend(group());
        println!("{name}: {:.1} s", start.elapsed().as_secs_f64());
    }
    judge::judge(&cases, KNOWN, TOO_LARGE);
}
