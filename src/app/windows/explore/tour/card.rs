//! The guided tour: six sessions with a few sentences each.

use crate::app::input::action::{Action, Actions, ExploreAction};
use crate::app::theme::widgets::give_keyboard;
use crate::app::theme::{FINGER_HEIGHT, Palette, bold};
use crate::app::windows::explore::gallery::crowding;
use crate::conformal::{Direction, Side};
use crate::language::{Label as Words, key, say, tr};
use crate::outline::Preset;
use crate::session::{Command, OutlineSpec, Session, SurfaceShape, SurfaceSpec, TextureKind};
use crate::surface::SurfacePreset;
use egui::{Frame, Label, Margin, Panel, RichText, ScrollArea, Ui};
use std::sync::LazyLock;

/// One step of the tour.
pub struct Step {
    pub title: Words,
    /// The sentences: what there is to see and to try.
    pub text: Words,
    /// The session that is shown.
    pub session: Session,
    /// Whether the random walks run.
    pub walks: bool,
}

/// All steps, in order; built once.
pub fn steps() -> &'static [Step] {
    static STEPS: LazyLock<Vec<Step>> = LazyLock::new(make_steps);
    &STEPS
}

fn make_steps() -> Vec<Step> {
    let step = |title, text, session| Step { title, text, session, walks: false };
    let polar = Session::with([Command::SetTexture(TextureKind::Conformal)]);
    vec![
        step(
            key::map_between_two_shapes(),
            key::map_between_two_shapes_about(),
            Session::with([Command::SetTextureScale(9.0)]),
        ),
        step(key::angles_stay(), key::angles_stay_about(), Session::with([Command::SetTextureScale(20.0)])),
        step(key::three_freedoms(), key::three_freedoms_about(), polar),
        Step { title: key::harmonic_measure(), text: key::harmonic_measure_about(), session: measured(), walks: true },
        step(key::crowding(), key::tour_crowding_about(), crowding()),
        step(key::surfaces(), key::surfaces_about(), solid()),
    ]
}

fn measured() -> Session {
    Session::with([
        Command::SetPlots(true),
        Command::SetDirection(Direction::Backward),
        Command::SetOutline { side: Side::Source, outline: OutlineSpec::Preset(Preset::Hand) },
        Command::SetOutline { side: Side::Target, outline: OutlineSpec::Preset(Preset::Disk) },
    ])
}

fn solid() -> Session {
    let surface = SurfaceSpec { shape: SurfaceShape::preset(SurfacePreset::AnimalHead), ..SurfaceSpec::default() };
    Session::with([Command::SetSurface { side: Side::Target, surface }])
}

/// Shows the text and the buttons of a step in a panel below the pictures; with `takes_focus` the button to go on gets
/// the keyboard focus.
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

/// On a screen lower than this, in points, the title is beside the buttons and the text takes three lines and scrolls.
const LOW_SCREEN: f32 = 450.0;
const LOW_WORDS: f32 = 50.0;

/// Whether the screen is lower than [`LOW_SCREEN`].
pub fn is_low(ui: &Ui) -> bool {
    ui.ctx().content_rect().height() < LOW_SCREEN
}

/// The buttons of a step and its number out of `count`, in a row.
fn buttons(ui: &mut Ui, step: usize, count: usize, takes_focus: bool, actions: &mut Actions) {
    let weak = Palette::of(ui.visuals()).weak;
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
    ui.label(RichText::new(say(&key::of(step + 1, count))).color(weak));
}
