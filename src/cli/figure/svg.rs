//! A small writer of SVG pages: lines, text, embedded pictures. Coordinates are pixels, y down.

use crate::geometry::DVec2;
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use std::fmt::Write as _;

/// A page being written.
pub struct Page {
    body: String,
    size: DVec2,
}

/// The position of a text relative to its point.
#[derive(Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs, reason = "as in SVG")]
pub enum Anchor {
    Start,
    Middle,
    End,
}

/// The style of a line.
#[derive(Clone, Copy)]
pub struct Stroke {
    pub colour: &'static str,
    pub width: f64,
    /// `stroke-dasharray`; empty: solid.
    pub dash: &'static str,
}

impl Stroke {
    pub const fn solid(colour: &'static str, width: f64) -> Self {
        Self { colour, width, dash: "" }
    }

    fn attributes(self) -> String {
        let dash = if self.dash.is_empty() { String::new() } else { format!(" stroke-dasharray=\"{}\"", self.dash) };
        format!("fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{dash}", self.colour, self.width)
    }
}

/// Okabe & Ito, "Color universal design" (2008), and the grays between.
pub mod colour {
    pub const INK: &str = "#1b1b1f";
    pub const GREY: &str = "#8a8d93";
    pub const FAINT: &str = "#e3e4e8";
    pub const BLUE: &str = "#0072b2";
    pub const VERMILLION: &str = "#d55e00";
    pub const GREEN: &str = "#009e73";
    pub const ORANGE: &str = "#e69f00";
    pub const MAGENTA: &str = "#d63ca6";
}

/// Text sizes in pixels.
pub const TITLE: f64 = 17.0;
pub const LABEL: f64 = 13.0;
pub const SMALL: f64 = 11.5;

impl Page {
    /// An empty white page.
    pub fn new(width: f64, height: f64) -> Self {
        let mut page = Self { body: String::new(), size: DVec2::new(width, height) };
        let _ = writeln!(page.body, "<rect width=\"{width}\" height=\"{height}\" fill=\"white\"/>");
        page
    }

    /// A polyline through `points`; points that are not finite are skipped.
    pub fn line(&mut self, points: impl IntoIterator<Item = DVec2>, stroke: Stroke) {
        let _ = write!(self.body, "<path {} d=\"", stroke.attributes());
        let mut command = 'M';
        for p in points.into_iter().filter(|p| p.is_finite()) {
            let _ = write!(self.body, "{command}{:.2} {:.2}", p.x, p.y);
            command = 'L';
        }
        self.body.push_str("\"/>\n");
    }

    /// Separate segments in one path.
    pub fn segments(&mut self, segments: impl IntoIterator<Item = [DVec2; 2]>, stroke: Stroke) {
        let _ = write!(self.body, "<path {} d=\"", stroke.attributes());
        for [a, b] in segments {
            let _ = write!(self.body, "M{:.2} {:.2}L{:.2} {:.2}", a.x, a.y, b.x, b.y);
        }
        self.body.push_str("\"/>\n");
    }

    /// A disc, with a white ring unless it is small.
    pub fn dot(&mut self, centre: DVec2, radius: f64, colour: &str) {
        let DVec2 { x, y } = centre;
        let ring = if radius > 3.0 { " stroke=\"white\" stroke-width=\"1.2\"" } else { "" };
        let _ = writeln!(self.body, "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius}\" fill=\"{colour}\"{ring}/>");
    }

    /// A filled rectangle.
    pub fn fill(&mut self, corner: DVec2, size: DVec2, colour: &str) {
        let _ = writeln!(
            self.body,
            "<rect x=\"{:.2}\" y=\"{:.2}\" width=\"{:.2}\" height=\"{:.2}\" fill=\"{colour}\"/>",
            corner.x, corner.y, size.x, size.y
        );
    }

    /// A line of text with its baseline at `at`.
    pub fn text(&mut self, at: DVec2, anchor: Anchor, size: f64, colour: &str, text: &str) {
        self.write_text(at, anchor, size, colour, text, "");
    }

    /// A text rotated by 90°, reading upward.
    pub fn vertical_text(&mut self, at: DVec2, size: f64, colour: &str, text: &str) {
        let turn = format!(" transform=\"rotate(-90 {:.2} {:.2})\"", at.x, at.y);
        self.write_text(at, Anchor::Middle, size, colour, text, &turn);
    }

    fn write_text(&mut self, at: DVec2, anchor: Anchor, size: f64, colour: &str, text: &str, attributes: &str) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let weight = if size >= TITLE { " font-weight=\"600\"" } else { "" };
        let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        let _ = writeln!(
            self.body,
            "<text x=\"{:.2}\" y=\"{:.2}\" text-anchor=\"{anchor}\" font-size=\"{size}\"{weight} fill=\"{colour}\"{attributes}>{text}</text>",
            at.x, at.y
        );
    }

    /// A PNG file, stretched to `size`.
    pub fn picture(&mut self, corner: DVec2, size: DVec2, png: &[u8]) {
        let _ = write!(
            self.body,
            "<image x=\"{:.2}\" y=\"{:.2}\" width=\"{:.2}\" height=\"{:.2}\" href=\"data:image/png;base64,",
            corner.x, corner.y, size.x, size.y
        );
        BASE64_STANDARD.encode_string(png, &mut self.body);
        self.body.push_str("\"/>\n");
    }

    /// Clips everything that `draw` draws to a rectangle.
    pub fn clipped(&mut self, corner: DVec2, size: DVec2, draw: impl FnOnce(&mut Self)) {
        let id = self.body.len(); // unique within the page
        let _ = writeln!(
            self.body,
            "<clipPath id=\"c{id}\"><rect x=\"{:.2}\" y=\"{:.2}\" width=\"{:.2}\" height=\"{:.2}\"/></clipPath><g clip-path=\"url(#c{id})\">",
            corner.x, corner.y, size.x, size.y
        );
        draw(self);
        self.body.push_str("</g>\n");
    }

    /// The SVG document.
    pub fn finish(self) -> String {
        let DVec2 { x, y } = self.size;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{x}\" height=\"{y}\" viewBox=\"0 0 {x} {y}\" font-family=\"Helvetica, Arial, sans-serif\" stroke-linejoin=\"round\">\n{}</svg>\n",
            self.body
        )
    }
}
