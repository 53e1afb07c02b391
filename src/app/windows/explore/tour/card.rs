//! The card of a step of the tour or of a lesson: its words and the buttons. It lies beside the pictures, on an upright
//! phone below.

use super::Stop;
use crate::app::input::action::{Action, Actions, ExploreAction};
use crate::app::input::presentation;
use crate::app::plots::{BoundaryPlace, Plots};
use crate::app::theme::icons::{Icon, icon_button};
use crate::app::theme::text_metrics::button_width;
use crate::app::theme::widgets::give_keyboard;
use crate::app::theme::{FINGER_HEIGHT, PHONE_WIDTH, Palette, bold};
use crate::language::{Label as Words, key, say, tr};
use crate::model::Model;
use crate::model::motion::PlayAction;
use egui::{Button, Frame, Label, Margin, Panel, Response, RichText, ScrollArea, Ui};

/// On a screen lower than this, in points, a message replaces the card.
const LOW_SCREEN: f32 = 450.0;
/// The least share of the screen's height for the pictures, in every step.
pub const PICTURES: f32 = 0.6;
/// The width of a card beside the pictures, as a share of the screen, and its limits; the lower one only where the
/// pictures keep more than half of the width.
const WIDTH_SHARE: f32 = 0.27;
const WIDTHS: [f32; 2] = [220.0, 340.0];
const MOST_WIDTH: f32 = 0.4;
/// On screens lower than this, such as a laptop's at 200 %, a card beside the pictures is as wide as it may be, so that
/// its words fit.
const WIDEST_BELOW: f32 = 500.0;
/// The line between the pictures and a card below them, with rounding to whole points.
const SEPARATOR: f32 = 2.0;
/// The largest height of a card below the pictures, as a share of the screen.
const MOST_HEIGHT: f32 = 0.3;
/// The space between buttons of which some are icons, in points.
const BETWEEN_ICONS: f32 = 4.0;
/// The sizes of title and words, in points, for a screen of one's own and for one that a class sees.
const TITLE: [f32; 2] = [18.0, 22.0];
const WORDS: [f32; 2] = [15.0, 17.0];

/// Whether the screen is lower than [`LOW_SCREEN`].
pub fn is_low(ui: &Ui) -> bool {
    ui.ctx().content_rect().height() < LOW_SCREEN
}

/// What the card shows.
pub struct Card<'a> {
    pub stop: Stop<'a>,
    /// The step, counted from 0, and the number of steps.
    pub step: usize,
    pub count: usize,
    /// Whether it is a lesson.
    pub is_lesson: bool,
    /// What the step does by itself.
    pub motion: Motion,
    /// Whether the button to go on gets the keyboard focus.
    pub takes_focus: bool,
    /// The plots that have no room elsewhere.
    pub plots: Option<CardPlots<'a>>,
}

/// The state of what a step does by itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Motion {
    /// It waits until the user asks for it.
    Waiting,
    /// Points move.
    Moving,
    /// It is over, or there is none.
    Over,
}

/// The plots for a card.
#[derive(Clone, Copy)]
pub struct CardPlots<'a> {
    pub plots: &'a Plots,
    pub model: &'a Model,
    /// Whether they are shown in place of the words.
    pub are_shown: bool,
}

/// The width of a card beside the pictures; `None` if it is below them.
pub fn width_beside(ui: &Ui) -> Option<f32> {
    let screen = ui.ctx().content_rect();
    let is_beside = screen.width() >= PHONE_WIDTH || screen.width() > screen.height();
    let share = if is_tight(ui) { MOST_WIDTH } else { WIDTH_SHARE };
    let width = (share * screen.width()).clamp(WIDTHS[0], WIDTHS[1]).min(MOST_WIDTH * screen.width());
    is_beside.then_some(width)
}

/// Whether the screen is lower than [`WIDEST_BELOW`].
fn is_tight(ui: &Ui) -> bool {
    ui.ctx().content_rect().height() < WIDEST_BELOW
}

/// How the buttons of a row are labeled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Labels {
    /// All by words.
    Words,
    /// Those that everybody knows by icons, as the words do not fit into one row.
    Icons,
}

impl Labels {
    fn button(self, ui: &mut Ui, icon: Icon, is_enabled: bool, [name, tooltip]: [Words; 2]) -> Response {
        match self {
            Self::Icons => icon_button(ui, icon, is_enabled, tr(name), tr(tooltip)),
            Self::Words if name == tooltip => ui.add_enabled(is_enabled, Button::new(tr(name))),
            Self::Words => ui.add_enabled(is_enabled, Button::new(tr(name))).on_hover_text(tr(tooltip)),
        }
    }
}

