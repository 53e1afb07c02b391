//! The point under the pointer, its image, and the scale and turning of the map there, in words.

use crate::app::theme::Palette;
use crate::app::theme::text_metrics::text_width;
use crate::app::theme::widgets::caption_font;
use crate::geometry::DVec2;
use crate::language::{key, number, say, significant, tr};
use crate::model::PointedImage;
use egui::{Label, RichText, Ui};

/// The most decimals, from the wide form to the narrow one.
const MOST_DECIMALS: [usize; 5] = [12, 9, 6, 4, 3];
/// The decimals of values that are interpolated in the mesh.
const OF_MESH: usize = 3;

/// Shows the form with the most decimals for which there is room.
pub fn show(ui: &mut Ui, image: &PointedImage, decimals: usize) {
    let width = ui.available_width();
    let mut forms = MOST_DECIMALS.map(|most| words(image, decimals.min(most), most)).into_iter();
    let fits = |words: &String| text_width(ui, words, caption_font(ui)) <= width;
    let last = words(image, OF_MESH, 2);
    let words = forms.find(fits).unwrap_or(last);
    let label = Label::new(RichText::new(words).small().color(Palette::of(ui.visuals()).weak)).truncate();
    ui.add(label).on_hover_text(tr(key::pointed_tooltip()));
}

fn words(image: &PointedImage, decimals: usize, most: usize) -> String {
    let Numbers { point, image: there, scale, turning } = Numbers::new(image, decimals, most);
    let words = say(&key::pointed(point, there, scale, turning));
    if image.errors.is_some() { words } else { format!("{words} · {}", tr(key::by_mesh())) }
}

/// The sentence for screen readers.
pub fn sentence(image: &PointedImage) -> String {
    let Numbers { point, image, scale, turning } = Numbers::new(image, 3, 6);
    say(&key::accessible_pointed(point, image, scale, turning))
}

struct Numbers {
    point: String,
    image: String,
    scale: String,
    turning: String,
}

impl Numbers {
    /// With as many decimals as the errors allow, and at most this many.
    fn new(image: &PointedImage, decimals: usize, most: usize) -> Self {
        let errors = image.errors;
        let of = |error: Option<f64>| error.map_or(OF_MESH, right_decimals).min(most);
        let scale = image.scale();
        let degrees = errors.map(|errors| (errors.derivative / scale).min(1.0).to_degrees());
        Self {
            point: complex(image.point, decimals),
            image: complex(image.image, of(errors.map(|errors| errors.image))),
            scale: significant(scale, of(errors.map(|errors| errors.derivative / scale))),
            turning: signed(image.turning(), if errors.is_some() { of(degrees) } else { 1 }),
        }
    }
}

/// The decimals to which a number with this error is right.
fn right_decimals(error: f64) -> usize {
    (-error.log10()).floor().clamp(0.0, 15.0) as usize
}

fn signed(value: f64, decimals: usize) -> String {
    number(value, decimals).replace('-', "−")
}

fn complex(z: DVec2, decimals: usize) -> String {
    let sign = if z.y < 0.0 { '−' } else { '+' };
    format!("{} {sign} {}i", signed(z.x, decimals), number(z.y.abs(), decimals))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conformal::Side;
    use crate::model::PointedErrors;

    const SEEN: PointedImage = PointedImage {
        side: Side::Source,
        point: DVec2::new(0.25, -0.5),
        image: DVec2::new(-0.123_456_789_012_3, 0.5),
        derivative: DVec2::new(0.0, -0.02),
        errors: Some(PointedErrors { image: 2e-8, derivative: 1e-7 }),
    };

    #[test]
    fn as_many_digits_are_shown_as_the_error_allows_and_as_fit() {
        let text = "0.25 − 0.50i → −0.1234568 + 0.5000000i · scale 0.020000 · turning −90.000°";
        assert_eq!(words(&SEEN, 2, 12), text);
        assert_eq!(words(&SEEN, 2, 3), "0.25 − 0.50i → −0.123 + 0.500i · scale 0.0200 · turning −90.000°");
        let rough = PointedImage { errors: None, ..SEEN };
        assert_eq!(words(&rough, 2, 12), "0.25 − 0.50i → −0.123 + 0.500i · scale 0.0200 · turning −90.0° · mesh");
    }
}
