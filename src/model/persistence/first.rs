//! The session with which the app starts: from its address, from the stored copy, or the default.

use crate::language::{Message, key};
use crate::session::file::{Archive, FileError};
use crate::session::link::{self, Decoded, MissingOutline};
use crate::session::{Session, file};

/// The session to start with.
#[derive(Debug, Clone)]
pub struct Start {
    /// The session, its undo steps and its files.
    pub archive: Archive,
    /// Whether it is the kept one, with its steps.
    pub is_kept: bool,
    /// The outlines that its link only names.
    pub missing: Vec<MissingOutline>,
    /// The errors of the link and the copy.
    pub message: Option<Message>,
}

/// What was kept from the last run.
#[derive(Debug, Default)]
pub struct KeptCopies<'a> {
    /// The session alone, as text: written at once, and so never older than the record.
    pub text: Option<&'a str>,
    /// The record with undo steps and files; or why it cannot be read.
    pub record: Option<Result<Archive, FileError>>,
    /// Whether the text is that of another visit than the record, as of another tab.
    pub text_is_elsewhere: bool,
    /// Whether the record is that of the visit that is to be shown; otherwise it is the newest one.
    pub record_is_own: bool,
}

/// The session to start with: that of the link in the `address`, else what was `kept`, else the default.
///
/// If the link in the address is that of what was kept, as after a reload, that is used, since it also holds what
/// a link may leave out. The decoded links are compared, because another version may encode the same link differently.
/// A text that differs from the record of the same visit is a later step of it. One of another visit is another session,
/// which is used before the record only if that is not the visit's own.
pub fn first_session(address: Option<&str>, kept: KeptCopies<'_>) -> Start {
    let (copies, user_error) = readable(kept);
    let Some(address) = address else {
        let kept = copies.into_iter().next();
        let (is_kept, archive) = (kept.is_some(), kept.unwrap_or_else(|| Archive::from(Session::default())));
        return Start { archive, is_kept, missing: Vec::new(), message: user_error };
    };
    let opened = link::decode(address);
    let mut of_address =
        copies.into_iter().filter(|kept| opened.as_ref().is_ok_and(|opened| is_link_of(opened, kept.session())));
    if let Some(archive) = of_address.next() {
        return Start { archive, is_kept: true, missing: Vec::new(), message: None };
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
    let message = Message::joined(messages, key::sentence_and);
    Start { archive: Archive::from(session), is_kept: false, missing, message }
}

/// What can be read of what was kept, the visit's own first, then the newest, and why the rest cannot.
fn readable(kept: KeptCopies<'_>) -> (Vec<Archive>, Option<Message>) {
    let KeptCopies { text_is_elsewhere, record_is_own, .. } = kept;
    let text = kept.text.map(|text| file::read(text.as_bytes())).transpose();
    let record = kept.record.transpose();
    let failed = |error: &FileError| key::last_session_not_opened(Message::from(error));
    let error = record.as_ref().err().or(text.as_ref().err()).map(failed);
    let (text, record) = (text.unwrap_or_default(), record.unwrap_or_default());
    let newer = text.filter(|text| record.as_ref().is_none_or(|record| record.session() != text));
    let newer = newer.map(|session| match record.clone().filter(|_| !text_is_elsewhere) {
        Some(mut later) => {
            later.history.settle(&session);
            later
        }
        None => Archive::from(session),
    });
    let mut copies: Vec<Archive> = newer.into_iter().chain(record).collect();
    if text_is_elsewhere && record_is_own {
        copies.reverse();
    }
    (copies, error)
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

    fn first(address: Option<&str>, text: Option<&str>) -> Start {
        first_session(address, KeptCopies { text, ..KeptCopies::default() })
    }

    #[test]
    fn the_address_comes_before_the_copy_and_that_before_the_default() {
        let kept = file::write(&scaled(5.0)).unwrap();
        let other = link::encode(&scaled(9.0)).unwrap().fragment;
        let start = first(None, None);
        assert_eq!((start.archive.session(), start.is_kept), (&Session::default(), false));
        assert_eq!(first(None, Some(&kept)).archive.session(), &scaled(5.0));
        assert_eq!(first(Some(&other), Some(&kept)).archive.session(), &scaled(9.0));
        let damaged = first(Some("#s=1.AAAA"), Some(&kept));
        assert_eq!(damaged.archive.session(), &Session::default());
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
            assert_eq!(first(Some(&address), Some(&kept)).archive.session(), &drawn);
        }
    }

    #[test]
    fn a_copy_that_cannot_be_read_is_reported() {
        let link = link::encode(&scaled(9.0)).unwrap().fragment;
        for address in [None, Some(link.as_str())] {
            let start = first(address, Some("{\"riemap\": 7}"));
            let message = start.message.unwrap().english();
            assert!(message.contains("kept") && message.contains("format 7"), "{message}");
        }
    }

    fn record(scales: [f64; 2]) -> Archive {
        let mut archive = Archive::from(scaled(scales[0]));
        archive.history.settle(&scaled(scales[1]));
        archive
    }

    fn of_record(text: &str) -> KeptCopies<'_> {
        KeptCopies { text: Some(text), record: Some(Ok(record([4.0, 5.0]))), ..KeptCopies::default() }
    }

    /// As when a tab that plays a lesson is reloaded: its address tells no session.
    #[test]
    fn the_text_of_another_tab_does_not_replace_the_visits_own_record() {
        let kept = file::write(&scaled(7.0)).unwrap();
        let elsewhere = |record_is_own| KeptCopies { text_is_elsewhere: true, record_is_own, ..of_record(&kept) };
        let reloaded = first_session(None, elsewhere(true)).archive;
        assert_eq!((reloaded.session(), reloaded.history.undo_count()), (&scaled(5.0), 1));
        let new_tab = first_session(None, elsewhere(false)).archive;
        assert_eq!((new_tab.session(), new_tab.history.undo_count()), (&scaled(7.0), 0), "the newest");
    }

    #[test]
    fn the_record_comes_with_its_steps_and_a_later_text_is_one_more() {
        let kept = file::write(&scaled(7.0)).unwrap();
        let address = link::encode(&scaled(5.0)).unwrap().fragment;
        let later = first_session(None, of_record(&kept));
        assert_eq!((later.archive.session(), later.archive.history.undo_count()), (&scaled(7.0), 2));
        // the text is that of another tab, and the address says which one is meant
        let reloaded = first_session(Some(&address), of_record(&kept));
        assert_eq!((reloaded.archive.session(), reloaded.archive.history.undo_count()), (&scaled(5.0), 1));
        assert!(reloaded.is_kept && reloaded.message.is_none());
    }

    #[test]
    fn a_record_that_cannot_be_read_is_reported_and_the_text_is_used() {
        let kept = file::write(&scaled(7.0)).unwrap();
        let broken = Some(Err(FileError::MissingPart("surfaces/cow.obj".into())));
        let start = first_session(None, KeptCopies { text: Some(&kept), record: broken, ..KeptCopies::default() });
        assert_eq!(start.archive.session(), &scaled(7.0));
        assert!(start.message.unwrap().english().contains("surfaces/cow.obj"));
    }
}
