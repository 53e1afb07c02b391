//! How the screen is divided: on a desk bars, panel and two viewports side by
//! side with the plots below; on a phone the viewports one above the other and a
//! sheet of controls or plots.

use super::action::{Action, Actions};
use super::arrangement::{LEGEND_SIDE, divide, legend_height, margins};
use super::header::Surroundings;
use super::language::tr;
use super::theme::Palette;
use super::widgets::{chevron, message_box, notice_box};
use super::{
    PHONE_WIDTH, RiemapApp, editing, file_menu, header, legend, offer, play_panel, plots, presentation, side_panel,
    status, surface, teaching, theme, top_bar, viewport, words,
};
use crate::conformal::Side;
use crate::render::Pace;
use crate::session::Command;
use egui::{Event, Frame, Id, Key, Margin, Panel, Rect, RichText, ScrollArea, Stroke, Ui, UiBuilder, pos2, vec2};

/// The width of the side panel.
const PANEL_WIDTH: f32 = 268.0;
/// Room for the scroll bar beside the controls.
const SCROLL_BAR: f32 = 8.0;
/// The height of the sheet's handle, enough for a thumb.
const SHEET_HANDLE: f32 = 44.0;
/// How much of the screen the open sheet takes besides.
const SHEET_SHARE: f32 = 0.42;

/// One frame: panels, then what they ask for, then what has come from outside, then the pictures.
pub fn show(app: &mut RiemapApp, ui: &mut Ui) {
    let narrow = ui.available_width() < PHONE_WIDTH;
    theme::suit_pointer(ui.ctx(), narrow || app.has_fingers || ui.input(egui::InputState::has_touch_screen));
    let mut actions = Actions::new();
    app.plots.begin_frame();
    keys(app, ui, &mut actions);
    file_menu::keys(ui, &mut actions);
    presentation::keys(ui, &mut actions);
    editing::keys(ui, &app.editor, &app.views, &mut actions);
    actions.extend(editing::pasted(ui).map(Action::PasteText));
    play_panel::keys(ui, &mut actions);
    if app.panels_open {
        bars(app, ui, narrow, &mut actions);
        if narrow {
            sheet(app, ui, &mut actions);
        } else {
            panel(app, ui, &mut actions);
        }
    }
    if !narrow && app.model.session().plots {
        dock(app, ui);
    }
    app.explore.show_tour(ui, &mut actions);
    let context = ui.ctx().clone();
    // the panels' wishes are about what they have shown
    app.carry_out(&context, actions);
    app.take_events(&context);
    egui::CentralPanel::no_frame().show(ui, |ui| pictures(app, ui, narrow));
}

/// P opens the plots or closes them, unless a control has the keyboard.
fn keys(app: &RiemapApp, ui: &Ui, actions: &mut Actions) {
    let is_p = |event: &Event| {
        let Event::Key { key, pressed, repeat, modifiers, .. } = event else { return false };
        *key == Key::P && *pressed && !*repeat && !modifiers.any()
    };
    let free = ui.memory(|memory| memory.focused().is_none());
    if free && ui.input(|input| input.events.iter().any(is_p)) {
        actions.push(Action::Session(Command::SetPlots(!app.model.session().plots)));
    }
}

fn bar_frame(palette: &Palette) -> Frame {
    Frame::new().fill(palette.panel).inner_margin(Margin::symmetric(14, 0))
}

fn bars(app: &RiemapApp, ui: &mut Ui, narrow: bool, actions: &mut Actions) {
    let palette = Palette::of(ui.visuals());
    Panel::top("top").exact_size(46.0).resizable(false).frame(bar_frame(&palette)).show(ui, |ui| {
        top_bar::show(ui, &app.model, &app.keeper, app.preferences, narrow, actions);
    });
    let (backend, adapter) = app.gpu.as_ref().map(|gpu| (gpu.backend(), gpu.adapter())).unwrap_or_default();
    let extension = app.cauchy_green().map(|processor| words::cauchy_green(processor, app.model.extension_progress()));
    let backend = extension.into_iter().chain([backend]).collect::<Vec<_>>().join(" · ");
    Panel::bottom("status").exact_size(26.0).resizable(false).frame(bar_frame(&palette)).show(ui, |ui| {
        status::show(ui, &app.model, &app.meter, &backend, &adapter, narrow);
    });
}

