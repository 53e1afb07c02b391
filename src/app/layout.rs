//! The division of the screen: on a desktop bars, panel and two viewports side by
//! side with the plots below; on a phone a sheet of controls or plots, and in portrait orientation
//! the viewports one above the other.

use super::arrangement::Arrangement;
use super::theme::Palette;
use super::{RiemapApp, editing, plots, status, theme};
use crate::app::input::action::{Action, Actions, ExploreAction};
use crate::app::input::keyboard_navigation::follow_focus;
use crate::app::input::presentation;
use crate::app::language::words;
use crate::app::menus::file_menu;
use crate::app::menus::top_bar::TopBar;
use crate::app::message_bar;
use crate::app::panels::side_panel::Column;
use crate::app::panels::{header, play_panel, side_panel, welcome};
use crate::app::plots::BoundaryPlace;
use crate::app::theme::widgets::chevron;
use crate::app::windows::explore::tour;
use crate::app::windows::explore::tour::card::CardPlots;
use crate::app::windows::lesson;
use crate::language::{key, tr};
use crate::session::Command;
use egui::{Event, Frame, Id, Key, Margin, Panel, RichText, ScrollArea, Stroke, Ui, vec2};

/// The width of the side panel.
const PANEL_WIDTH: f32 = 268.0;
/// The width of the scroll bar beside the controls.
const SCROLL_BAR: f32 = 8.0;
/// The height of the sheet's handle, a touch target.
const SHEET_HANDLE: f32 = 44.0;
/// The height of the strip that is left free for the page's own link, if the app is embedded.
const LINK_STRIP: f32 = 28.0;
/// The share of the screen's height that the pictures keep beside the open sheet, at least.
const PICTURES_SHARE: f32 = 0.5;

/// What the layout of bars and panels has found out, for the app to store and carry out.
pub struct LaidOut {
    /// The layout of the screen.
    pub arrangement: Arrangement,
    /// The requests of the panels and of the keys.
    pub actions: Actions,
    /// The place under the pointer in the plots.
    pub pointed: Option<BoundaryPlace>,
    /// Whether the tour's buttons have taken the keyboard focus.
    pub focused_tour: bool,
}

/// Lays out bars, panels and the message below the pictures; changes nothing.
pub fn show(app: &RiemapApp, ui: &mut Ui) -> LaidOut {
    let narrow = ui.available_width() < theme::PHONE_WIDTH;
    theme::suit_pointer(ui.ctx(), narrow || app.screen.has_fingers || ui.input(egui::InputState::has_touch_screen));
    let (mut actions, mut pointed) = (Actions::new(), None);
    keys(app, ui, &mut actions);
    file_menu::keys(ui, &mut actions);
    presentation::keys(ui, &mut actions);
    editing::keys(ui, &app.editor, &app.pictures.views, &mut actions);
    actions.extend(editing::pasted(ui).map(Action::PasteText));
    play_panel::keys(ui, &mut actions);
    if app.screen.panels_open {
        bars(app, ui, narrow, &mut actions);
        // the card of the tour is in the place of the controls
        let is_touring = app.windows.explore.is_touring();
        let makes_lesson = app.windows.lesson.is_open && !is_touring;
        if makes_lesson {
            lesson::show(ui, &app.windows.lesson, app.held(), narrow, &mut actions);
        }
        if narrow && !is_touring && !makes_lesson {
            pointed = sheet(app, ui, &mut actions);
        } else if !narrow && !is_touring && app.screen.column_open(ui.ctx().content_rect().size(), makes_lesson) {
            panel(app, ui, &mut actions);
        }
        if welcomes(app) {
            welcome::show(ui, &mut actions);
        }
    }
    if app.options.embed {
        // the page's link to the whole app is at this place
        let strip = if app.screen.has_fingers { theme::FINGER_HEIGHT } else { LINK_STRIP };
        let frame = Frame::new().fill(Palette::of(ui.visuals()).panel);
        Panel::bottom("link").exact_size(strip).resizable(false).frame(frame).show(ui, |_| {});
    }
    let yields = app.messages.bar.has_message() || app.editor.side().is_some();
    let plots = app.model.session().plots();
    let has_dock = plots && !narrow && (!app.windows.explore.is_touring() || has_room_for_plots(ui));
    let are_shown = app.windows.explore.card_plots;
    let in_card = (plots && !has_dock).then_some(CardPlots { plots: &app.plots, model: &app.model, are_shown });
    let card = app.windows.explore.show_tour(ui, &app.player, yields, in_card, &mut actions);
    if has_dock {
        pointed = dock(app, ui, &mut actions);
    }
    pointed = pointed.or(card.pointed);
    let arrangement = Arrangement::new(ui, narrow);
    message_bar::show(app, ui, &mut actions);
    LaidOut { arrangement, actions, pointed, focused_tour: card.took_focus }
}

