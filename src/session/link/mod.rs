//! Links: a session as the fragment of an address, `s=1.` or `s=2.` and a payload that needs no escaping.
//!
//! | content | file |
//! |---|---|
//! | version 1, frozen | `version1` |
//! | version 2: surfaces on either side, curves, and later additions | `version2` |
//! | the numbers of enum values | `codes` |
//! | polygons in 16 bits | `quantized` |
//! | outlines with curves: points in 24 bits, or the pieces of a path | `curves` |
//! | outlines that are too long, with as many points as fit | `shortened`, `thinning` |
//! | deflate and base 64 | `envelope` |
//! | what is packed, for lessons | `state` |
//!
//! Guarantees: for any input, [`decode`] returns a session that [`Session::check`] accepts, with simple
//! polygons, or an error; it does not panic and allocates less than 8 MiB in all. Decoding the result of
//! [`encode`] gives the same session, except that polygons are rounded to 16 bits, points of smooth
//! curves to 24, long names are cut, and outlines that are too long have fewer points ([`Encoded::shortened`]); encoding and decoding again changes nothing more. Links of both versions will always open.
//!
//! The oldest version that holds the session is written, since the recipient's riemap may be an older one, for
//! example one installed for use without a network.

mod codes;
mod curves;
mod envelope;
mod quantized;
mod region;
mod shortened;
mod state;
mod thinning;
mod version1;
mod version2;

use super::{OutOfRange, OutlineSpec, Session};
use crate::conformal::{PerSide, PinError, Pins, Side};
use crate::geometry::{DVec2, PolygonError};
use crate::optimization::Dab;
use curves::WiredCurve;
pub(super) use envelope::{pack, unpack};
use quantized::Quantized;
use serde::de::DeserializeOwned;
pub(super) use state::State;
use version1::{STAND_IN, Version1, WiredOutline, short_name};
use version2::Version2;

/// The maximal length of a fragment that address bars, messengers and readers of QR codes still accept.
pub const MAX_LENGTH: usize = 8 << 10;

/// The prefix of the state among the parts of a fragment.
const KEY: &str = "s=";
/// The newest version that is written and read.
pub const NEWEST: &str = "2";

/// A link, and the outlines that it holds with fewer points or not at all.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Encoded {
    /// The part of the address after `#`.
    pub fragment: String,
    /// The outlines that are not in the fragment and must be sent as files.
    pub left_out: Vec<LeftOut>,
    /// The outlines that are in the fragment with fewer points than they have.
    pub shortened: Vec<ShortenedOutline>,
}

/// An outline that a link holds with fewer points, because all of them would make the link too long.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("the {side}'s outline \"{name}\" has {to} of its {from} points in the link: it moves by at most {} of its size", percent(*deviation))]
#[non_exhaustive]
pub struct ShortenedOutline {
    /// The side of the session that has the outline.
    pub side: Side,
    /// The name of the outline, cut as in the link.
    pub name: String,
    /// The number of its points.
    pub from: usize,
    /// The number of points in the link.
    pub to: usize,
    /// The largest distance between the two outlines, in sizes of the outline (the longer side of its box).
    pub deviation: f64,
}

/// A share as a percentage of two digits, rounded up, with a decimal point.
pub fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    if percent <= 0.0 {
        return String::from("0\u{a0}%");
    }
    let digits = (1.0 - percent.log10().floor()).clamp(0.0, 12.0);
    let rounded = (percent * 10_f64.powf(digits)).ceil() / 10_f64.powf(digits);
    format!("{rounded:.0$}\u{a0}%", digits as usize)
}

/// An outline that a link does not hold.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("the {side}'s outline \"{name}\" is not in the link: {reason}. It travels as a file")]
#[non_exhaustive]
pub struct LeftOut {
    /// The side of the session that has the outline.
    pub side: Side,
    /// The name of the outline, cut as in the link.
    pub name: String,
    /// The reason.
    pub reason: NotCarried,
}

