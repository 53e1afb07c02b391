//! Widgets that egui does not have: segmented switches, sliders with a caption
//! above, message boxes, legend signs.

use crate::app::theme::text_metrics::{button_width, menu_label, text_width};
use crate::app::theme::{PHONE_WIDTH, Palette, ROUNDING, ROW_HEIGHT, control_height};
use crate::language::{Label as Words, Message, key, say, tr};
use egui::containers::menu::{MenuButton, MenuConfig};
use egui::text::LayoutJob;
use egui::{
    Align2, Button, Color32, CornerRadius, FontId, Frame, Galley, Id, Margin, PopupCloseBehavior, Rect, Response,
    RichText, Role, ScrollArea, Sense, Stroke, StrokeKind, TextStyle, Ui, UiBuilder, WidgetInfo, pos2, vec2,
};
use std::ops::RangeInclusive;
use std::sync::Arc;

/// One choice of a [`segmented`] switch.
#[derive(Debug, Clone, Copy)]
pub struct Segment<T> {
    /// The value that it selects.
    pub value: T,
    /// Its label.
    pub label: Words,
    /// Its tooltip, a sentence.
    pub tooltip: Words,
}

/// The font size of the labels of a [`segmented`] switch, in points.
const SEGMENT_TEXT: f32 = 12.5;
/// The least free space on either side of a label.
const SEGMENT_PADDING: f32 = 6.0;

/// A switch with several positions over the full width; returns the newly clicked value.
pub fn segmented<T: Copy + PartialEq>(ui: &mut Ui, segments: &[Segment<T>], current: T) -> Option<T> {
    segmented_where(ui, segments, current, |_| None)
}

/// As [`segmented`]; a position for which `refusal` returns a reason is grayed, with the reason in its tooltip.
pub fn segmented_where<T: Copy + PartialEq>(
    ui: &mut Ui,
    segments: &[Segment<T>],
    current: T,
    refusal: impl Fn(T) -> Option<String>,
) -> Option<T> {
    let palette = Palette::of(ui.visuals());
    let height = control_height(ui, ROW_HEIGHT);
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let rounding = CornerRadius::same(ROUNDING);
    ui.painter().rect(rect, rounding, palette.control, Stroke::new(1.0, palette.border), StrokeKind::Inside);
    let mut chosen = None;
    let mut left = rect.left();
    for (segment, width) in segments.iter().zip(segment_widths(ui, segments, rect.width())) {
        let cell = Rect::from_min_size(pos2(left, rect.top()), vec2(width, height));
        left += width;
        let refused = refusal(segment.value);
        let response = segment_cell(ui, cell, segment, segment.value == current, refused.as_deref());
        if response.clicked() && refused.is_none() && segment.value != current {
            chosen = Some(segment.value);
        }
    }
    chosen
}

/// Equal widths if all labels fit, else widths with equal free space beside the labels.
fn segment_widths<T>(ui: &Ui, segments: &[Segment<T>], whole: f32) -> Vec<f32> {
    let equal = whole / segments.len() as f32;
    let font = FontId::proportional(SEGMENT_TEXT);
    let labels: Vec<f32> = segments.iter().map(|segment| text_width(ui, tr(segment.label), font.clone())).collect();
    if labels.iter().all(|width| width + 2.0 * SEGMENT_PADDING <= equal) {
        return vec![equal; segments.len()];
    }
    let spare = (whole - labels.iter().sum::<f32>()) / segments.len() as f32;
    labels.into_iter().map(|width| width + spare).collect()
}