/// Whether the welcome is shown: until it is used, and unless a lesson, the tour, a sheet or a drawing needs the room.
fn welcomes(app: &RiemapApp) -> bool {
    let has_lesson = app.windows.explore.is_touring() || app.windows.lesson.is_open;
    let is_busy = has_lesson || app.screen.sheet_open || app.editor.side().is_some();
    !app.screen.preferences.habits.welcomed && !app.options.embed && !app.options.present && !is_busy
}

/// The key P opens or closes the plots, unless a control has the focus.
fn keys(app: &RiemapApp, ui: &Ui, actions: &mut Actions) {
    let is_p = |event: &Event| {
        let Event::Key { key, pressed, repeat, modifiers, .. } = event else { return false };
        *key == Key::P && *pressed && !*repeat && !modifiers.any()
    };
    let free = ui.memory(|memory| memory.focused().is_none());
    if free && ui.input(|input| input.events.iter().any(is_p)) {
        actions.push(Action::Session(Command::SetPlots(!app.model.session().plots())));
    }
    if escape_ends_tour(app, ui) && ui.input(|input| input.key_pressed(Key::Escape)) {
        actions.push(Action::Explore(ExploreAction::LeaveTour { keeps: false }));
    }
}

/// Whether Escape ends the tour, and neither closes a window or a menu nor leaves a field, a dot or a picture.
fn escape_ends_tour(app: &RiemapApp, ui: &Ui) -> bool {
    let handles = &app.input.handles;
    let has_handle = handles.focused.is_some() || handles.is_probe_focused;
    let has_focus = has_handle || handles.focused_view.is_some() || ui.ctx().text_edit_focused();
    let is_covered = app.windows.are_open() || egui::Popup::is_any_open(ui.ctx());
    app.windows.explore.is_touring() && app.editor.is_at_rest() && !has_focus && !is_covered
}

fn bar_frame(palette: &Palette, narrow: bool) -> Frame {
    Frame::new().fill(palette.panel).inner_margin(Margin::symmetric(if narrow { 8 } else { 14 }, 0))
}

fn bars(app: &RiemapApp, ui: &mut Ui, narrow: bool, actions: &mut Actions) {
    let palette = Palette::of(ui.visuals());
    Panel::top("top").exact_size(46.0).resizable(false).frame(bar_frame(&palette, narrow)).show(ui, |ui| {
        let bar = TopBar {
            model: &app.model,
            persistence: &app.persistence,
            can_step: app.can_step(),
            preferences: app.screen.preferences,
            narrow,
            has_shapes: narrow || !header::has_room(ui, app.pictures.views.source.rect.width()),
        };
        bar.show(ui, actions);
    });
    let (backend, adapter) = app.pictures.gpu.as_ref().map(|gpu| (gpu.backend(), gpu.adapter())).unwrap_or_default();
    let extension = app.cauchy_green().map(|processor| words::cauchy_green(processor, app.model.extension_progress()));
    let backend = extension.into_iter().chain([backend]).collect::<Vec<_>>().join(" · ");
    Panel::bottom("status").exact_size(26.0).resizable(false).frame(bar_frame(&palette, narrow)).show(ui, |ui| {
        let pointed = app.pictures.pointed.as_ref().zip(app.input.handles.pointed.map(|at| at.decimals));
        status::show(ui, &app.model, &app.screen.meter, [&backend, &adapter], pointed, narrow);
    });
}

fn panel(app: &RiemapApp, ui: &mut Ui, actions: &mut Actions) {
    let palette = Palette::of(ui.visuals());
    let frame = Frame::new().fill(palette.panel).inner_margin(Margin { left: 14, right: 6, top: 4, bottom: 8 });
    Panel::left("controls").exact_size(PANEL_WIDTH).resizable(false).frame(frame).show(ui, |ui| {
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            ui.set_max_width(ui.available_width() - SCROLL_BAR);
            side_panel::show(ui, &app.model, &app.player, column(app, false), actions);
            follow_focus(ui);
        });
    });
}

