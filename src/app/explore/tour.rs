//! The guided tour: six pictures with a few sentences each.

use super::ExploreAction;
use super::gallery::crowding;
use crate::app::action::{Action, Actions};
use crate::app::language::{tr, tr_with};
use crate::app::theme::{FINGER_HEIGHT, Palette, bold};
use crate::app::widgets::give_keyboard;
use crate::conformal::Direction;
use crate::outline::Preset;
use crate::session::{Command, OutlineSpec, Session, SurfaceShape, SurfaceSpec, TextureKind};
use crate::surface::SurfacePreset;
use egui::{Frame, Label, Margin, Panel, RichText, ScrollArea, Ui};
use std::sync::LazyLock;

/// One stop.
pub struct Step {
    /// What it is about.
    pub title: &'static str,
    /// What to see, and what to try.
    pub text: &'static str,
    /// The picture.
    pub session: Session,
    /// Whether random walks run.
    pub walks: bool,
}

/// All of them, in order; made once.
pub fn steps() -> &'static [Step] {
    static STEPS: LazyLock<Vec<Step>> = LazyLock::new(make_steps);
    &STEPS
}

fn make_steps() -> Vec<Step> {
    let step = |title, text, session| Step { title, text, session, walks: false };
    let polar = Session { texture: TextureKind::Conformal, ..Session::default() };
    vec![
        step(
            "A map between two shapes",
            "Whatever is drawn inside the left outline is carried into the right one: stretched and turned from place \
             to place, but never torn and never folded. Drag a green dot and watch all of it follow.",
            Session { texture_scale: 9.0, ..Session::default() },
        ),
        step(
            "Angles stay",
            "That is what conformal means. Each small square becomes a small square, larger or smaller and turned, \
             with right angles. The number Q̄ at the bottom says how well: 1 is perfect.",
            Session { texture_scale: 20.0, ..Session::default() },
        ),
        step(
            "Three freedoms",
            "Riemann (1851): between two such outlines there is exactly one conformal map once you say where one inner \
             point goes (two numbers, the green dots) and where one boundary point goes (one number, the magenta dots).",
            polar,
        ),
        Step {
            title: "Harmonic measure",
            text: "Let a random walk start at the green dot. The chance that it leaves through a part of the boundary \
                   is that part's harmonic measure. A conformal map keeps it, so it is enough to match it along both \
                   boundaries: that is how riemap computes.",
            session: measured(),
            walks: true,
        },
        step(
            "Crowding",
            "Why not go through a disk? From this V, arms shrink on the disk's rim to lengths of 10⁻¹⁷, and the \
             computer has no digits left: the marks outside of the outline run together. Matched directly, they stay apart.",
            crowding(),
        ),
        step(
            "Surfaces",
            "The same works for a surface in space with one boundary: each of its points gets a place in the outline. \
             Turn it, drag the dots on it. This is how textures are laid on models.",
            solid(),
        ),
    ]
}

fn measured() -> Session {
    let mut session = Session { plots: true, direction: Direction::Backward, ..Session::default() };
    session.source.outline = OutlineSpec::Preset(Preset::Hand);
    session.target.outline = OutlineSpec::Preset(Preset::Disk);
    session
}

fn solid() -> Session {
    let mut session = Session::default();
    let shape = SurfaceShape::preset(SurfacePreset::AnimalHead);
    session.apply(Command::SetSurface(SurfaceSpec { shape, ..SurfaceSpec::default() }));
    session
}

/// Shows the words of a step below the pictures, which make room; `takes_focus`: its first button gets the keyboard.
pub fn show(ui: &mut Ui, step: usize, takes_focus: bool, actions: &mut Actions) {
    let all = steps();
    let Some(stop) = all.get(step) else { return };
    let palette = Palette::of(ui.visuals());
    let is_low = is_low(ui);
    let margin = if is_low { Margin::symmetric(16, 6) } else { Margin::symmetric(16, 12) };
    let frame = Frame::new().fill(palette.raised).inner_margin(margin);
    let title = RichText::new(tr(stop.title)).font(bold(16.0)).color(palette.text);
    let words = Label::new(RichText::new(tr(stop.text)).color(palette.text)).wrap();
    Panel::bottom("tour").resizable(false).frame(frame).show(ui, |ui| {
        if is_low {
            ui.horizontal(|ui| {
                buttons(ui, step, all.len(), takes_focus, actions);
                ui.add(Label::new(title).truncate());
            });
            let area = ScrollArea::vertical().max_height(LOW_WORDS).min_scrolled_height(LOW_WORDS);
            area.show(ui, |ui| ui.add(words));
        } else {
            ui.label(title);
            ui.add(words);
            ui.add_space(6.0);
            ui.horizontal(|ui| buttons(ui, step, all.len(), takes_focus, actions));
        }
    });
}

/// On a screen lower than this the title stands beside the buttons and the words take three lines; more scroll.
const LOW_SCREEN: f32 = 450.0;
const LOW_WORDS: f32 = 50.0;

/// Whether the screen is one.
pub fn is_low(ui: &Ui) -> bool {
    ui.ctx().content_rect().height() < LOW_SCREEN
}

/// The buttons of a step, and which of `count` it is, into a row.
fn buttons(ui: &mut Ui, step: usize, count: usize, takes_focus: bool, actions: &mut Actions) {
    let weak = Palette::of(ui.visuals()).weak;
    let mut act = |action| actions.push(Action::Explore(action));
    ui.spacing_mut().interact_size.y = FINGER_HEIGHT;
    if ui.add_enabled(step > 0, egui::Button::new(tr("Back"))).clicked() {
        act(ExploreAction::Tour(step - 1));
    }
    let is_last = step + 1 == count;
    let label = tr(if is_last { "Keep this picture" } else { "Next" });
    let on = ui.button(label);
    let on = if is_last { on.on_hover_text(tr("Ends the tour here")) } else { on };
    if takes_focus {
        give_keyboard(&on, label);
    }
    if on.clicked() {
        act(if is_last { ExploreAction::LeaveTour { keeps: true } } else { ExploreAction::Tour(step + 1) });
    }
    if ui.button(tr("End")).on_hover_text(tr("Ends the tour and shows your own picture again")).clicked() {
        act(ExploreAction::LeaveTour { keeps: false });
    }
    ui.label(RichText::new(tr_with("{0} of {1}", &[&(step + 1), &count])).color(weak));
}