fn segment_cell<T>(ui: &Ui, cell: Rect, segment: &Segment<T>, selected: bool, refused: Option<&str>) -> Response {
    let palette = Palette::of(ui.visuals());
    let id = ui.scope_id().with(segment.label).with(segment.tooltip);
    let (label, explained) = (tr(segment.label), tr(segment.tooltip));
    let tooltip = refused.map_or_else(|| explained.into(), |reason| format!("{explained}\n\n{reason}"));
    let response = ui.interact(cell, id, Sense::click()).on_hover_text(tooltip);
    response.widget_info(|| WidgetInfo::selected(Role::RadioButton, refused.is_none(), selected, label));
    let (fill, ink) = match (selected, response.hovered()) {
        (true, _) => (palette.accent, palette.on_accent),
        (false, _) if refused.is_some() => (Color32::TRANSPARENT, palette.weak.gamma_multiply(0.6)),
        (false, true) => (palette.control_hovered, palette.text),
        (false, false) => (Color32::TRANSPARENT, palette.text),
    };
    ui.painter().rect_filled(cell.shrink(2.0), CornerRadius::same(ROUNDING - 2), fill);
    if response.has_focus() {
        let ring = Stroke::new(1.5, palette.accent_soft);
        ui.painter().rect_stroke(cell.shrink(2.0), CornerRadius::same(ROUNDING - 2), ring, StrokeKind::Outside);
    }
    ui.painter().text(cell.center(), Align2::CENTER_CENTER, label, FontId::proportional(SEGMENT_TEXT), ink);
    response
}

/// A slider under its caption and value; returns the new value while it is moved.
pub fn captioned_slider(
    ui: &mut Ui,
    caption: &str,
    shown: &str,
    value: f64,
    range: RangeInclusive<f64>,
    logarithmic: bool,
) -> Option<f64> {
    ui.scope(|ui| slider_rows(ui, caption, shown, value, range, logarithmic)).inner
}

fn slider_rows(
    ui: &mut Ui,
    caption: &str,
    shown: &str,
    value: f64,
    range: RangeInclusive<f64>,
    logarithmic: bool,
) -> Option<f64> {
    let palette = Palette::of(ui.visuals());
    ui.spacing_mut().item_spacing.y = 2.0;
    ui.horizontal(|ui| {
        ui.spacing_mut().interact_size.y = 20.0;
        ui.label(caption);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            ui.label(RichText::new(shown).color(palette.weak));
        });
    });
    let mut moved = value;
    let response = ui
        .scope(|ui| {
            ui.spacing_mut().slider_width = ui.available_width();
            ui.visuals_mut().selection.bg_fill = palette.accent_soft;
            ui.visuals_mut().widgets.inactive.bg_fill = palette.border;
            ui.spacing_mut().interact_size.y = control_height(ui, 18.0);
            let slider = egui::Slider::new(&mut moved, range).show_value(false).logarithmic(logarithmic);
            ui.add(slider)
        })
        .inner;
    response.widget_info(|| WidgetInfo::slider(true, moved, caption));
    (response.changed() && moved != value).then_some(moved)
}

/// Content over a picture that takes clicks and drags on its whole area, so that none reaches the picture below.
pub fn opaque<R>(ui: &mut Ui, content: impl FnOnce(&mut Ui) -> R) -> R {
    ui.scope_builder(UiBuilder::new().sense(Sense::CLICK | Sense::DRAG), content).inner
}

/// The button of a message that was clicked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MessageAnswer {
    /// The cross that closes the message.
    Dismiss,
    /// The button of the quick fix.
    QuickFix,
}

/// The width of the button that closes a message, for a mouse.
const CROSS_WIDTH: f32 = 30.0;

/// If the words beside the buttons were narrower than this, the buttons are below the words.
const LEAST_WORDS: f32 = 150.0;

/// The least height of a message's words before they scroll: two lines.
const LEAST_MESSAGE: f32 = 36.0;
/// The vertical margin inside a message's edge.
const MESSAGE_MARGIN: i8 = 8;
const MESSAGE_EDGE: f32 = 1.0;

/// Words with more lines than this are folded to [`FOLDED_LINES`] until they are asked for in full.
const MOST_LINES: usize = 4;
const FOLDED_LINES: usize = 3;

