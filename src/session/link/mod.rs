//! Links: a session as the fragment of an address, `s=1.` and a payload that needs no escaping.
//!
//! | what | file |
//! |---|---|
//! | what version 1 holds, for ever | `version1` |
//! | the numbers of choices | `codes` |
//! | outlines in 16 bits | `quantised` |
//! | deflate and base 64 | `envelope` |
//!
//! Guarantees: [`decode`] gives a session that [`Session::check`] accepts, with simple polygons, or
//! says why not; it does not panic, and allocates less than 8 MiB in all, whatever it is
//! given. Decoding what [`encode`] gave is the session again, but for the outlines' rounding to 16
//! bits and the ends of long names; a second time nothing changes. A link of version 1 opens for ever.

mod codes;
mod envelope;
mod quantised;
mod version1;

use super::{OutOfRange, OutlineSpec, Session};
use crate::conformal::Side;
use crate::geometry::{DVec2, PolygonError};
use quantised::Quantised;
use version1::{STAND_IN, Version1, WiredOutline, short_name};

/// The most characters of a fragment: what address bars, messengers and QR codes' readers still take.
pub const MAX_LENGTH: usize = 8 << 10;

/// The name of the state among the parts of a fragment.
const KEY: &str = "s=";
/// The format that is written.
const VERSION: &str = "1";

/// A link, and what it does not hold.
#[derive(Debug, Clone, PartialEq)]
pub struct Encoded {
    /// What comes after the address and `#`.
    pub fragment: String,
    /// Outlines that have to travel as a file; everything else is in the fragment.
    pub left_out: Vec<LeftOut>,
}

/// An outline that a link does not hold.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("the {side}'s outline \"{name}\" is not in the link: {reason}. It travels as a file")]
pub struct LeftOut {
    /// Whose it is.
    pub side: Side,
    /// Its name.
    pub name: String,
    /// Why.
    pub reason: NotCarried,
}

/// Why an outline is not in a link.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NotCarried {
    /// It has too many points.
    #[error("its {points} points take more than {MAX_LENGTH} characters")]
    TooLong {
        /// The points that are left after quantisation.
        points: usize,
    },
    /// Rounded to 16 bits it is not a simple polygon any more.
    #[error("it is finer than a link can tell ({0})")]
    NotSimple(PolygonError),
    /// Rounding it twice is not the same as rounding it once.
    #[error("it lies too far from the origin for its size")]
    Inexact,
}

/// What a link holds.
#[derive(Debug, Clone, PartialEq)]
pub struct Decoded {
    /// The session; a disk stands in for each outline that is missing.
    pub session: Session,
    /// The outlines that travel as files.
    pub missing: Vec<MissingOutline>,
}

/// An outline that a link only names, and where its points are.
#[derive(Debug, Clone, PartialEq)]
pub struct MissingOutline {
    /// Whose it is.
    pub side: Side,
    /// Its name.
    pub name: String,
    /// Where the interior point is, once the outline is there.
    pub interior: Option<DVec2>,
    /// Where the boundary point is, as a fraction of arc length.
    pub anchor: f64,
}

impl MissingOutline {
    /// Whether `outline` has the name that the link gives, whose end may have been cut off.
    pub fn is_named(&self, outline: &OutlineSpec) -> bool {
        matches!(outline, OutlineSpec::Points { name, .. } if short_name(name) == self.name)
    }

    /// Whether `outline` is the disk that [`Decoded`] has in the place of a missing one.
    pub fn is_stand_in(outline: &OutlineSpec) -> bool {
        *outline == OutlineSpec::Preset(STAND_IN)
    }
}

/// Why a link is not opened.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LinkError {
    /// There is no `s=` in it.
    #[error("this is not a link to a session: there is no #s=… in it")]
    NoSession,
    /// It is longer than any that is made.
    #[error("the link is too long: {length} characters where {MAX_LENGTH} are the most")]
    TooLong {
        /// Its length.
        length: usize,
    },
    /// It is of another version of the format.
    #[error("the link is of format {found}, made by a newer riemap; this one opens format {VERSION}")]
    Version {
        /// Its version, or the beginning of what stands in its place.
        found: String,
    },
    /// It was cut off or changed on its way.
    #[error("the link is damaged: it was cut off or changed on its way")]
    Damaged,
    /// It unpacks to more than a session can be.
    #[error("the link holds more than a session can be")]
    TooMuch,
    /// It means something that is not known here.
    #[error("the link asks for the {what} \"{name}\", which this version of riemap does not know")]
    Unknown {
        /// What kind of thing.
        what: &'static str,
        /// Its name or number.
        name: String,
    },
    /// A number is not finite, or beyond what its control allows.
    #[error("the link cannot be used: {0}")]
    OutOfRange(#[from] OutOfRange),
    /// An outline is not a simple polygon.
    #[error("the link's outline of the {side} cannot be used: {reason}")]
    Outline {
        /// Whose it is.
        side: Side,
        /// What is wrong with it.
        reason: PolygonError,
    },
}