impl Card<'_> {
    /// Shows the card; returns the place under the pointer in its plots.
    pub fn show(&self, ui: &mut Ui, actions: &mut Actions) -> Option<BoundaryPlace> {
        let screen = ui.ctx().content_rect();
        let margin = if is_tight(ui) { Margin::symmetric(12, 8) } else { Margin::symmetric(18, 14) };
        let frame = Frame::new().fill(Palette::of(ui.visuals()).raised).inner_margin(margin);
        let panel = if let Some(width) = width_beside(ui) {
            Panel::left("tour").exact_size(width)
        } else {
            let height = ui.available_height() - PICTURES * screen.height() - SEPARATOR;
            Panel::bottom("tour").exact_size(height.min(MOST_HEIGHT * screen.height()))
        };
        panel.resizable(false).frame(frame).show(ui, |ui| self.content(ui, actions)).inner
    }

    /// The buttons at the lower edge, in the room above them the words, scrolling where they do not fit, or the plots.
    fn content(&self, ui: &mut Ui, actions: &mut Actions) -> Option<BoundaryPlace> {
        let row = Frame::new().inner_margin(Margin { top: 6, ..Margin::ZERO });
        Panel::bottom("tour-buttons").resizable(false).show_separator_line(false).frame(row).show(ui, |ui| {
            ui.horizontal_wrapped(|ui| {
                let labels = self.labels(ui);
                self.buttons(ui, labels, actions);
                if self.has_play_button() {
                    self.play_button(ui, labels, actions);
                }
                if let Some(CardPlots { are_shown, .. }) = self.plots {
                    plots_button(ui, are_shown, actions);
                }
            });
        });
        if let Some(CardPlots { plots, model, .. }) = self.plots.filter(|plots| plots.are_shown) {
            return plots.show_one(ui, model, actions);
        }
        // each step begins at the top
        let words = ScrollArea::vertical().id_salt(("tour-words", self.step)).auto_shrink(false);
        words.show(ui, |ui| self.words(ui));
        None
    }

    fn words(&self, ui: &mut Ui) {
        let Palette { text, weak, .. } = Palette::of(ui.visuals());
        let large = usize::from(presentation::is_large(ui.ctx()));
        let Stop { title, text: words, .. } = self.stop;
        ui.label(RichText::new(say(&key::of(self.step + 1, self.count))).small().color(weak));
        if !title.is_empty() {
            ui.add(Label::new(RichText::new(title).font(bold(TITLE[large])).color(text)).wrap());
            ui.add_space(4.0);
        }
        ui.add(Label::new(RichText::new(words).size(WORDS[large]).color(text)).wrap());
    }

    /// Words where all buttons fit beside each other, else icons.
    fn labels(&self, ui: &mut Ui) -> Labels {
        let play = self.has_play_button().then_some(self.play().1);
        let plots = self.plots.map(|_| key::plots());
        let all = [key::back(), self.on(), key::end()].into_iter().chain(play).chain(plots);
        let width: f32 = all.map(|label| button_width(ui, tr(label))).sum();
        if width - ui.spacing().item_spacing.x <= ui.available_width() {
            return Labels::Words;
        }
        ui.spacing_mut().item_spacing.x = BETWEEN_ICONS;
        Labels::Icons
    }

    fn is_last(&self) -> bool {
        self.step + 1 == self.count
    }

    /// What the button to go on says.
    fn on(&self) -> Words {
        if self.is_last() { key::keep_picture() } else { key::next() }
    }

    fn has_play_button(&self) -> bool {
        !self.stop.motions.is_empty() || (self.motion == Motion::Waiting && self.stop.walks)
    }

    /// The buttons of every step, in a row.
    fn buttons(&self, ui: &mut Ui, labels: Labels, actions: &mut Actions) {
        let mut act = |action| actions.push(Action::Explore(action));
        ui.spacing_mut().interact_size.y = FINGER_HEIGHT;
        if labels.button(ui, Icon::Back, self.step > 0, [key::back(); 2]).clicked() {
            act(ExploreAction::Step(self.step - 1));
        }
        let (is_last, label) = (self.is_last(), tr(self.on()));
        let on = ui.button(label);
        let on = if is_last { on.on_hover_text(tr(key::keep_picture_tooltip())) } else { on };
        if self.takes_focus {
            give_keyboard(&on, label);
        }
        if on.clicked() {
            act(if is_last { ExploreAction::LeaveTour { keeps: true } } else { ExploreAction::Step(self.step + 1) });
        }
        let explained = if self.is_lesson { key::end_lesson_tooltip() } else { key::end_tour_tooltip() };
        if labels.button(ui, Icon::End, true, [key::end(), explained]).clicked() {
            act(ExploreAction::LeaveTour { keeps: false });
        }
    }

    /// What the button that stops the points, or shows the step again, is labeled with, and what it does.
    fn play(&self) -> (Icon, Words, Action) {
        let again = Action::Explore(ExploreAction::Again);
        match self.motion {
            Motion::Waiting => (Icon::Play, key::show_step(), again),
            Motion::Moving => (Icon::Stop, key::stop_here(), Action::Play(PlayAction::Toggle)),
            Motion::Over => (Icon::Again, key::show_again(), again),
        }
    }

    fn play_button(&self, ui: &mut Ui, labels: Labels, actions: &mut Actions) {
        let (icon, label, action) = self.play();
        if labels.button(ui, icon, true, [label; 2]).clicked() {
            actions.push(action);
        }
    }
}

/// The button that shows the plots in place of the words, or the words again.
fn plots_button(ui: &mut Ui, are_shown: bool, actions: &mut Actions) {
    let button = Button::selectable(are_shown, tr(key::plots())).frame_when_inactive(true);
    if ui.add(button).clicked() {
        actions.push(Action::Explore(ExploreAction::CardPlots(!are_shown)));
    }
}