/// An error in a box, with a button to close it and the button of its quick fix, if it has one. Long words are folded.
/// The box is at most `most` high, or two lines if that is more; longer words scroll, so that the buttons are always
/// visible.
pub fn message_box(ui: &mut Ui, text: &Message, quick_fix: Option<Words>, most: f32) -> Option<MessageAnswer> {
    let palette = Palette::of(ui.visuals());
    let frame = Frame::new()
        .fill(palette.error_ground)
        .stroke(Stroke::new(MESSAGE_EDGE, palette.error_edge))
        .corner_radius(CornerRadius::same(ROUNDING + 2))
        .inner_margin(Margin::symmetric(12, MESSAGE_MARGIN));
    let most = most - 2.0 * (f32::from(MESSAGE_MARGIN) + MESSAGE_EDGE);
    let content = |ui: &mut Ui| {
        let mut words = FoldedWords::new(ui, text);
        let buttons = button_row_width(ui, quick_fix);
        if ui.available_width() - buttons < LEAST_WORDS {
            words.show(ui, most - ui.spacing().item_spacing.y - ui.spacing().interact_size.y);
            return ui.horizontal(|ui| message_buttons(ui, &words, quick_fix)).inner;
        }
        let in_a_row = |ui: &mut Ui| {
            ui.scope(|ui| {
                ui.set_max_width(ui.available_width() - buttons);
                words.show(ui, most);
            });
            message_buttons(ui, &words, quick_fix)
        };
        ui.horizontal(in_a_row).inner
    };
    opaque(ui, |ui| frame.show(ui, content).inner)
}

/// The width of a message's buttons, with the one that unfolds it.
fn button_row_width(ui: &Ui, quick_fix: Option<Words>) -> f32 {
    let labels = [Some(key::more_words()), quick_fix].into_iter().flatten();
    let labels: f32 = labels.map(|label| button_width(ui, tr(label))).sum();
    control_height(ui, CROSS_WIDTH) + ui.spacing().item_spacing.x + labels
}

/// The words of a message: all of them, or their first lines.
struct FoldedWords {
    words: String,
    id: Id,
    is_long: bool,
    unfolded: bool,
}

impl FoldedWords {
    fn new(ui: &Ui, text: &Message) -> Self {
        let words = say(text);
        let id = Id::unique(("unfolded", &words));
        let unfolded = ui.data(|data| data.get_temp(id)).unwrap_or(false);
        Self { words, id, is_long: false, unfolded }
    }

    fn galley(&self, ui: &Ui, most_rows: usize) -> Arc<Galley> {
        let font = TextStyle::Body.resolve(ui.style());
        let ink = Palette::of(ui.visuals()).text;
        let mut job = LayoutJob::simple(self.words.clone(), font, ink, ui.available_width());
        job.wrap.max_rows = most_rows;
        ui.painter().layout_job(job)
    }

    /// Shows the words, at most `most` high or two lines.
    fn show(&mut self, ui: &mut Ui, most: f32) {
        let whole = self.galley(ui, usize::MAX);
        self.is_long = whole.rows.len() > MOST_LINES;
        let shown = if self.is_long && !self.unfolded { self.galley(ui, FOLDED_LINES) } else { whole };
        let most = most.max(LEAST_MESSAGE);
        if shown.size().y <= most {
            ui.label(shown);
            return;
        }
        // a scroll area inherits the layout: in a horizontal one its content would be centered vertically
        let area = ScrollArea::vertical().max_height(most).min_scrolled_height(most);
        ui.vertical(|ui| area.show(ui, |ui| ui.label(shown)));
    }

    /// The button that unfolds long words, or folds them again.
    fn button(&self, ui: &mut Ui) {
        let label = if self.unfolded { key::fewer_words() } else { key::more_words() };
        if self.is_long && ui.button(tr(label)).clicked() {
            ui.data_mut(|data| data.insert_temp(self.id, !self.unfolded));
        }
    }
}

fn message_buttons(ui: &mut Ui, words: &FoldedWords, quick_fix: Option<Words>) -> Option<MessageAnswer> {
    words.button(ui);
    let helps = quick_fix.is_some_and(|label| ui.button(tr(label)).clicked());
    let width = control_height(ui, CROSS_WIDTH);
    let cross = ui.add(Button::new("×").min_size(vec2(width, 0.0))).on_hover_text(tr(key::close_message()));
    cross.widget_info(|| WidgetInfo::labeled(Role::Button, true, tr(key::close_message())));
    if cross.clicked() { Some(MessageAnswer::Dismiss) } else { helps.then_some(MessageAnswer::QuickFix) }
}

/// A notice of success in a box; the caller removes it after some time.
pub fn notice_box(ui: &mut Ui, text: Words) {
    let palette = Palette::of(ui.visuals());
    Frame::new()
        .fill(palette.panel)
        .stroke(Stroke::new(1.0, palette.border))
        .corner_radius(CornerRadius::same(ROUNDING + 2))
        .inner_margin(Margin::symmetric(12, 8))
        .show(ui, |ui| ui.vertical_centered(|ui| ui.label(RichText::new(tr(text)).color(palette.text))));
}

