//! The course of a search for the best map: the value of the best map so far against the number of maps that were tried.
//!
//! Values in closed form and those of the maps themselves differ by the error of the closed form; they are lines of their
//! own, in different inks. The vertical axis is logarithmic, both axes end at the data. The values of the first and of the
//! last map stand beside the plot, where they cover nothing.

use crate::app::theme::Palette;
use crate::app::theme::text_metrics::text_width;
use crate::app::theme::widgets::caption_font;
use crate::language::{key, significant, tr};
use crate::model::best::Least;
use egui::{Align2, CornerRadius, Painter, Pos2, Rect, Sense, Stroke, StrokeKind, Ui, pos2, vec2};

/// The height of the plot, in points.
const HEIGHT: f32 = 64.0;
/// The free space inside its frame, and between a value and the curve.
const INSET: [f32; 2] = [6.0, 8.0];
const BESIDE: f32 = 8.0;
/// The radius of the dots at the first and at the last map.
const DOT: f32 = 2.5;

/// Shows a course; values that are not positive and finite are left out.
pub fn show(ui: &mut Ui, course: &[Least]) {
    let (frame, response) = ui.allocate_exact_size(vec2(ui.available_width(), HEIGHT), Sense::hover());
    response.on_hover_text(tr(key::course_tooltip()));
    let palette = Palette::of(ui.visuals());
    let painter = ui.painter_at(frame);
    painter.rect_stroke(frame, CornerRadius::same(4), Stroke::new(1.0, palette.border), StrokeKind::Inside);
    let known: Vec<Least> = course.iter().copied().filter(|each| each.value.is_finite() && each.value > 0.0).collect();
    let (Some(first), Some(last)) = (known.first(), known.last()) else { return };
    let [begun, reached] = [first, last].map(|each| significant(each.value, 3));
    let [left, right] = [&begun, &reached].map(|text| text_width(ui, text, caption_font(ui)) + BESIDE);
    let inner = frame.shrink2(INSET.into());
    let axes = Axes::of(&known, inner.with_min_x(inner.left() + left).with_max_x(inner.right() - right));
    for (line, is_measured) in axes.lines(&known) {
        painter.line(line, Stroke::new(1.5, if is_measured { palette.accent_soft } else { palette.weak }));
    }
    for each in [first, last] {
        let ink = if each.is_measured { palette.accent_soft } else { palette.weak };
        painter.circle_filled(axes.place(each.evaluations, each.value), DOT, ink);
    }
    let beside = |align: Align2, x: f32, each: &Least, text: String| {
        let y = axes.place(0, each.value).y;
        text_within(&painter, ui, frame, (align, pos2(x, y)), text, &palette);
    };
    beside(Align2::LEFT_CENTER, inner.left(), first, begun);
    beside(Align2::RIGHT_CENTER, inner.right(), last, reached);
}

/// A text that is moved up or down into the frame.
fn text_within(painter: &Painter, ui: &Ui, frame: Rect, (align, at): (Align2, Pos2), text: String, palette: &Palette) {
    let galley = painter.layout_no_wrap(text, caption_font(ui), palette.text);
    let room = 0.5 * galley.size().y + 2.0;
    let at = pos2(at.x, at.y.clamp(frame.top() + room, frame.bottom() - room));
    painter.galley(align.anchor_size(at, galley.size()).min, galley, palette.text);
}

/// Where numbers of maps and values lie.
struct Axes {
    area: Rect,
    count: f32,
    least: f64,
    /// The logarithm of the ratio of the largest to the least value.
    span: f64,
}

impl Axes {
    fn of(known: &[Least], area: Rect) -> Self {
        let values = || known.iter().map(|each| each.value);
        let (least, most) = (values().fold(f64::INFINITY, f64::min), values().fold(0.0, f64::max));
        let count = known.last().map_or(1, |each| each.evaluations.max(1)) as f32;
        Self { area, count, least, span: (most / least).ln().max(1e-3) }
    }

    fn place(&self, evaluations: usize, value: f64) -> Pos2 {
        let height = ((value / self.least).ln() / self.span) as f32;
        let x = self.area.left() + evaluations as f32 / self.count * self.area.width();
        pos2(x, self.area.bottom() - height * self.area.height())
    }

    /// A line in steps for each part of the course in closed form or of maps themselves, until the next part begins; and
    /// whether it is of maps themselves.
    fn lines(&self, known: &[Least]) -> Vec<(Vec<Pos2>, bool)> {
        let mut lines = Vec::new();
        let mut rest = known;
        while let Some(first) = rest.first() {
            let is_same = |each: &&Least| each.is_measured == first.is_measured;
            let (part, after) = rest.split_at(rest.iter().take_while(is_same).count());
            let ends = part.iter().skip(1).chain(after.first()).map(|next| next.evaluations);
            let steps = part.iter().zip(ends.chain(part.last().map(|last| last.evaluations)));
            let line =
                steps.flat_map(|(each, end)| [self.place(each.evaluations, each.value), self.place(end, each.value)]);
            lines.push((line.collect(), first.is_measured));
            rest = after;
        }
        lines
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn closed_form_and_measured_values_are_lines_of_their_own() {
        let least = |evaluations, value, is_measured| Least { evaluations, value, is_measured };
        let course = [
            least(0, 0.8, true),
            least(1, 0.9, false),
            least(40, 0.3, false),
            least(100, 0.35, true),
            least(150, 0.31, true),
        ];
        let area = Rect::from_min_max(pos2(0.0, 0.0), pos2(150.0, 50.0));
        let axes = Axes::of(&course, area);
        let lines = axes.lines(&course);
        let kinds: Vec<bool> = lines.iter().map(|(_, is_measured)| *is_measured).collect();
        assert_eq!(kinds, [true, false, true]);
        assert!(lines.iter().flat_map(|(line, _)| line).all(|place| area.expand(0.01).contains(*place)));
        // the line in closed form ends where maps are measured, and does not rise to them
        let (closed, _) = &lines[1];
        assert_eq!(*closed.last().unwrap(), axes.place(100, 0.3));
        assert_eq!(*lines[2].0.last().unwrap(), axes.place(150, 0.31));
    }
}