/// The link of a session. Outlines that do not fit are left out, the longest first.
///
/// Errors: numbers that the session's controls do not allow.
pub fn encode(session: &Session) -> Result<Encoded, OutOfRange> {
    session.check()?;
    let mut outlines = [&session.source, &session.target].map(|domain| prepared(&domain.outline));
    loop {
        if let Some(fragment) = fragment(session, &outlines) {
            let left_out = Side::BOTH.into_iter().zip(&outlines).filter_map(|(side, outline)| {
                let Prepared::LeftOut { name, reason } = outline else { return None };
                Some(LeftOut { side, name: name.clone(), reason: reason.clone() })
            });
            return Ok(Encoded { fragment, left_out: left_out.collect() });
        }
        leave_out_longest(&mut outlines);
    }
}

/// The session of a link: a whole address, its fragment with or without `#`, or one part of that.
pub fn decode(link: &str) -> Result<Decoded, LinkError> {
    let state = state_of(link).ok_or(LinkError::NoSession)?;
    if state.len() > MAX_LENGTH {
        return Err(LinkError::TooLong { length: state.len() });
    }
    let (version, payload) = state.split_once('.').unwrap_or((state, ""));
    if version != VERSION {
        let is_number = !version.is_empty() && version.bytes().all(|byte| byte.is_ascii_digit());
        let found = version.chars().take(9).collect();
        return Err(if is_number { LinkError::Version { found } } else { LinkError::Damaged });
    }
    let bytes = envelope::unpack(payload)?;
    let (wired, rest) = postcard::take_from_bytes::<Version1>(&bytes).map_err(|_| LinkError::Damaged)?;
    if !rest.is_empty() {
        return Err(LinkError::Damaged);
    }
    let decoded = wired.session()?;
    decoded.session.check()?;
    Ok(decoded)
}

/// Whether a text is meant as a link: whether it has the part that [`decode`] reads.
pub fn is_link(text: &str) -> bool {
    state_of(text).is_some()
}

/// What follows `s=` in the fragment, which is the whole text if there is no `#`.
fn state_of(link: &str) -> Option<&str> {
    let link = link.trim();
    let fragment = link.split_once('#').map_or(link, |(_, fragment)| fragment);
    fragment.split('&').find_map(|part| part.strip_prefix(KEY))
}

/// An outline on its way into a link.
enum Prepared {
    Preset(String),
    Points { name: String, points: Quantised },
    LeftOut { name: String, reason: NotCarried },
}

fn prepared(outline: &OutlineSpec) -> Prepared {
    match outline {
        OutlineSpec::Preset(preset) => Prepared::Preset(preset.name().to_owned()),
        OutlineSpec::Points { name, points } => {
            let name = short_name(name);
            match Quantised::of(points) {
                Ok(points) => Prepared::Points { name, points },
                Err(reason) => Prepared::LeftOut { name, reason },
            }
        }
    }
}

impl Prepared {
    fn wired(&self) -> WiredOutline {
        match self {
            Self::Preset(name) => WiredOutline::Preset(name.clone()),
            Self::Points { name, points } => WiredOutline::Points { name: name.clone(), points: points.clone() },
            Self::LeftOut { name, .. } => WiredOutline::File { name: name.clone() },
        }
    }

    fn point_count(&self) -> usize {
        if let Self::Points { points, .. } = self { points.len() } else { 0 }
    }
}

/// The fragment, if it is not too long; without points it never is.
fn fragment(session: &Session, outlines: &[Prepared; 2]) -> Option<String> {
    let wired = Version1::new(session, outlines.each_ref().map(Prepared::wired));
    let payload = envelope::pack(&postcard::to_allocvec(&wired).ok()?)?;
    let fragment = format!("{KEY}{VERSION}.{payload}");
    (fragment.len() <= MAX_LENGTH).then_some(fragment)
}

fn leave_out_longest(outlines: &mut [Prepared; 2]) {
    let [a, b] = outlines.each_ref().map(Prepared::point_count);
    let longest = &mut outlines[usize::from(b > a)];
    if let Prepared::Points { name, points } = longest {
        let reason = NotCarried::TooLong { points: points.len() };
        *longest = Prepared::LeftOut { name: std::mem::take(name), reason };
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