/// The reason why an outline is not in a link.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NotCarried {
    /// It has too many points.
    #[error("its {points} points take more than {MAX_LENGTH} characters")]
    TooLong {
        /// The number of points after quantization.
        points: usize,
    },
    /// Rounded to the bits of a link it is no longer a simple polygon.
    #[error("it is finer than a link can tell ({0})")]
    NotSimple(PolygonError),
    /// Rounding it twice gives another result than rounding it once.
    #[error("it lies too far from the origin for its size")]
    Inexact,
}

/// The content of a link.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Decoded {
    /// The session, with a disk in place of each missing outline.
    pub session: Session,
    /// The outlines that must be loaded from files.
    pub missing: Vec<MissingOutline>,
}

impl Decoded {
    /// A session whose outlines are all there.
    pub fn complete(session: Session) -> Self {
        Self { session, missing: Vec::new() }
    }
}

/// An outline of which a link has only the name, and the points to set once its file is loaded.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct MissingOutline {
    /// The side of the session that has the outline.
    pub side: Side,
    /// The name of the outline.
    pub name: String,
    /// The interior point to set.
    pub interior: Option<DVec2>,
    /// The boundary point to set, as a fraction of arc length.
    pub anchor: f64,
    /// The pins to set once no outline is missing.
    pub pins: Option<Pins>,
    /// The region painted on it, to set with its points.
    pub region: Vec<Dab>,
}

impl MissingOutline {
    /// Whether `outline` has the link's name, which may have been cut.
    pub fn is_named(&self, outline: &OutlineSpec) -> bool {
        matches!(outline, OutlineSpec::Points { name, .. } if short_name(name) == self.name)
    }

    /// Whether `outline` is the disk that [`Decoded`] puts in place of a missing outline.
    pub fn is_stand_in(outline: &OutlineSpec) -> bool {
        *outline == OutlineSpec::Preset(STAND_IN)
    }
}

/// The kinds of things that a link encodes by a name or a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Choice {
    /// The direction.
    #[error("direction")]
    Direction,
    /// The extension.
    #[error("extension")]
    Extension,
    /// A side.
    #[error("side")]
    Side,
    /// The kernel.
    #[error("kernel mode")]
    Kernel,
    /// The solver.
    #[error("solver")]
    Solver,
    /// What the triangles are colored by.
    #[error("coloring")]
    Colouring,
    /// The texture.
    #[error("texture")]
    Texture,
    /// The comparison.
    #[error("comparison")]
    Comparison,
    /// A section from a later version.
    #[error("setting")]
    Setting,
    /// A built-in outline.
    #[error("outline")]
    Outline,
    /// A built-in surface.
    #[error("surface")]
    Surface,
}

/// Why a link cannot be opened.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LinkError {
    /// There is no `s=` in it.
    #[error("this is not a link to a session: there is no #s=… in it")]
    NoSession,
    /// It is longer than [`MAX_LENGTH`].
    #[error("the link is too long: {length} characters where {MAX_LENGTH} are the most")]
    TooLong {
        /// Its length in characters.
        length: usize,
    },
    /// It is of a format that this program does not know.
    #[error("the link is of format {found}, made by a newer riemap; this one opens format {NEWEST}")]
    Version {
        /// Its format, or the beginning of what is written there instead.
        found: String,
    },
    /// It was cut off or changed on its way.
    #[error("the link is damaged: it was cut off or changed on its way")]
    Damaged,
    /// It unpacks to more than a session can contain.
    #[error("the link holds more than a session can be")]
    TooMuch,
    /// It contains a name or number that this program does not know.
    #[error("the link asks for the {what} \"{name}\", which this version of riemap does not know")]
    Unknown {
        /// The kind of thing.
        what: Choice,
        /// The name or number.
        name: String,
    },
    /// A number is not finite or outside the range of its control.
    #[error("the link cannot be used: {0}")]
    OutOfRange(#[from] OutOfRange),
    /// The pins determine no map.
    #[error("the link's pins cannot be used: {0}")]
    Pins(PinError),
    /// An outline is not a simple polygon.
    #[error("the link's outline of the {side} cannot be used: {reason}")]
    Outline {
        /// The side with the outline.
        side: Side,
        /// What is wrong with the outline.
        reason: PolygonError,
    },
}