fn panel(app: &RiemapApp, ui: &mut Ui, actions: &mut Actions) {
    let palette = Palette::of(ui.visuals());
    let frame = Frame::new().fill(palette.panel).inner_margin(Margin { left: 14, right: 6, top: 4, bottom: 8 });
    Panel::left("controls").exact_size(PANEL_WIDTH).resizable(false).frame(frame).show(ui, |ui| {
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            ui.set_max_width(ui.available_width() - SCROLL_BAR);
            side_panel::show(ui, &app.model, &app.player, app.image_name.as_deref(), actions);
        });
    });
}

/// The plots below the viewports; they stay when the panels fold away.
fn dock(app: &mut RiemapApp, ui: &mut Ui) {
    let palette = Palette::of(ui.visuals());
    let frame = Frame::new().fill(palette.panel).inner_margin(Margin { left: 14, right: 14, top: 6, bottom: 4 });
    let (width, height) = (ui.available_width(), ui.available_height());
    Panel::bottom("plots").exact_size(plots::dock_height(width, height)).resizable(false).frame(frame).show(ui, |ui| {
        app.plots.show_dock(ui, &app.model, width);
    });
}

fn sheet(app: &mut RiemapApp, ui: &mut Ui, actions: &mut Actions) {
    let palette = Palette::of(ui.visuals());
    let open = ui.ctx().animate_bool(Id::unique("sheet open"), app.sheet_open);
    let height = SHEET_HANDLE + open * SHEET_SHARE * ui.ctx().content_rect().height();
    Panel::bottom("sheet").exact_size(height).resizable(false).frame(bar_frame(&palette)).show(ui, |ui| {
        let plots = app.model.session().plots;
        if let Some(asked) = sheet_tabs(ui, app.sheet_open, plots) {
            app.sheet_open = !(app.sheet_open && asked == plots);
            actions.push(Action::Session(Command::SetPlots(asked)));
        }
        if open > 0.0 && plots {
            ui.take_available_width();
            app.plots.show_one(ui, &app.model);
        } else if open > 0.0 {
            ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
                ui.set_max_width(ui.available_width() - SCROLL_BAR);
                side_panel::show(ui, &app.model, &app.player, app.image_name.as_deref(), actions);
                ui.add_space(10.0);
            });
        }
    });
}

