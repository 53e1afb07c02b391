//! An outline that is being drawn: freehand in one stroke, or point by point.
//!
//! No egui in here. The old outline and its map stay until the new one is closed and is one.

use crate::conformal::Side;
use crate::drawing::{DrawingError, closed_curve, freehand};
use crate::geometry::{DVec2, SimplePolygon};
use crate::language::Message;
use crate::model::editing::Crossing;

/// What it is drawn with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pen {
    /// The pointer's own way.
    Freehand,
    /// Straight edges between clicked points.
    Lines,
    /// A smooth curve through clicked points.
    Curve,
}

/// An outline on its way.
#[derive(Debug)]
pub struct Drawing {
    side: Side,
    pen: Pen,
    /// The stroke, or the clicked points.
    points: Vec<DVec2>,
    /// Why what was closed is no outline.
    crossing: Option<Crossing>,
}

impl Drawing {
    /// Begins with nothing.
    pub fn new(side: Side, pen: Pen) -> Self {
        Self { side, pen, points: Vec::new(), crossing: None }
    }

    /// For which side.
    pub fn side(&self) -> Side {
        self.side
    }

    /// What it is drawn with.
    pub fn pen(&self) -> Pen {
        self.pen
    }

    /// The stroke, or the clicked points.
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// Why what was closed is no outline.
    pub fn crossing(&self) -> Option<&Crossing> {
        self.crossing.as_ref()
    }

    /// One more point; after a stroke that was no outline, the first one of another.
    pub fn add(&mut self, point: DVec2) {
        if self.crossing.take().is_some() && self.pen == Pen::Freehand {
            self.points.clear();
        }
        if self.points.last() != Some(&point) {
            self.points.push(point);
        }
    }

    /// Takes the last point back.
    pub fn take_back(&mut self) {
        self.points.pop();
        self.crossing = None;
    }

    /// Begins anew.
    pub fn clear(&mut self) {
        self.points.clear();
        self.crossing = None;
    }

    /// The closed chain that is meant; with `more`, as if that point were clicked next.
    pub fn chain(&self, more: Option<DVec2>) -> Vec<DVec2> {
        let points: Vec<DVec2> = self.points.iter().copied().chain(more).collect();
        match self.pen {
            Pen::Freehand | Pen::Lines => points,
            Pen::Curve => closed_curve(&points, |_| false),
        }
    }

    /// The message has been read: clicked points stay, a stroke that was no outline goes.
    pub fn dismiss(&mut self) {
        self.crossing = None;
        if self.pen == Pen::Freehand {
            self.points.clear();
        }
    }

    /// The finished outline. `pixel`: the size of a pixel, the exactness of a hand. What is none stays
    /// as it is drawn, and [`Self::crossing`] says why.
    pub fn close(&mut self, pixel: f64) -> Option<SimplePolygon> {
        match self.polygon(pixel) {
            Ok(polygon) => Some(polygon),
            Err(error) => {
                self.crossing = Some(match error {
                    DrawingError::Outline(error) => Crossing::of(&error, &self.points),
                    other => Crossing { at: None, text: Message::from(&other) },
                });
                None
            }
        }
    }

    fn polygon(&self, pixel: f64) -> Result<SimplePolygon, DrawingError> {
        let chain = match self.pen {
            Pen::Freehand => freehand(&self.points, HAND * pixel)?,
            Pen::Lines | Pen::Curve if self.points.len() < 3 => {
                return Err(DrawingError::TooFewPoints { count: self.points.len() });
            }
            Pen::Lines | Pen::Curve => self.chain(None),
        };
        Ok(SimplePolygon::try_from(chain)?)
    }
}

/// How far a stroke is off what is meant, in pixels: a mouse shakes by one, and a finger by two.
const HAND: f64 = 1.5;