/// Encodes a session. Outlines that are too long are shortened; what does not fit even so is left out, the longest first.
///
/// Errors: a number outside the range of its control.
pub fn encode(session: &Session) -> Result<Encoded, OutOfRange> {
    session.check()?;
    let outlines = PerSide::from_fn(|side| prepared(&session.domain(side).outline));
    let is_too_long = outlines.iter().any(|(_, outline)| outline.is_too_long());
    if let Some(fragment) = fragment(session, &outlines).filter(|_| !is_too_long) {
        return Ok(Encoded { fragment, left_out: left_out(&outlines), shortened: Vec::new() });
    }
    let mut shortened = shortened::shortened(session);
    let short = shortened::applied(session, &shortened);
    let mut outlines = PerSide::from_fn(|side| prepared(&short.domain(side).outline));
    loop {
        for side in Side::BOTH {
            if matches!(outlines[side], Prepared::LeftOut { .. }) {
                // the points are those of the whole outline, which travels as a file
                shortened[side] = None;
            }
        }
        if let Some(fragment) = fragment(&shortened::applied(session, &shortened), &outlines) {
            let told = Side::BOTH.into_iter().filter_map(|side| {
                let short = shortened[side].as_ref()?;
                let OutlineSpec::Points { name, polygon, .. } = &session.domain(side).outline else { return None };
                let (from, to) = (polygon.vertices().len(), short.len());
                Some(ShortenedOutline { side, name: short_name(name), from, to, deviation: short.deviation })
            });
            return Ok(Encoded { fragment, left_out: left_out(&outlines), shortened: told.collect() });
        }
        leave_out_longest(&mut outlines);
    }
}

/// The outlines that are left out.
fn left_out(outlines: &PerSide<Prepared>) -> Vec<LeftOut> {
    let left_out = outlines.iter().filter_map(|(side, outline)| {
        let Prepared::LeftOut { name, reason } = outline else { return None };
        Some(LeftOut { side, name: name.clone(), reason: reason.clone() })
    });
    left_out.collect()
}

/// Decodes a link: a whole address, its fragment with or without `#`, or one part of the fragment.
pub fn decode(link: &str) -> Result<Decoded, LinkError> {
    let state = state_of(link).ok_or(LinkError::NoSession)?;
    if state.len() > MAX_LENGTH {
        return Err(LinkError::TooLong { length: state.len() });
    }
    let (version, payload) = state.split_once('.').unwrap_or((state, ""));
    let read = match version {
        "1" => |bytes: &[u8]| whole::<Version1>(bytes)?.session(),
        NEWEST => |bytes: &[u8]| whole::<Version2>(bytes)?.session(),
        other => return Err(unknown_version(other)),
    };
    let decoded = read(&envelope::unpack(payload)?)?;
    decoded.session.check()?;
    Ok(decoded)
}

/// Decodes all of `bytes` from postcard's encoding; bytes left over are an error.
pub(super) fn whole<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, LinkError> {
    match postcard::take_from_bytes(bytes) {
        Ok((value, [])) => Ok(value),
        _ => Err(LinkError::Damaged),
    }
}

fn unknown_version(version: &str) -> LinkError {
    let is_number = !version.is_empty() && version.bytes().all(|byte| byte.is_ascii_digit());
    let found = version.chars().take(9).collect();
    if is_number { LinkError::Version { found } } else { LinkError::Damaged }
}

