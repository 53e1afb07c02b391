//! The session with which the app starts: from its address, from the stored copy, or the default.

use crate::language::{Message, key};
use crate::session::link::{self, Decoded, MissingOutline};
use crate::session::{Session, file};

/// The session to start with.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Start {
    /// The session.
    pub session: Session,
    /// The outlines that its link only names.
    pub missing: Vec<MissingOutline>,
    /// The errors of the link and the copy.
    pub message: Option<Message>,
}

/// The session to start with: that of the link in the `address`, else the stored copy `kept`, else the default.
///
/// If the link in the address is that of the copy, as after a reload, the copy is used, since it also holds what
/// a link may leave out. The decoded links are compared, because another version may encode the same link differently.
pub fn first_session(address: Option<&str>, kept: Option<&str>) -> Start {
    let (kept, user_error) = match kept.map(|text| file::read(text.as_bytes())) {
        Some(Ok(kept)) => (Some(kept), None),
        Some(Err(error)) => (None, Some(key::last_session_not_opened(Message::from(&error)))),
        None => (None, None),
    };
    let Some(address) = address else {
        return Start { session: kept.unwrap_or_default(), missing: Vec::new(), message: user_error };
    };
    let opened = link::decode(address);
    if let Some(kept) = kept.filter(|kept| opened.as_ref().is_ok_and(|opened| is_link_of(opened, kept))) {
        return Start { session: kept, ..Start::default() };
    }
    let (Decoded { session, missing }, about_link) = match opened {
        Ok(decoded) => {
            let text = missing_text(&decoded.missing);
            (decoded, text)
        }
        Err(error) => {
            let standard = Decoded { session: Session::default(), missing: Vec::new() };
            (standard, Some(key::link_not_opened(Message::from(&error))))
        }
    };
    let messages = about_link.into_iter().chain(user_error);
    Start { session, missing, message: Message::joined(messages, key::sentence_and) }
}

/// Whether the link of `session` decodes to `opened`.
fn is_link_of(opened: &Decoded, session: &Session) -> bool {
    link::encode(session).is_ok_and(|encoded| link::decode(&encoded.fragment).as_ref() == Ok(opened))
}

/// The message about outlines that a link does not hold.
pub fn missing_text(missing: &[MissingOutline]) -> Option<Message> {
    let each = missing.iter().map(|missing| key::link_misses_outline(missing.side, &missing.name));
    Message::joined(each, key::both_sentences)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::session::{Command, scaled};

    #[test]
    fn the_address_comes_before_the_copy_and_that_before_the_default() {
        let kept = file::write(&scaled(5.0)).unwrap();
        let other = link::encode(&scaled(9.0)).unwrap().fragment;
        assert_eq!(first_session(None, None), Start::default());
        assert_eq!(first_session(None, Some(&kept)).session, scaled(5.0));
        assert_eq!(first_session(Some(&other), Some(&kept)).session, scaled(9.0));
        let damaged = first_session(Some("#s=1.AAAA"), Some(&kept));
        assert_eq!(damaged.session, Session::default());
        assert!(damaged.message.unwrap().english().contains("could not be opened"));
    }

    /// Points that coincide after rounding to 16 bits are restored from the copy.
    #[test]
    fn a_reload_brings_back_what_the_link_rounds() {
        let points = [(0.1, 0.2), (1.0 / 3.0, 1e-12), (0.7, 0.9), (0.333, 0.77)].map(crate::geometry::DVec2::from);
        let mut drawn = scaled(5.0);
        let polygon = points.to_vec().try_into().unwrap();
        let outline = crate::session::OutlineSpec::points("drawn".into(), polygon);
        drawn.apply(Command::SetOutline { side: crate::conformal::Side::Source, outline });
        let fragment = link::encode(&drawn).unwrap().fragment;
        assert_ne!(link::decode(&fragment).unwrap().session, drawn, "rounded");
        let kept = file::write(&drawn).unwrap();
        for address in [fragment.clone(), format!("#x=1&{fragment}")] {
            assert_eq!(first_session(Some(&address), Some(&kept)).session, drawn);
        }
    }

    #[test]
    fn a_copy_that_cannot_be_read_is_reported() {
        let link = link::encode(&scaled(9.0)).unwrap().fragment;
        for address in [None, Some(link.as_str())] {
            let start = first_session(address, Some("{\"riemap\": 7}"));
            let message = start.message.unwrap().english();
            assert!(message.contains("kept") && message.contains("format 7"), "{message}");
        }
    }
}
