//! The texture's picture as a GLB contains it: over paper, with a margin of a pixel that continues beyond its edges.

use crate::geometry::{DVec2, PictureFrame};
use crate::language::Message;
use crate::model::{Model, pattern};
use crate::render::{PngFile, on_paper};
use crate::session::TextureKind;
use image::RgbaImage;

/// Pixels of paper around the picture: viewers repeat the outermost ones.
const MARGIN: u32 = 1;

/// An encoded picture, and where it lies over the outline.
pub(super) struct PictureBase {
    png: Vec<u8>,
    frame: PictureFrame,
    /// Width and height of the picture without its margin, in pixels.
    size: DVec2,
}

impl PictureBase {
    /// `None` unless the picture is the texture, and lies over the outline. Errors: in words.
    pub fn new(model: &Model, picture: &RgbaImage) -> Option<Result<Self, Message>> {
        let session = model.session();
        let home = pattern::home(session).filter(|_| session.texture() == TextureKind::Image)?;
        let bounds = model.extent(home)?;
        let size = DVec2::new(f64::from(picture.width()), f64::from(picture.height()));
        let frame = session.picture().frame(bounds, size.x / size.y);
        Some(encoded(picture).map(|png| Self { png, frame, size }))
    }

    /// The PNG file.
    pub fn png(&self) -> &[u8] {
        &self.png
    }

    /// The place in the file's picture of a position in the outline, as parts of its width and height.
    pub fn lookup(&self, place: DVec2) -> DVec2 {
        let margin = DVec2::splat(f64::from(MARGIN));
        (self.frame.lookup(place) * self.size + margin) / (self.size + 2.0 * margin)
    }
}

fn encoded(picture: &RgbaImage) -> Result<Vec<u8>, Message> {
    let mut file = PngFile::begin(on_paper(picture, MARGIN)).map_err(|error| Message::from(&error))?;
    loop {
        if let Some(bytes) = file.advance().map_err(|error| Message::from(&error))? {
            return Ok(bytes);
        }
    }
}
