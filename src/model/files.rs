//! The kind of an opened file (outline, surface, image, session, lesson or region), from its purpose and its name; a lesson is
//! told by its first line, whatever its name.
//!
//! No file is parsed here: a side's worker parses outlines, surfaces and sessions, the platform decodes images.

use crate::conformal::Side;
use crate::language::{Label, Message, key};
use crate::model::editing::tracing;
use crate::model::side::user_error::UserError;
use crate::outline::Outline;
use crate::session::{Touched, file, lesson};
use std::collections::BTreeSet;

/// The purpose for which a file is opened.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FilePurpose {
    /// As an outline for this side; the name may say that it is a surface or a session.
    Outline(Side),
    /// As the texture.
    Image,
    /// As a picture from which an outline for this side is traced.
    Trace(Side),
    /// As a session.
    Session,
    /// As the lesson in its panel.
    Lesson,
    /// As a region of the globe, to be mapped.
    Region,
    /// As the own picture of a session that is opened with it.
    OfSession,
    /// Dropped over this side: the name decides.
    Dropped(Side),
}

/// The file name endings of images.
pub const IMAGE_ENDINGS: [&str; 3] = ["png", "jpg", "jpeg"];
/// The file name endings of outlines.
const OUTLINE_ENDINGS: [&str; 9] = ["json", "geojson", "svg", "csv", "txt", "tsv", "xy", "dat", "wkt"];
/// The file name endings of surfaces.
pub const SURFACE_ENDINGS: [&str; 6] = crate::surface::ENDINGS;

/// The description of the files that a dialog offers.
pub fn kind_of_file(purpose: FilePurpose) -> Label {
    match purpose {
        FilePurpose::Image | FilePurpose::OfSession | FilePurpose::Trace(_) => key::images(),
        FilePurpose::Session => key::sessions(),
        FilePurpose::Lesson => key::lessons(),
        FilePurpose::Region => key::regions(),
        FilePurpose::Outline(_) | FilePurpose::Dropped(_) => key::outlines_and_surfaces(),
    }
}

/// The file name endings that a dialog offers.
pub fn endings(purpose: FilePurpose) -> Vec<&'static str> {
    match purpose {
        FilePurpose::Image | FilePurpose::OfSession | FilePurpose::Trace(_) => IMAGE_ENDINGS.to_vec(),
        FilePurpose::Session => vec![file::EXTENSION, lesson::EXTENSION],
        FilePurpose::Lesson => vec![lesson::EXTENSION],
        FilePurpose::Region => vec!["geojson", "json"],
        FilePurpose::Outline(_) | FilePurpose::Dropped(_) => {
            [&OUTLINE_ENDINGS[..], &SURFACE_ENDINGS, &IMAGE_ENDINGS, &[file::EXTENSION]].concat()
        }
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

/// How a file is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileKind {
    /// An outline for a side.
    Outline(Side),
    /// A surface for a side.
    Surface(Side),
    /// A picture to trace an outline of for a side.
    Trace(Side),
    /// A picture opened as the outline of a side: to trace, or to use as the texture; the person is asked.
    Picture(Side),
    /// The texture.
    Texture,
    /// A session.
    Session,
    /// A lesson.
    Lesson,
    /// A region of the globe, which changes nothing of the session.
    Region,
}

impl FileKind {
    /// The kind of a file. The name decides for a dropped file, and between outlines, surfaces, pictures to trace and
    /// sessions.
    pub fn of(purpose: FilePurpose, name: &str) -> Self {
        match purpose {
            FilePurpose::Image | FilePurpose::OfSession => Self::Texture,
            FilePurpose::Dropped(_) if has_ending(name, &IMAGE_ENDINGS) => Self::Texture,
            FilePurpose::Trace(side) => Self::Trace(side),
            FilePurpose::Outline(side) if has_ending(name, &IMAGE_ENDINGS) => Self::Picture(side),
            FilePurpose::Session => Self::Session,
            FilePurpose::Lesson => Self::Lesson,
            FilePurpose::Region => Self::Region,
            _ if has_ending(name, &[file::EXTENSION]) => Self::Session,
            FilePurpose::Outline(side) | FilePurpose::Dropped(side) => {
                if has_ending(name, &SURFACE_ENDINGS) {
                    Self::Surface(side)
                } else {
                    Self::Outline(side)
                }
            }
        }
    }