/// Whether a text contains the part that [`decode`] reads.
pub fn is_link(text: &str) -> bool {
    state_of(text).is_some()
}

/// The text after `s=` in the fragment; without `#` the whole text is the fragment.
fn state_of(link: &str) -> Option<&str> {
    let link = link.trim();
    let fragment = link.split_once('#').map_or(link, |(_, fragment)| fragment);
    fragment.split('&').find_map(|part| part.strip_prefix(KEY))
}

/// The part of a link's fragment that [`decode`] reads, alone; empty if there is none.
pub(super) fn alone(link: &str) -> String {
    state_of(link).map(|state| format!("{KEY}{state}")).unwrap_or_default()
}

/// An outline, quantized before it is written into a link.
enum Prepared {
    Preset(String),
    Points { name: String, points: Quantized },
    Curve { name: String, curve: WiredCurve },
    LeftOut { name: String, reason: NotCarried },
}

fn prepared(outline: &OutlineSpec) -> Prepared {
    match outline {
        OutlineSpec::Preset(preset) => Prepared::Preset(preset.name().to_owned()),
        OutlineSpec::Points { name, polygon, form } => {
            let name = short_name(name);
            let prepared = if outline.is_only_polygon() {
                Quantized::of(polygon.vertices()).map(|points| Prepared::Points { name: name.clone(), points })
            } else {
                WiredCurve::of(polygon, form).map(|curve| Prepared::Curve { name: name.clone(), curve })
            };
            prepared.unwrap_or_else(|reason| Prepared::LeftOut { name, reason })
        }
    }
}

impl Prepared {
    fn wired(&self) -> WiredOutline {
        match self {
            Self::Preset(name) => WiredOutline::Preset(name.clone()),
            Self::Points { name, points } => WiredOutline::Points { name: name.clone(), points: points.clone() },
            Self::Curve { name, .. } | Self::LeftOut { name, .. } => WiredOutline::File { name: name.clone() },
        }
    }

    /// Whether it is left out for its length.
    fn is_too_long(&self) -> bool {
        matches!(self, Self::LeftOut { reason: NotCarried::TooLong { .. }, .. })
    }

    /// The curve, which only version 2 holds.
    fn curve(&self) -> Option<&WiredCurve> {
        if let Self::Curve { curve, .. } = self { Some(curve) } else { None }
    }

    fn point_count(&self) -> usize {
        match self {
            Self::Points { points, .. } => points.len(),
            Self::Curve { curve, .. } => curve.len(),
            Self::Preset(_) | Self::LeftOut { .. } => 0,
        }
    }
}

/// The fragment, or `None` if it is too long; without points it never is.
fn fragment(session: &Session, outlines: &PerSide<Prepared>) -> Option<String> {
    let wired = outlines.as_ref().map(Prepared::wired);
    let curves = outlines.as_ref().map(Prepared::curve);
    let has_curves = curves.iter().any(|(_, curve)| curve.is_some());
    let (version, bytes) = if version2::is_needed(session) || has_curves {
        (NEWEST, postcard::to_allocvec(&Version2::new(session, wired, &curves)?))
    } else {
        ("1", postcard::to_allocvec(&Version1::new(session, wired)))
    };
    framed(version, &bytes.ok()?)
}

fn framed(version: &str, bytes: &[u8]) -> Option<String> {
    let fragment = format!("{KEY}{version}.{}", envelope::pack(bytes)?);
    (fragment.len() <= MAX_LENGTH).then_some(fragment)
}

fn leave_out_longest(outlines: &mut PerSide<Prepared>) {
    let PerSide { source, target } = outlines;
    let longest = if target.point_count() > source.point_count() { target } else { source };
    let points = longest.point_count();
    if let Prepared::Points { name, .. } | Prepared::Curve { name, .. } = longest {
        *longest = Prepared::LeftOut { name: std::mem::take(name), reason: NotCarried::TooLong { points } };
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod shortened_tests;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
