//! The state of a viewport's picture: it is recorded again only if something in it has changed.
//!
//! On software adapters, recording a picture takes longer than a frame. There a picture that has changed is recorded
//! coarsely first, with a quarter of the pixels, and in full when it has not changed for [`REFINED_AFTER`].
//! Geometry is not compared: code that replaces it calls `Drawn::outdate`. A recording counts once it has been
//! painted: if the window has no surface at the moment, the frame and everything recorded for it are dropped.

use super::{Camera, CellStyle, OrbitCamera, StrokeStyle, TextureStyle};
use std::sync::atomic::{AtomicBool, Ordering};

/// How long a picture stays coarse, in seconds, before it is recorded in full.
pub const REFINED_AFTER: f64 = 0.15;

/// The state of a planar viewport's picture, except its geometry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarFrame {
    /// The viewport's size in physical pixels.
    pub size_px: [u32; 2],
    /// The camera.
    pub camera: Camera,
    /// The texture.
    pub style: TextureStyle,
    /// The background: sRGB-encoded, straight alpha.
    pub background: [f32; 4],
}

/// The state of a surface's picture, except its geometry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpaceFrame {
    /// The viewport's size in physical pixels.
    pub size_px: [u32; 2],
    /// The eye.
    pub camera: OrbitCamera,
    /// The texture.
    pub style: TextureStyle,
    /// Colors, edges and marks of triangles; `None` shows only the texture.
    pub cells: Option<CellStyle>,
    /// The boundary loop's stroke; pattern lines keep a fixed proportion to it.
    pub stroke: StrokeStyle,
    /// The background: sRGB-encoded, straight alpha.
    pub background: [f32; 4],
}

/// When a picture is recorded in full.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pace {
    /// At once.
    Full,
    /// After a coarse recording that lasts for [`REFINED_AFTER`].
    CoarseFirst {
        /// The present time, in seconds since an arbitrary moment.
        now: f64,
    },
}

/// How a picture was recorded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Detail {
    /// Every pixel.
    Full,
    /// A quarter of the pixels, scaled up by `paint`.
    Coarse,
}

impl Detail {
    /// The width of a recorded pixel in pixels of the screen.
    fn pixel(self) -> u32 {
        match self {
            Self::Full => 1,
            Self::Coarse => 2,
        }
    }

    /// The size of a picture that is shown at `size_px`.
    pub(super) fn size(self, size_px: [u32; 2]) -> [u32; 2] {
        size_px.map(|side| side.div_ceil(self.pixel()))
    }

    /// A length on the screen in the picture's pixels.
    pub(super) fn length(self, length_px: f32) -> f32 {
        length_px / self.pixel() as f32
    }

    /// The stroke with its lengths in the picture's pixels.
    pub(super) fn stroke(self, stroke: StrokeStyle) -> StrokeStyle {
        StrokeStyle { width_px: self.length(stroke.width_px), ..stroke }
    }

    /// The cell style with its lengths in the picture's pixels.
    pub(super) fn cells(self, cells: CellStyle) -> CellStyle {
        let wire = cells.wire.map(|wire| self.stroke(wire));
        CellStyle { wire, pixels_per_point: self.length(cells.pixels_per_point), ..cells }
    }

    /// The camera that shows the same part of the world in the picture's pixels.
    pub(super) fn camera(self, camera: Camera) -> Camera {
        Camera { units_per_pixel: camera.units_per_pixel * f64::from(self.pixel()), ..camera }
    }
}

/// The picture of a viewport as it was last recorded.
#[derive(Debug)]
pub(super) struct Drawn<F> {
    /// The recorded state; `None` if nothing was recorded, or the geometry has changed since.
    frame: Option<F>,
    /// Whether the picture has been painted since it was recorded.
    is_painted: AtomicBool,
    detail: Detail,
    /// When the picture was last recorded at [`Pace::CoarseFirst`].
    since: f64,
}

impl<F> Default for Drawn<F> {
    fn default() -> Self {
        Self { frame: None, is_painted: AtomicBool::new(false), detail: Detail::Full, since: 0.0 }
    }
}

impl<F: PartialEq> Drawn<F> {
    /// The geometry was replaced: the recorded picture is no longer valid.
    pub fn outdate(&mut self) {
        self.frame = None;
    }

    /// The picture has been painted.
    pub fn confirm(&self) {
        self.is_painted.store(true, Ordering::Relaxed);
    }

    /// The detail of the last recording.
    pub fn detail(&self) -> Detail {
        self.detail
    }

    /// The detail with which `frame` must be recorded now; `None` if the recorded picture is still valid.
    pub fn due(&mut self, frame: F, pace: Pace) -> Option<Detail> {
        let stands = *self.is_painted.get_mut() && self.frame.as_ref() == Some(&frame);
        let due = match pace {
            Pace::Full => (!stands || self.detail == Detail::Coarse).then_some(Detail::Full),
            Pace::CoarseFirst { .. } if !stands => Some(Detail::Coarse),
            Pace::CoarseFirst { now } => {
                let rested = self.detail == Detail::Coarse && now - self.since >= REFINED_AFTER;
                rested.then_some(Detail::Full)
            }
        };
        if let Some(detail) = due {
            self.frame = Some(frame);
            *self.is_painted.get_mut() = false;
            self.detail = detail;
            if let Pace::CoarseFirst { now } = pace {
                self.since = now;
            }
        }
        due
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The detail that is due; the picture is then painted.
    fn painted(drawn: &mut Drawn<u32>, frame: u32, pace: Pace) -> Option<Detail> {
        let due = drawn.due(frame, pace);
        drawn.confirm();
        due
    }

    #[test]
    fn a_picture_is_recorded_when_it_changes() {
        let mut drawn = Drawn::default();
        assert_eq!(painted(&mut drawn, 1, Pace::Full), Some(Detail::Full));
        assert_eq!(painted(&mut drawn, 1, Pace::Full), None);
        assert_eq!(painted(&mut drawn, 2, Pace::Full), Some(Detail::Full));
        drawn.outdate();
        assert_eq!(painted(&mut drawn, 2, Pace::Full), Some(Detail::Full));
    }

    #[test]
    fn what_was_recorded_and_never_painted_is_recorded_again() {
        let mut drawn = Drawn::default();
        assert_eq!(drawn.due(1, Pace::Full), Some(Detail::Full));
        assert_eq!(painted(&mut drawn, 1, Pace::Full), Some(Detail::Full));
        assert_eq!(drawn.due(1, Pace::Full), None);
        assert_eq!(drawn.due(1, Pace::Full), None, "painted once is enough");
    }

    #[test]
    fn in_a_hurry_it_is_coarse_until_it_rests() {
        let at = |now| Pace::CoarseFirst { now };
        let mut drawn = Drawn::default();
        assert_eq!(painted(&mut drawn, 1, at(10.0)), Some(Detail::Coarse));
        assert_eq!(painted(&mut drawn, 1, at(10.1)), None, "it has only just changed");
        assert_eq!(painted(&mut drawn, 2, at(10.2)), Some(Detail::Coarse));
        assert_eq!(painted(&mut drawn, 2, at(10.2 + 0.5 * REFINED_AFTER)), None);
        assert_eq!(painted(&mut drawn, 2, at(10.2 + REFINED_AFTER + 1e-9)), Some(Detail::Full));
        assert_eq!(painted(&mut drawn, 2, at(11.0)), None);
        assert_eq!(painted(&mut drawn, 3, at(11.0)), Some(Detail::Coarse));
        assert_eq!(painted(&mut drawn, 3, Pace::Full), Some(Detail::Full), "no hurry any more");
    }
}
