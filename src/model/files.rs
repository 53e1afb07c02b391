//! Files that came in: which are outlines, which are images or surfaces, and what is wrong with the others.

use crate::conformal::Side;
use crate::language::{Label, Message, key};
use crate::model::editing::tracing;
use crate::model::side::user_error::{QuickFix, UserError};
use crate::outline::{Outline, parse, parse_repaired};
use crate::session::{Session, file};

/// What a file is meant to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FilePurpose {
    /// An outline for this side.
    Outline(Side),
    /// The texture.
    Image,
    /// A picture to trace an outline of for this side.
    Trace(Side),
    /// A session.
    Session,
    /// Dropped over this side: its name decides.
    Dropped(Side),
}

/// The endings of images.
pub const IMAGE_ENDINGS: [&str; 3] = ["png", "jpg", "jpeg"];
/// The endings of outlines.
const OUTLINE_ENDINGS: [&str; 7] = ["json", "geojson", "svg", "csv", "txt", "tsv", "xy"];
/// The endings of surfaces.
pub const SURFACE_ENDINGS: [&str; 6] = crate::surface::ENDINGS;

/// The kind of file that a dialog asks for.
pub fn kind_of_file(purpose: FilePurpose) -> Label {
    match purpose {
        FilePurpose::Image | FilePurpose::Trace(_) => key::images(),
        FilePurpose::Session => key::sessions(),
        FilePurpose::Outline(_) | FilePurpose::Dropped(_) => key::outlines_and_surfaces(),
    }
}

/// The endings that a dialog offers.
pub fn endings(purpose: FilePurpose) -> Vec<&'static str> {
    match purpose {
        FilePurpose::Image | FilePurpose::Trace(_) => IMAGE_ENDINGS.to_vec(),
        FilePurpose::Session => vec![file::EXTENSION],
        FilePurpose::Outline(_) | FilePurpose::Dropped(_) => [&OUTLINE_ENDINGS[..], &SURFACE_ENDINGS].concat(),
    }
}

/// A decoded image.
#[derive(Debug)]
pub struct Picture {
    /// The file's name.
    pub name: String,
    /// Straight RGBA, 8 bits each.
    pub pixels: image::RgbaImage,
}

/// What a file turned out to be.
pub enum Content {
    /// An outline for a side.
    Outline(Side, Outline),
    /// A texture, or a picture to trace, not yet decoded: the platform does that.
    Image {
        /// The file's name.
        name: String,
        /// Its content.
        bytes: Vec<u8>,
    },
    /// A session.
    Session(Box<Session>),
    /// A surface, not yet read: that is work for its worker.
    Surface {
        /// Where it was opened or dropped.
        side: Side,
        /// The file's name.
        name: String,
        /// Its content.
        bytes: Vec<u8>,
    },
}

/// Why a file cannot be used, and beside what to say so.
#[derive(Debug, Clone, PartialEq)]
pub enum FileError {
    /// Meant as an outline of this side.
    Outline(Side, UserError),
    /// Meant as the texture or as a session.
    Common(Message),
}

/// Reads a file for its purpose; a dropped one is told by its name, and a surface always is.
pub fn read(purpose: FilePurpose, name: &str, bytes: Result<Vec<u8>, String>) -> Result<Content, FileError> {
    let is_session = has_ending(name, &[file::EXTENSION]);
    let (image, side) = match purpose {
        FilePurpose::Image => (true, Side::Source),
        FilePurpose::Outline(side) | FilePurpose::Trace(side) => (false, side),
        FilePurpose::Session => (false, Side::Source),
        FilePurpose::Dropped(side) => (is_image_name(name), side),
    };
    let session = purpose == FilePurpose::Session || (is_session && !image);
    let failed = |why: Message| {
        let message = key::about(name, why);
        if image || session { FileError::Common(message) } else { FileError::Outline(side, UserError::new(message)) }
    };
    let bytes = bytes.map_err(|cause| failed(key::file_unreadable(cause)))?;
    if image || purpose == FilePurpose::Trace(side) {
        return Ok(Content::Image { name: name.to_owned(), bytes });
    }
    if session {
        let read = file::read(&bytes).map_err(|error| failed(Message::from(&error)))?;
        return Ok(Content::Session(Box::new(read)));
    }
    if has_ending(name, &SURFACE_ENDINGS) {
        return Ok(Content::Surface { side, name: name.to_owned(), bytes });
    }
    match parse(name, &bytes) {
        Ok(outline) => Ok(Content::Outline(side, outline)),
        Err(error) => {
            let quick_fix = parse_repaired(name, &bytes).ok().map(|outline| QuickFix::Repaired(Box::new(outline)));
            Err(FileError::Outline(side, UserError { text: key::about(name, Message::from(&error)), quick_fix }))
        }
    }
}