/// The sheet's handle, in two halves; returns whether the plots were asked for, or the controls.
fn sheet_tabs(ui: &mut Ui, open: bool, plots: bool) -> Option<bool> {
    let palette = Palette::of(ui.visuals());
    let mut asked = None;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 0.0;
        let size = vec2(0.5 * ui.available_width(), SHEET_HANDLE);
        for (label, is_plots) in [("Controls", false), ("Plots", true)] {
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

/// Both viewports; here the map is updated.
fn pictures(app: &mut RiemapApp, ui: &mut Ui, narrow: bool) {
    let mut actions = Actions::new();
    let stacked = narrow || ui.max_rect().width() < ui.max_rect().height();
    let rects = divide(ui.max_rect(), stacked);
    let mut pointed = None;
    for side in Side::BOTH {
        let rect = rects[side as usize];
        let margins = margins(app, side, rect, narrow, stacked);
        let view = &mut app.views[side as usize];
        view.place(rect, ui.pixels_per_point(), margins, app.model.extent(side));
        let scene = app.model.surface().and_then(|(surface, _)| surface.scene()).filter(|_| side == Side::Target);
        if let Some(scene) = scene {
            app.orbit.place(view.rect, ui.pixels_per_point(), scene);
        }
        let boundary = if app.editor.side() == Some(side) {
            editing::interact(ui, side, &app.model, view, &mut app.editor, &mut app.handles, &mut actions);
            None
        } else if scene.is_some() {
            surface::viewport::interact(ui, &app.model, &mut app.orbit, &mut app.handles, &mut actions)
        } else {
            viewport::interact(ui, side, &app.model, view, &mut app.handles, &mut actions)
        };
        pointed = pointed.or(boundary.map(|fraction| (side, fraction)));
    }
    if app.plots.point_at(pointed) {
        // The plots were laid out before.
        ui.request_repaint();
    }
    let context = ui.ctx().clone();
    app.carry_out(&context, std::mem::take(&mut actions));
    app.advance(&context);
    paint(app, ui, narrow, &mut actions);
    common_message(app, ui, &mut actions);
    app.reports.show(&context);
    offer::show(ui, &mut app.offer, &mut actions);
    editing::show_paste(&context, &mut app.editor, &mut actions);
    app.explore.show(&context, &mut actions);
    app.show_exporter(&context, &mut actions);
    app.carry_out(&context, actions);
}

fn paint(app: &RiemapApp, ui: &mut Ui, narrow: bool, actions: &mut Actions) {
    let dark = ui.visuals().dark_mode;
    if let Some(gpu) = &app.gpu {
        gpu.set_stroke(dark, ui.pixels_per_point());
    }
    let embedded = app.options.embed;
    let has_room = !narrow && header::has_room(ui, app.views[0].rect.width());
    let around = Surroundings { has_room, edited: app.editor.reshaped_side(), folded: !app.panels_open, embedded };
    let style = app.texture_style(dark).filter(|_| app.gpu.is_some());
    let now = ui.input(|input| input.time);
    let pace = app.gpu.as_ref().map_or(Pace::Full, |gpu| gpu.pace(now));
    for side in Side::BOTH {
        let view = &app.views[side as usize];
        let solid = side == Side::Target && app.model.surface().is_some();
        if solid {
            // until its first map is there, the GPU may have another one
            let style = style.as_ref().filter(|_| app.model.surface_map().is_some());
            surface::viewport::paint_surface(ui, &app.orbit, style, app.cells.style(), pace);
        } else {
            viewport::paint_mesh(ui, side, view, style.as_ref(), pace);
        }
        editing::paint_sheet(ui, side, view, &app.editor);
        let is_fitted = if solid { app.orbit.is_fitted() } else { view.is_fitted() };
        header::show(ui, side, &app.model, view.rect, is_fitted, around, actions);
        let scale = app.cells.scale().filter(|_| side == LEGEND_SIDE);
        if !narrow {
            let beside = scale.map_or(0.0, |_| legend::width(view.rect, narrow));
            header::legend(ui, side, &app.model, view, beside);
        }
        teaching::paint::show(ui, side, &app.model, view);
        if let Some(scale) = scale {
            legend::paint(ui, view.rect, scale, narrow);
        }
        let marked = app.plots.marked().map(|marked| marked[side as usize]);
        if app.editor.drawing(side).is_some() {
            // the dots are those of the outline under the sheet
        } else if solid {
            marked.inspect(|&at| surface::viewport::paint_boundary_mark(ui, &app.model, &app.orbit, at));
            surface::viewport::paint_dots(ui, &app.model, &app.orbit, &app.handles);
        } else {
            marked.inspect(|&at| viewport::paint_boundary_mark(ui, side, &app.model, view, at));
            viewport::paint_dots(ui, side, &app.model, view, &app.handles);
        }
        editing::paint(ui, side, view, &app.editor);
        let words = if narrow { 0.0 } else { header::LEGEND_HEIGHT };
        let below = legend_height(app, side, view.rect, narrow).max(words);
        let room = view.rect.with_max_y(view.rect.bottom() - below);
        editing::show_bar(ui, side, view, room, &app.editor, actions);
        viewport::paint_focus(ui, side, view.rect, &app.handles);
        viewport::paint_progress(ui, side, &app.model, view.rect);
        viewport::paint_drop_target(ui, side, view.rect);
    }
    if !app.handles.ever_dragged && app.model.shown().is_some() && app.editor.side().is_none() {
        viewport::paint_hint(ui, &app.model, &app.views[0]);
    }
    let [a, b] = app.views.each_ref().map(|view| view.rect);
    let stacked = a.bottom() <= b.top();
    let edge = if stacked { [a.left_bottom(), a.right_bottom()] } else { [a.right_top(), a.right_bottom()] };
    ui.painter().line_segment(edge, Stroke::new(1.0, Palette::of(ui.visuals()).border));
}

/// The texture and exports belong to both sides: their message lies over the middle, or a notice.
fn common_message(app: &RiemapApp, ui: &mut Ui, actions: &mut Actions) {
    let Some(message) = &app.message else { return notice(app, ui) };
    let area = ui.max_rect();
    let width = (area.width() - 32.0).min(460.0);
    let place = Rect::from_min_size(pos2(area.center().x - 0.5 * width, area.bottom() - 110.0), vec2(width, 100.0));
    ui.scope_builder(UiBuilder::new().max_rect(place), |ui| {
        if message_box(ui, message, None).is_some() {
            actions.push(Action::DismissMessage);
        }
    });
}

fn notice(app: &RiemapApp, ui: &mut Ui) {
    let Some((text, until)) = app.notice else { return };
    let left = until - ui.input(|input| input.time);
    if left <= 0.0 {
        return;
    }
    ui.ctx().request_repaint_after_secs(left as f32);
    let area = ui.max_rect();
    let size = vec2(140.0, 34.0);
    let place = Rect::from_min_size(pos2(area.center().x - 0.5 * size.x, area.bottom() - 64.0), size);
    ui.scope_builder(UiBuilder::new().max_rect(place), |ui| notice_box(ui, text));
}
