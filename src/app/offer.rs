//! After a picture has become the texture: the offer to trace an outline of it.

use super::action::{Action, Actions};
use super::files::{self, Picture};
use super::language::tr;
use super::theme::{Palette, ROUNDING};
use super::tracing;
use super::widgets::opaque;
use crate::conformal::Side;
use egui::{Align, Button, CornerRadius, Frame, Layout, Margin, Rect, Stroke, Ui, UiBuilder, pos2, vec2};

/// How long the offer stands, in seconds: a sentence and two buttons are read in five.
const SECONDS: f64 = 12.0;

/// A picture that can be traced.
pub struct Offer {
    side: Side,
    picture: Picture,
    /// Since it was first shown, when it ends (seconds).
    until: Option<f64>,
}

impl Offer {
    /// Keeps as much of the picture as is traced.
    pub fn new(side: Side, picture: &Picture) -> Self {
        let (width, height) = picture.pixels.dimensions();
        let pixels = match width.max(height) {
            0..=tracing::MAX_SIDE => picture.pixels.clone(),
            largest => {
                let scaled = |length: u32| (length * tracing::MAX_SIDE / largest).max(1);
                image::imageops::thumbnail(&picture.pixels, scaled(width), scaled(height))
            }
        };
        Self { side, picture: Picture { name: picture.name.clone(), pixels }, until: None }
    }

    /// What tracing it gives.
    pub fn accept(&self) -> Result<files::Content, files::FileError> {
        files::traced(self.side, &self.picture)
    }
}

/// Shows the offer over the middle of the pictures while it stands.
pub fn show(ui: &mut Ui, offer: &mut Option<Offer>, actions: &mut Actions) {
    let Some(standing) = offer else { return };
    let now = ui.input(|input| input.time);
    let left = *standing.until.get_or_insert(now + SECONDS) - now;
    if left <= 0.0 {
        *offer = None;
        return;
    }
    ui.ctx().request_repaint_after_secs(left as f32);
    let palette = Palette::of(ui.visuals());
    let area = ui.max_rect();
    let width = (area.width() - 16.0).min(420.0);
    let place = Rect::from_min_size(pos2(area.center().x - 0.5 * width, area.bottom() - 110.0), vec2(width, 56.0));
    ui.scope_builder(UiBuilder::new().max_rect(place).layout(Layout::top_down(Align::Center)), |ui| {
        let frame = Frame::new()
            .fill(palette.panel)
            .stroke(Stroke::new(1.0, palette.border))
            .corner_radius(CornerRadius::same(ROUNDING + 2))
            .inner_margin(Margin::symmetric(12, 6));
        opaque(ui, |ui| {
            frame.show(ui, |ui| {
                ui.horizontal_wrapped(|ui| {
                    ui.label(tr("The picture is the texture."));
                    let trace = ui.add(Button::new(tr("Trace it as outline")).min_size(vec2(0.0, 40.0)));
                    if trace.on_hover_text(tr("The outline of the largest shape in a PNG or JPEG")).clicked() {
                        actions.push(Action::TraceImage);
                    }
                    if ui.add(Button::new(tr("No")).min_size(vec2(40.0, 40.0))).clicked() {
                        actions.push(Action::DismissOffer);
                    }
                });
            })
        });
    });
}
