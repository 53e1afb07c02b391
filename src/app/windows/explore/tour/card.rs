//! The card of a step of the tour: its words and the buttons. It lies beside the pictures, on an upright phone below.

use super::steps;
use crate::app::input::action::{Action, Actions, ExploreAction};
use crate::app::input::presentation;
use crate::app::theme::widgets::give_keyboard;
use crate::app::theme::{FINGER_HEIGHT, PHONE_WIDTH, Palette, bold};
use crate::language::{key, say, tr};
use crate::model::motion::PlayAction;
use egui::{Frame, Label, Margin, Panel, RichText, ScrollArea, Ui};

/// On a screen lower than this, in points, a message replaces the card.
const LOW_SCREEN: f32 = 450.0;
/// The least share of the screen's height for the pictures, in every step.
pub const PICTURES: f32 = 0.6;
/// The width of a card beside the pictures, as a share of the screen, and its limits; the lower one only where the
/// pictures keep more than half of the width.
const WIDTH_SHARE: f32 = 0.27;
const WIDTHS: [f32; 2] = [220.0, 340.0];
const MOST_WIDTH: f32 = 0.4;
/// The line between the pictures and a card below them, with rounding to whole points.
const SEPARATOR: f32 = 2.0;
/// The largest height of a card below the pictures, as a share of the screen.
const MOST_HEIGHT: f32 = 0.3;
/// The sizes of title and words, in points, for a screen of one's own and for one that a class sees.
const TITLE: [f32; 2] = [18.0, 22.0];
const WORDS: [f32; 2] = [15.0, 17.0];

/// Whether the screen is lower than [`LOW_SCREEN`].
pub fn is_low(ui: &Ui) -> bool {
    ui.ctx().content_rect().height() < LOW_SCREEN
}

/// Shows the card of a step, whose points move if it `is_moving`; with `takes_focus` the button to go on gets the
/// keyboard focus.
pub fn show(ui: &mut Ui, step: usize, is_moving: bool, takes_focus: bool, actions: &mut Actions) {
    let screen = ui.ctx().content_rect();
    let is_beside = screen.width() >= PHONE_WIDTH || screen.width() > screen.height();
    let margin = if is_low(ui) { Margin::symmetric(12, 8) } else { Margin::symmetric(18, 14) };
    let frame = Frame::new().fill(Palette::of(ui.visuals()).raised).inner_margin(margin);
    let panel = if is_beside {
        let width = (WIDTH_SHARE * screen.width()).clamp(WIDTHS[0], WIDTHS[1]);
        Panel::left("tour").exact_size(width.min(MOST_WIDTH * screen.width()))
    } else {
        let height = ui.available_height() - PICTURES * screen.height() - SEPARATOR;
        Panel::bottom("tour").exact_size(height.min(MOST_HEIGHT * screen.height()))
    };
    panel.resizable(false).frame(frame).show(ui, |ui| content(ui, step, is_moving, takes_focus, actions));
}

/// The buttons at the lower edge, the words in the room above them, scrolling where they do not fit.
fn content(ui: &mut Ui, step: usize, is_moving: bool, takes_focus: bool, actions: &mut Actions) {
    let all = steps();
    let Some(stop) = all.get(step) else { return };
    let Palette { text, weak, .. } = Palette::of(ui.visuals());
    let large = usize::from(presentation::is_large(ui.ctx()));
    let row = Frame::new().inner_margin(Margin { top: 6, ..Margin::ZERO });
    Panel::bottom("tour-buttons").resizable(false).show_separator_line(false).frame(row).show(ui, |ui| {
        ui.horizontal_wrapped(|ui| {
            buttons(ui, step, all.len(), takes_focus, actions);
            if !stop.motions.is_empty() {
                play_button(ui, step, is_moving, actions);
            }
        });
    });
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        ui.label(RichText::new(say(&key::of(step + 1, all.len()))).small().color(weak));
        ui.add(Label::new(RichText::new(tr(stop.title)).font(bold(TITLE[large])).color(text)).wrap());
        ui.add_space(4.0);
        ui.add(Label::new(RichText::new(tr(stop.text)).size(WORDS[large]).color(text)).wrap());
    });
}

/// The buttons of a step out of `count`, in a row.
fn buttons(ui: &mut Ui, step: usize, count: usize, takes_focus: bool, actions: &mut Actions) {
    let mut act = |action| actions.push(Action::Explore(action));
    ui.spacing_mut().interact_size.y = FINGER_HEIGHT;
    if ui.add_enabled(step > 0, egui::Button::new(tr(key::back()))).clicked() {
        act(ExploreAction::Tour(step - 1));
    }
    let is_last = step + 1 == count;
    let label = tr(if is_last { key::keep_picture() } else { key::next() });
    let on = ui.button(label);
    let on = if is_last { on.on_hover_text(tr(key::keep_picture_tooltip())) } else { on };
    if takes_focus {
        give_keyboard(&on, label);
    }
    if on.clicked() {
        act(if is_last { ExploreAction::LeaveTour { keeps: true } } else { ExploreAction::Tour(step + 1) });
    }
    if ui.button(tr(key::end())).on_hover_text(tr(key::end_tour_tooltip())).clicked() {
        act(ExploreAction::LeaveTour { keeps: false });
    }
}

/// The button that stops the points, or shows the step again.
fn play_button(ui: &mut Ui, step: usize, is_moving: bool, actions: &mut Actions) {
    let (label, action) = if is_moving {
        (key::stop_here(), Action::Play(PlayAction::Toggle))
    } else {
        (key::show_again(), Action::Explore(ExploreAction::Tour(step)))
    };
    if ui.button(tr(label)).clicked() {
        actions.push(action);
    }
}
