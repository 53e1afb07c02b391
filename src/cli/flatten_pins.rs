//! `--pin P:Q` of `riemap flatten`: pairs of a boundary point of the surface and one of the outline.

use super::CliError;
use super::flatten_arguments::SurfaceAnchor;
use super::pins::{OPTION, PinArgument, check_count, refused};
use super::progress::Progress;
use super::side::{NamedSide, SideAnchor};
use super::values::Anchor;
use crate::conformal::{ConformalMap, Constraints, PerSide, Pins, PreparedSide, Subdivided};
use crate::surface::Surface;

/// How often the outline is prepared anew for the point that came out.
const ROUNDS: usize = 2;

/// What `--json` says of a pin: fractions of the boundaries' lengths, and the distance on the surface between its point and
/// the preimage of its point of the outline.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Pin {
    surface: f64,
    outline: f64,
    miss: f64,
}

/// The pins and the constraints of the map through them; `None` without pins. An outline whose equation does not resolve its
/// point is prepared anew with that point. `read` is the surface as it was read.
pub fn constraints(
    given: &[PinArgument],
    outline: &mut NamedSide,
    (read, surface): (&Surface, &Subdivided),
    progress: &Progress,
) -> Result<Option<(Pins, Constraints)>, CliError> {
    check_count(given.len())?;
    if given.is_empty() {
        return Ok(None);
    }
    let pairs = given.iter().map(|pin| pair(pin, outline, (read, surface.own()))).collect::<Result<Vec<_>, _>>()?;
    let pins = Pins::new(pairs).map_err(|error| refused(&error))?;
    let found = |outline: &NamedSide| {
        let sides = PerSide::new(outline.subdivided.clone(), surface.clone());
        let found = pins.constraints(PerSide::new(sides.source.finest(), sides.target.finest()), None);
        found.map(|found| sides.own(&found)).map_err(|error| refused(&error))
    };
    let mut constraints = found(outline)?;
    for _ in 0..ROUNDS {
        if !outline.resolve(constraints.points.source, progress)? {
            break;
        }
        constraints = found(outline)?;
    }
    Ok(Some((pins, constraints)))
}

/// The fractions of a pair; the source is the outline.
fn pair(
    pin: &PinArgument,
    outline: &NamedSide,
    (read, surface): (&Surface, &PreparedSide),
) -> Result<PerSide<f64>, CliError> {
    let (on_surface, on_outline) = pin.pair();
    let meshed = surface.surface();
    let surface = match (on_surface, meshed) {
        (SideAnchor::Fraction(s), _) => s.rem_euclid(1.0),
        (SideAnchor::Plane(Anchor::Vertex(vertex)), Some(meshed)) => {
            SurfaceAnchor::Vertex(vertex).fraction(OPTION, read, meshed)?
        }
        (SideAnchor::Surface(anchor), Some(meshed)) => anchor.fraction(OPTION, read, meshed)?,
        _ => return Err(CliError::Usage(format!("{OPTION}: P is a surface's: V, X,Y,Z or @S is meant"))),
    };
    Ok(PerSide::new(outline.anchor(OPTION, on_outline)?, surface))
}

/// The pins with their misses in a map through them.
pub fn met(map: &ConformalMap, pins: &Pins) -> Result<Vec<Pin>, CliError> {
    let misses = pins.checked_misses(map.finest()).map_err(|error| refused(&error))?;
    let pin = |(pair, miss): (&PerSide<f64>, f64)| Pin { surface: pair.target, outline: pair.source, miss };
    Ok(pins.pairs().iter().zip(misses).map(pin).collect())
}

/// The largest miss in words, as a line after a line break.
pub fn in_words(pins: &[Pin]) -> String {
    let miss = pins.iter().map(|pin| pin.miss).reduce(f64::max);
    miss.map(|miss| format!("\nthe pins are met to {miss:.1e}")).unwrap_or_default()
}