    /// The side that shows a failure; `None`: the message of the whole window.
    pub fn side(self) -> Option<Side> {
        match self {
            Self::Outline(side) | Self::Surface(side) | Self::Trace(side) | Self::Picture(side) => Some(side),
            Self::Texture | Self::Session | Self::Lesson | Self::Region => None,
        }
    }

    /// The parts of the session that the resulting command touches; of a picture that the answer decides about, the
    /// fewer.
    pub fn touches(self) -> Touched {
        match self {
            Self::Outline(_) | Self::Surface(_) | Self::Trace(_) => Touched::ANOTHER_SHAPE,
            Self::Picture(_) | Self::Texture => Touched::PATTERN,
            Self::Session | Self::Lesson => Touched::EVERYTHING,
            Self::Region => Touched::NOTHING,
        }
    }
}

/// A file that was dropped: its name, and its content or why it cannot be read.
pub type DroppedFile = (String, Result<Vec<u8>, String>);

/// Files that were dropped together, where a glTF document has its buffers and images, which are no files of their own: it is
/// then a GLB file by its content.
pub fn gathered(files: Vec<DroppedFile>) -> Vec<DroppedFile> {
    let mut is_part = vec![false; files.len()];
    let mut documents = Vec::new();
    for (k, (name, document)) in files.iter().enumerate() {
        let Some(document) = document.as_ref().ok().filter(|_| has_ending(name, &["gltf"])) else { continue };
        // two files of one name are in two folders, of which a drop does not tell
        let mut wanted = BTreeSet::new();
        let _ = crate::surface::packed(document, &mut |name| {
            wanted.insert(name.to_owned());
            None
        });
        let is_clear = |name: &str| wanted.iter().filter(|other| leaf(other) == leaf(name)).count() == 1;
        let found = |name: &str| {
            let mut found =
                (0..files.len()).filter(|&at| leaf(&files[at].0) == leaf(name) && !has_ending(&files[at].0, &["gltf"]));
            found.next().filter(|_| found.next().is_none() && is_clear(name))
        };
        let mut neighbor = |name: &str| files[found(name)?].1.as_ref().ok().cloned();
        let Some(packed) = crate::surface::packed(document, &mut neighbor) else { continue };
        if !packed.neighbors.is_empty() {
            packed.neighbors.iter().filter_map(|name| found(name)).for_each(|at| is_part[at] = true);
            documents.push((k, packed.bytes));
        }
    }
    let mut files = files;
    for (k, whole) in documents {
        files[k].1 = Ok(whole);
    }
    files.into_iter().zip(is_part).filter_map(|(file, is_part)| (!is_part).then_some(file)).collect()
}

fn leaf(name: &str) -> &str {
    name.rsplit(['/', '\\']).next().unwrap_or(name)
}

/// The outline of the largest shape in a picture. Errors: the reason, for the user.
pub fn traced(picture: &Picture) -> Result<Outline, UserError> {
    let stem = picture.name.rsplit_once('.').map_or(picture.name.as_str(), |(stem, _)| stem);
    tracing::trace(stem, &picture.pixels)
        .map_err(|error| UserError::new(key::about(&picture.name, Message::from(&error))))
}

