//! `--pin P:Q` of `riemap map`: boundary pairs instead of a point and a boundary point.

use super::CliError;
use super::progress::Progress;
use super::side::{Asked, NamedSide, Placed, SideAnchor};
use crate::conformal::{ConformalMap, Constraints, MOST_PINS, PerSide, PinError, Pins};
use std::str::FromStr;

/// The option's name, for messages.
pub const OPTION: &str = "--pin";

/// The pairs that determine a map.
#[derive(Debug, clap::Args)]
pub struct PinArguments {
    /// A boundary point of the source and its image on the target's boundary, each given as an anchor: X,Y of an
    /// outline, X,Y,Z or a boundary vertex V of a surface, @S anywhere. Three of them determine the map, in place of
    /// points and anchors; more are met by least squares. They run around both sides in the same order.
    #[arg(long = "pin", value_name = "P:Q", allow_hyphen_values = true,
          conflicts_with_all = ["source_point", "target_point", "source_anchor", "target_anchor", "criterion"])]
    pub pins: Vec<PinArgument>,
}

/// A boundary point of the source and one of the target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PinArgument(PerSide<SideAnchor>);

impl FromStr for PinArgument {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (source, target) = text.split_once(':').ok_or("expected P:Q, such as @0.25:@0.5")?;
        let anchor = |text: &str| text.parse().map_err(|reason| format!("{text}: {reason}"));
        Ok(Self(PerSide::new(anchor(source)?, anchor(target)?)))
    }
}

impl PinArgument {
    /// The pair as it is given: P, then Q.
    pub const fn pair(&self) -> (SideAnchor, SideAnchor) {
        (self.0.source, self.0.target)
    }
}

/// Checks the number of pairs, if there are any.
pub fn check_count(count: usize) -> Result<(), CliError> {
    if count > 0 && !(3..=MOST_PINS).contains(&count) {
        let text = format!("{OPTION}: three pairs determine a map, up to {MOST_PINS} can be given, {count} are");
        return Err(CliError::Usage(text));
    }
    Ok(())
}

impl PinArguments {
    /// The pairs; none if the option is not given. Checks that they fit the sides' kinds.
    pub fn check(&self, asked: &[Asked<'_>; 2]) -> Result<Option<&[PinArgument]>, CliError> {
        check_count(self.pins.len())?;
        if self.pins.is_empty() {
            return Ok(None);
        }
        for PinArgument(pair) in &self.pins {
            asked[0].check_anchor(OPTION, pair.source)?;
            asked[1].check_anchor(OPTION, pair.target)?;
        }
        Ok(Some(&self.pins))
    }
}

/// How often sides are prepared anew for the points that came out.
const ROUNDS: usize = 2;

/// The pins and the constraints of the map through them. An outline whose equation does not resolve its point is
/// prepared anew with that point.
pub fn constraints(
    pins: &[PinArgument],
    [source, target]: [&mut NamedSide; 2],
    progress: &Progress,
) -> Result<(Pins, Constraints), CliError> {
    let place = |PinArgument(given): &PinArgument| {
        Ok(PerSide::new(source.anchor(OPTION, given.source)?, target.anchor(OPTION, given.target)?))
    };
    let pairs = pins.iter().map(place).collect::<Result<Vec<_>, CliError>>()?;
    let pins = Pins::new(pairs).map_err(|error| refused(&error))?;
    for _ in 0..ROUNDS {
        let Constraints { points, .. } = found(&pins, [source, target])?;
        let changes = [source.resolve(points.source, progress)?, target.resolve(points.target, progress)?];
        if changes == [false; 2] {
            break;
        }
    }
    let constraints = found(&pins, [source, target])?;
    Ok((pins, constraints))
}

fn found(pins: &Pins, [source, target]: [&NamedSide; 2]) -> Result<Constraints, CliError> {
    let sides = PerSide::new(source.subdivided.clone(), target.subdivided.clone());
    let found = pins.constraints(PerSide::new(sides.source.finest(), sides.target.finest()), None);
    found.map(|found| sides.own(&found)).map_err(|error| refused(&error))
}

/// A pin's error, with the option's name.
pub fn refused(error: &PinError) -> CliError {
    CliError::Input(format!("{OPTION}: {error}"))
}

/// What `--json` says of the pins, and the four constraints that came out.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Pinned {
    pins: Vec<Pin>,
    #[serde(flatten)]
    constraints: Placed,
}

#[derive(Debug, Clone, PartialEq, serde::Serialize)]
struct Pin {
    /// Fractions of the boundaries' lengths.
    source: f64,
    target: f64,
    /// The distance of the source's image from the target.
    miss: f64,
}

impl Pinned {
    /// The outcome for a map through `pins`.
    pub fn of(
        map: &ConformalMap,
        pins: &Pins,
        constraints: &Constraints,
        sides: [&NamedSide; 2],
    ) -> Result<Self, CliError> {
        let misses = pins.checked_misses(map.finest()).map_err(|error| refused(&error))?;
        let pin = |(pair, miss): (&PerSide<f64>, f64)| Pin { source: pair.source, target: pair.target, miss };
        Ok(Self {
            pins: pins.pairs().iter().zip(misses).map(pin).collect(),
            constraints: Placed::of(constraints, sides)?,
        })
    }

    /// The largest miss.
    pub fn miss(&self) -> f64 {
        self.pins.iter().fold(0.0, |largest, pin| largest.max(pin.miss))
    }
}