fn column(app: &RiemapApp, in_sheet: bool) -> Column<'_> {
    let image_name = app.pictures.image.as_ref().map(|image| image.file.name.as_str());
    Column { image_name, advanced: app.screen.preferences.habits.advanced, uv: app.pictures.uv.is_shown, in_sheet }
}

/// Whether the plots leave the pictures their part of the screen in the tour, next to its card.
fn has_room_for_plots(ui: &Ui) -> bool {
    let free = ui.available_size() - vec2(tour::card::width_beside(ui).unwrap_or_default(), 0.0);
    if plots::width_beside(free).is_some() {
        return true;
    }
    let left = free.y - plots::dock_height(free.x, free.y);
    left >= tour::card::PICTURES * ui.ctx().content_rect().height()
}

/// The plots beside or below the viewports; they stay when the panels are hidden. Returns the place under the pointer.
fn dock(app: &RiemapApp, ui: &mut Ui, actions: &mut Actions) -> Option<BoundaryPlace> {
    let palette = Palette::of(ui.visuals());
    let frame = Frame::new().fill(palette.panel).inner_margin(Margin { left: 14, right: 14, top: 6, bottom: 4 });
    let (width, height) = (ui.available_width(), ui.available_height());
    if let Some(beside) = plots::width_beside(ui.available_size()) {
        let panel = Panel::right("plots-beside").exact_size(beside).resizable(false).frame(frame);
        return panel.show(ui, |ui| app.plots.show_column(ui, &app.model, height, actions)).inner;
    }
    let panel = Panel::bottom("plots").exact_size(plots::dock_height(width, height)).resizable(false).frame(frame);
    panel.show(ui, |ui| app.plots.show_dock(ui, &app.model, width, actions)).inner
}

/// The phone's sheet of controls or plots. Returns the place under the pointer in the plots.
fn sheet(app: &RiemapApp, ui: &mut Ui, actions: &mut Actions) -> Option<BoundaryPlace> {
    let palette = Palette::of(ui.visuals());
    let open = ui.ctx().animate_bool(Id::unique("sheet open"), app.screen.sheet_open);
    let screen = ui.ctx().content_rect();
    // what the bars above and below have left is the pictures' and the sheet's
    let sheet = ui.available_height() - PICTURES_SHARE * screen.height();
    let height = SHEET_HANDLE + open * (sheet - SHEET_HANDLE).max(0.0);
    let panel = Panel::bottom("sheet").exact_size(height).resizable(false).frame(bar_frame(&palette, false));
    let content = |ui: &mut Ui| {
        let plots = app.model.session().plots();
        if let Some(asked) = sheet_tabs(ui, app.screen.sheet_open, plots) {
            actions.push(Action::OpenSheet(!(app.screen.sheet_open && asked == plots)));
            actions.push(Action::Session(Command::SetPlots(asked)));
        }
        if open > 0.0 && plots {
            ui.take_available_width();
            return app.plots.show_one(ui, &app.model, actions);
        }
        if open > 0.0 {
            ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
                ui.set_max_width(ui.available_width() - SCROLL_BAR);
                side_panel::show(ui, &app.model, &app.player, column(app, true), actions);
                follow_focus(ui);
                ui.add_space(10.0);
            });
        }
        None
    };
    panel.show(ui, content).inner
}

/// The sheet's handle, in two halves; returns the half that was clicked: true for the plots, false for the controls.
fn sheet_tabs(ui: &mut Ui, open: bool, plots: bool) -> Option<bool> {
    let palette = Palette::of(ui.visuals());
    let mut asked = None;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 0.0;
        let size = vec2(0.5 * ui.available_width(), SHEET_HANDLE);
        for (label, is_plots) in [(key::controls(), false), (key::plots(), true)] {
            let shown = open && plots == is_plots;
            let ink = if open && !shown { palette.weak } else { palette.text };
            let response = ui.add_sized(size, egui::Button::new(RichText::new(tr(label)).color(ink)).frame(false));
            chevron(ui, response.rect, !shown);
            if response.has_focus() {
                let ring = Stroke::new(2.0, palette.accent_soft);
                ui.painter().rect_stroke(response.rect.shrink(3.0), 6.0, ring, egui::StrokeKind::Inside);
            }
            if response.clicked() {
                asked = Some(is_plots);
            }
        }
    });
    asked
}
