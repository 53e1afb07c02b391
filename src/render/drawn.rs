//! What stands in a viewport's picture: it is recorded anew only where something of it has changed.
//!
//! Where the processor draws, a picture takes longer than a frame may. There one that has changed is recorded
//! coarsely first, with a quarter of the pixels, and once in full when it has stayed as it is for a while.
//! Geometry is not compared: whoever replaces it outdates the picture. What was recorded counts when it is painted:
//! a frame for which the window has no surface at the moment is dropped with all that was recorded for it.

use super::{Camera, CellStyle, OrbitCamera, StrokeStyle, TextureStyle};
use std::sync::atomic::{AtomicBool, Ordering};

/// How long a coarse picture stays, in seconds, before it is recorded in full.
pub const REFINED_AFTER: f64 = 0.15;

/// All of a planar viewport's picture but its geometry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarFrame {
    /// The viewport's size in physical pixels.
    pub size_px: [u32; 2],
    /// What it looks at.
    pub camera: Camera,
    /// How it is textured.
    pub style: TextureStyle,
    /// The ground: sRGB-encoded, straight alpha.
    pub background: [f32; 4],
}

/// All of a surface's picture but its geometry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpaceFrame {
    /// The viewport's size in physical pixels.
    pub size_px: [u32; 2],
    /// The eye.
    pub camera: OrbitCamera,
    /// The texture.
    pub style: TextureStyle,
    /// Colours, edges and marks of triangles; `None`: only the texture.
    pub cells: Option<CellStyle>,
    /// The boundary loop's stroke; pattern lines keep a fixed proportion to it.
    pub stroke: StrokeStyle,
    /// The ground: sRGB-encoded, straight alpha.
    pub background: [f32; 4],
}

/// When a picture is recorded in full.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pace {
    /// At once.
    Full,
    /// After it was coarse for [`REFINED_AFTER`].
    CoarseFirst {
        /// The present, in seconds since any moment.
        now: f64,
    },
}

/// How a picture was recorded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Detail {
    /// Every pixel.
    Full,
    /// A quarter of the pixels, which `paint` stretches.
    Coarse,
}

impl Detail {
    /// How many pixels wide a recorded pixel is.
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

    /// The same stroke in the picture's pixels.
    pub(super) fn stroke(self, stroke: StrokeStyle) -> StrokeStyle {
        StrokeStyle { width_px: self.length(stroke.width_px), ..stroke }
    }

    /// The same cells in the picture's pixels.
    pub(super) fn cells(self, cells: CellStyle) -> CellStyle {
        let wire = cells.wire.map(|wire| self.stroke(wire));
        CellStyle { wire, pixels_per_point: self.length(cells.pixels_per_point), ..cells }
    }

    /// The same part of the world.
    pub(super) fn camera(self, camera: Camera) -> Camera {
        Camera { units_per_pixel: camera.units_per_pixel * f64::from(self.pixel()), ..camera }
    }
}

/// The picture of a viewport, as it was recorded last.
#[derive(Debug)]
pub(super) struct Drawn<F> {
    /// `None`: there is none, or its geometry has changed since.
    frame: Option<F>,
    /// Whether it was painted since it was recorded.
    is_painted: AtomicBool,
    detail: Detail,
    /// When it became coarse.
    since: f64,
}

impl<F> Default for Drawn<F> {
    fn default() -> Self {
        Self { frame: None, is_painted: AtomicBool::new(false), detail: Detail::Full, since: 0.0 }
    }
}

impl<F: PartialEq> Drawn<F> {
    /// The geometry is another: what was recorded does not stand any more.
    pub fn outdate(&mut self) {
        self.frame = None;
    }

    /// It is on its way to the screen.
    pub fn confirm(&self) {
        self.is_painted.store(true, Ordering::Relaxed);
    }

    /// How it was recorded last.
    pub fn detail(&self) -> Detail {
        self.detail
    }

    /// How `frame` is to be recorded now; `None`: it stands.
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

    /// What is due, and painted.
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