/// The button that closes a window, as high as touch needs on touch screens; the cross in the title bar is not.
pub fn close_button(ui: &mut Ui) -> Response {
    let size = vec2(CLOSE_WIDTH, control_height(ui, ROW_HEIGHT));
    ui.add_sized(size, Button::new(tr(key::close())))
}

const CLOSE_WIDTH: f32 = 88.0;

/// Moves the keyboard focus to a button and announces it: egui announces only a focus that the user has moved.
pub fn give_keyboard(button: &Response, label: &str) {
    button.request_focus();
    let said = egui::output::OutputEvent::FocusGained(WidgetInfo::labeled(Role::Button, true, label));
    button.ctx.output_mut(|output| output.events.push(said));
}

/// A button that opens a menu, with a chevron; a phone's bar has no room for chevrons.
pub fn drop_down(ui: &mut Ui, label: &str, closes: PopupCloseBehavior, content: impl FnOnce(&mut Ui)) {
    let is_plain = ui.ctx().content_rect().width() < PHONE_WIDTH;
    let text = if is_plain { label.to_owned() } else { menu_label(label) };
    let least = if is_plain { control_height(ui, 0.0) } else { 0.0 };
    let button = MenuButton::from_button(Button::new(text).min_size(vec2(least, 0.0)));
    let (response, _) = button.config(MenuConfig::new().close_behavior(closes)).ui(ui, content);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, label));
    if !is_plain {
        chevron(ui, response.rect, false);
    }
}

/// The width of a [`drop_down`] button and of the gap beside it, in points.
pub fn drop_down_width(ui: &Ui, label: &str) -> f32 {
    let is_plain = ui.ctx().content_rect().width() < PHONE_WIDTH;
    let width = if is_plain { button_width(ui, label) } else { button_width(ui, &menu_label(label)) };
    let least = if is_plain { control_height(ui, 0.0) + ui.spacing().item_spacing.x } else { 0.0 };
    width.max(least)
}

/// A chevron at the right end of a button that opens a menu or sheet, pointing down or up.
pub fn chevron(ui: &Ui, button: Rect, up: bool) {
    let center = button.right_center() - vec2(13.0, 0.0);
    let (half, rise) = (4.0, if up { -2.0 } else { 2.0 });
    let points = vec![center + vec2(-half, -rise), center + vec2(0.0, rise), center + vec2(half, -rise)];
    ui.painter().line(points, Stroke::new(1.5, Palette::of(ui.visuals()).weak));
}

/// The largest width of a [`dot`] or a [`dash`].
pub const SIGN_WIDTH: f32 = 12.0;

/// A filled circle, as the sign of a legend entry.
pub fn dot(ui: &mut Ui, colour: Color32) {
    let (rect, _) = ui.allocate_exact_size(vec2(10.0, 10.0), Sense::hover());
    ui.painter().circle_filled(rect.center(), 5.0, colour);
}

/// A filled square, as the sign of an area in a legend.
pub fn patch(ui: &mut Ui, colour: Color32) {
    let (rect, _) = ui.allocate_exact_size(vec2(10.0, 10.0), Sense::hover());
    ui.painter().rect_filled(rect, 2, colour);
}

/// An empty square with this edge, as the sign of marks in a legend.
pub fn square(ui: &mut Ui, colour: Color32) {
    let (rect, _) = ui.allocate_exact_size(vec2(10.0, 10.0), Sense::hover());
    ui.painter().rect_stroke(rect, 2, Stroke::new(1.5, colour), StrokeKind::Inside);
}

/// A short line, as the sign of a legend entry.
pub fn dash(ui: &mut Ui, colour: Color32) {
    let (rect, _) = ui.allocate_exact_size(vec2(SIGN_WIDTH, 10.0), Sense::hover());
    ui.painter().line_segment([rect.left_center(), rect.right_center()], Stroke::new(2.5, colour));
}

/// The font of captions in the viewports: the small text style.
pub fn caption_font(ui: &Ui) -> FontId {
    TextStyle::Small.resolve(ui.style())
}