fn has_ending(name: &str, endings: &[&str]) -> bool {
    let ending = name.rsplit('.').next().unwrap_or_default().to_ascii_lowercase();
    endings.contains(&ending.as_str())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]
    use super::*;
    use crate::outline::Preset;
    use crate::session::{Command, OutlineSpec, Session, SurfaceSpec, TextureKind};
    use crate::surface::read_surface;

    #[test]
    fn a_dropped_png_is_a_texture_whatever_the_case_of_its_ending() {
        assert_eq!(FileKind::of(FilePurpose::Dropped(Side::Target), "a.PNG"), FileKind::Texture);
        assert_eq!(FileKind::of(FilePurpose::Trace(Side::Target), "a.PNG"), FileKind::Trace(Side::Target));
        assert_eq!(FileKind::of(FilePurpose::Outline(Side::Source), "bird.JPG"), FileKind::Picture(Side::Source));
    }

    #[test]
    fn surfaces_and_sessions_are_told_by_their_names_wherever_they_are_opened() {
        let [source, target] = [FilePurpose::Dropped(Side::Source), FilePurpose::Outline(Side::Target)];
        assert_eq!(FileKind::of(source, "Cow.OBJ"), FileKind::Surface(Side::Source));
        assert_eq!(FileKind::of(target, "Cow.OBJ"), FileKind::Surface(Side::Target));
        assert_eq!([source, target].map(|purpose| FileKind::of(purpose, "a.riemap")), [FileKind::Session; 2]);
        assert_eq!(FileKind::of(FilePurpose::Session, "a.json"), FileKind::Session);
        assert_eq!(FileKind::of(target, "a.json"), FileKind::Outline(Side::Target));
    }

    #[test]
    fn a_gltf_document_that_is_dropped_with_its_buffer_is_one_file() {
        let text = concat!(
            r#"{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"#,
            r#""meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"#,
            r#""accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],"#,
            r#""bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"a%20b.bin"}]}"#,
        );
        let corners: [f32; 9] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
        let buffer = ("a b.bin".to_owned(), Ok(corners.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>()));
        let document = ("surface.gltf".to_owned(), Ok(text.as_bytes().to_vec()));
        let image = ("a.png".to_owned(), Err("unreadable".to_owned()));
        let gathered = gathered(vec![buffer.clone(), image.clone(), document.clone()]);
        assert_eq!(gathered.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(), ["a.png", "surface.gltf"]);
        let whole = gathered[1].1.as_ref().unwrap();
        assert!(read_surface("surface.gltf", whole).is_ok() && read_surface("a.gltf", &document.1.unwrap()).is_err());
        assert_eq!(super::gathered(vec![buffer.clone(), image.clone()]), [buffer, image]);
    }

    #[test]
    fn a_file_touches_what_its_command_does() {
        let side = Side::Target;
        let outline = Command::SetOutline { side, outline: OutlineSpec::Preset(Preset::Disk) };
        let surface = Command::SetSurface { side, surface: SurfaceSpec::default() };
        for (kind, command) in [
            (FileKind::Outline(side), &outline),
            (FileKind::Trace(side), &outline),
            (FileKind::Surface(side), &surface),
            (FileKind::Picture(side), &Command::SetTexture(TextureKind::Image)),
            (FileKind::Texture, &Command::SetTexture(TextureKind::Image)),
            (FileKind::Session, &Command::Open(Box::<Session>::default())),
        ] {
            assert_eq!(kind.touches(), command.touches(), "{kind:?}");
        }
    }

    #[test]
    fn a_picture_that_is_to_be_traced_becomes_an_outline() {
        let ink = |x: u32, y: u32| if (60..180).contains(&x) && (90..150).contains(&y) { 0 } else { 255 };
        let pixels = image::RgbaImage::from_fn(300, 240, |x, y| image::Rgba([ink(x, y), ink(x, y), ink(x, y), 255]));
        let outline = traced(&Picture { name: "box.png".into(), pixels }).unwrap();
        assert_eq!(outline.name(), "box");
        assert!((outline.polygon().area() / 7200.0 - 1.0).abs() < 0.02, "{}", outline.polygon().area());
        let pixels = image::RgbaImage::from_pixel(30, 20, image::Rgba([1, 2, 3, 255]));
        let text = traced(&Picture { name: "blank.png".into(), pixels }).unwrap_err().text.english();
        assert!(text.starts_with("blank.png: the whole picture has one color"), "{text}");
    }
}