/// The outline of the largest shape in a picture.
pub fn traced(side: Side, picture: &Picture) -> Result<Content, FileError> {
    let stem = picture.name.rsplit_once('.').map_or(picture.name.as_str(), |(stem, _)| stem);
    match tracing::trace(stem, &picture.pixels) {
        Ok(outline) => Ok(Content::Outline(side, outline)),
        Err(error) => Err(FileError::Outline(side, UserError::new(key::about(&picture.name, Message::from(&error))))),
    }
}

fn is_image_name(name: &str) -> bool {
    has_ending(name, &IMAGE_ENDINGS)
}

fn has_ending(name: &str, endings: &[&str]) -> bool {
    let ending = name.rsplit('.').next().unwrap_or_default().to_ascii_lowercase();
    endings.contains(&ending.as_str())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
    use super::*;

    #[test]
    fn a_dropped_png_is_a_texture_whatever_the_case_of_its_ending() {
        let content = read(FilePurpose::Dropped(Side::Target), "a.PNG", Ok(vec![1, 2]));
        let Ok(Content::Image { name, bytes }) = content else { panic!("not an image") };
        assert_eq!((name.as_str(), bytes), ("a.PNG", vec![1, 2]));
    }

    #[test]
    fn a_surface_is_told_by_its_name_wherever_it_is_opened() {
        for purpose in [FilePurpose::Dropped(Side::Source), FilePurpose::Outline(Side::Target)] {
            let content = read(purpose, "Cow.OBJ", Ok(b"v 0 0 0".to_vec()));
            assert!(matches!(content, Ok(Content::Surface { name, .. }) if name == "Cow.OBJ"));
        }
    }

    #[test]
    fn a_picture_that_is_to_be_traced_becomes_an_outline() {
        let ink = |x: u32, y: u32| if (60..180).contains(&x) && (90..150).contains(&y) { 0 } else { 255 };
        let pixels = image::RgbaImage::from_fn(300, 240, |x, y| image::Rgba([ink(x, y), ink(x, y), ink(x, y), 255]));
        let content = traced(Side::Target, &Picture { name: "box.png".into(), pixels });
        let Ok(Content::Outline(Side::Target, outline)) = content else { panic!("not traced") };
        assert_eq!(outline.name, "box");
        assert!((outline.polygon.area() / 7200.0 - 1.0).abs() < 0.02, "{}", outline.polygon.area());
        let pixels = image::RgbaImage::from_pixel(30, 20, image::Rgba([1, 2, 3, 255]));
        let error = traced(Side::Target, &Picture { name: "blank.png".into(), pixels }).err();
        let Some(FileError::Outline(Side::Target, user_error)) = error else { panic!("{error:?}") };
        let text = user_error.text.english();
        assert!(text.starts_with("blank.png: the whole picture has one colour"), "{text}");
    }

    #[test]
    fn an_unreadable_outline_is_told_beside_its_side() {
        let error = read(FilePurpose::Dropped(Side::Target), "shape.csv", Err("permission denied".into())).err();
        assert_eq!(
            error,
            Some(FileError::Outline(
                Side::Target,
                UserError::new(key::about("shape.csv", key::file_unreadable("permission denied")))
            ))
        );
    }

    fn user_error_with(text: &str) -> UserError {
        match read(FilePurpose::Outline(Side::Source), "a.json", Ok(text.into())) {
            Err(FileError::Outline(Side::Source, user_error)) => user_error,
            _ => panic!("was read"),
        }
    }

    #[test]
    fn a_broken_outline_says_what_is_wrong_and_has_no_remedy() {
        let user_error = user_error_with("{");
        assert!(user_error.text.english().len() > "a.json: ".len() && user_error.quick_fix.is_none(), "{user_error:?}");
        // Crossing edges: which part is meant is not for a machine to say.
        assert!(user_error_with("[[0,0],[2,2],[2,0],[0,3]]").quick_fix.is_none());
    }

    #[test]
    fn a_spike_can_be_cut_off() {
        let user_error = user_error_with("[[0,0],[2,0],[2,1],[3,1],[2,1],[2,2],[0,2]]");
        let Some(QuickFix::Repaired(outline)) = user_error.quick_fix else {
            panic!("no remedy: {}", user_error.text.english())
        };
        assert_eq!(outline.name, "a");
    }
}
