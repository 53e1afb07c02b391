//! An outline being drawn: freehand in one stroke, or point by point.
//!
//! Independent of egui. The old outline and its map stay until the new one is closed and valid.

use crate::conformal::Side;
use crate::drawing::{DrawingError, closed_curve, freehand};
use crate::geometry::{DVec2, SimplePolygon};
use crate::language::Message;
use crate::model::editing::Crossing;

/// How an outline is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pen {
    /// One stroke along the pointer's path.
    Freehand,
    /// Straight edges between clicked points.
    Lines,
    /// A smooth curve through clicked points.
    Curve,
}

/// An outline being drawn.
#[derive(Debug)]
pub struct Drawing {
    side: Side,
    pen: Pen,
    /// The points of the stroke, or the clicked points.
    points: Vec<DVec2>,
    /// Why the closed chain is not a valid outline.
    crossing: Option<Crossing>,
}

impl Drawing {
    /// An empty drawing.
    pub fn new(side: Side, pen: Pen) -> Self {
        Self { side, pen, points: Vec::new(), crossing: None }
    }

    /// The side that it is drawn for.
    pub fn side(&self) -> Side {
        self.side
    }

    /// How it is drawn.
    pub fn pen(&self) -> Pen {
        self.pen
    }

    /// The points of the stroke, or the clicked points.
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// Why the closed chain is not a valid outline.
    pub fn crossing(&self) -> Option<&Crossing> {
        self.crossing.as_ref()
    }

    /// Adds a point. After an invalid freehand stroke it is the first point of a new one.
    pub fn add(&mut self, point: DVec2) {
        if self.crossing.take().is_some() && self.pen == Pen::Freehand {
            self.points.clear();
        }
        if self.points.last() != Some(&point) {
            self.points.push(point);
        }
    }

    /// Removes the last point.
    pub fn take_back(&mut self) {
        self.points.pop();
        self.crossing = None;
    }

    /// Removes all points.
    pub fn clear(&mut self) {
        self.points.clear();
        self.crossing = None;
    }

    /// The closed chain as it would be now; with `more`, as if that point were clicked next.
    pub fn chain(&self, more: Option<DVec2>) -> Vec<DVec2> {
        let points: Vec<DVec2> = self.points.iter().copied().chain(more).collect();
        match self.pen {
            Pen::Freehand | Pen::Lines => points,
            Pen::Curve => closed_curve(&points, |_| false),
        }
    }

    /// To be called when the message is dismissed: clicked points stay, an invalid stroke is removed.
    pub fn dismiss(&mut self) {
        self.crossing = None;
        if self.pen == Pen::Freehand {
            self.points.clear();
        }
    }

    /// The finished outline. `pixel` is the size of a pixel, the accuracy of a hand. An invalid outline stays
    /// as drawn, and [`Self::crossing`] says why.
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

/// The accuracy of a stroke in pixels: a mouse deviates by one, a finger by two.
const HAND: f64 = 1.5;
