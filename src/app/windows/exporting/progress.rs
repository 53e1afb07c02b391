//! The progress of an export: its share and words, and the bar that shows them.

use crate::app::theme::{Palette, ROUNDING};
use crate::app::windows::exporting::Exporter;
use crate::language::{key, say};
use egui::{Align2, CornerRadius, Role, Sense, Ui, Vec2, WidgetInfo};

impl Exporter {
    /// The share of the work in progress that is done, with words.
    pub(super) fn progress(&self) -> Option<(f32, String)> {
        if let Some(done) = self.formula_progress() {
            return Some((done as f32, format!("{:.0}\u{a0}%", 100.0 * done)));
        }
        let job = self.job.as_ref()?;
        let [done, all] = job.count();
        let text = if all > 1 { say(&key::pictures_done(done, all)) } else { String::new() };
        Some((job.progress(), text))
    }
}

/// A progress bar with a text over it; `done` is from 0 to 1.
pub(in crate::app::windows) fn progress_bar(ui: &mut Ui, size: Vec2, done: f32, text: String) {
    let palette = Palette::of(ui.visuals());
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::ProgressIndicator, true, &text));
    let rounding = CornerRadius::same(ROUNDING);
    ui.painter().rect_filled(rect, rounding, palette.border);
    let filled = rect.with_max_x(rect.left() + done.clamp(0.0, 1.0) * rect.width());
    ui.painter().with_clip_rect(filled).rect_filled(rect, rounding, palette.accent_soft.gamma_multiply(0.6));
    let font = egui::TextStyle::Body.resolve(ui.style());
    ui.painter().text(rect.center(), Align2::CENTER_CENTER, text, font, palette.text);
}
