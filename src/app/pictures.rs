//! The two pictures of a frame: gestures over them, and painting after the map is updated.
//!
//! Painting changes nothing. Cameras are placed and moved by gestures in place, not by actions: a gesture moves a
//! camera by what the camera shows at that moment, and neither undo nor links keep it.

use super::arrangement::{Arrangement, legend_side};
use super::theme::Palette;
use super::{RiemapApp, editing};
use crate::app::input::action::Actions;
use crate::app::panels::header::Surroundings;
use crate::app::panels::{best_panel, header, sign_legend};
use crate::app::viewport::{best, legend, planar, probe};
use crate::app::{message_bar, overlays};
use crate::conformal::Side;
use crate::language::{significant, tr};
use crate::model::best::Landscapes;
use crate::render::{Pace, TextureStyle};
use egui::{Stroke, Ui, UiBuilder};

/// The height from which a tight picture has a row for the legend of the dots, in points.
const LEGEND_FROM: f32 = 180.0;

/// Places the pictures in the area that the panels leave, and turns gestures over them into actions.
pub fn interact(app: &mut RiemapApp, ui: &mut Ui, arrangement: Arrangement, actions: &mut Actions) {
    let area = UiBuilder::new().id_salt("gestures").max_rect(ui.available_rect_before_wrap());
    let ui = &mut ui.new_child(area);
    place(app, ui, arrangement);
    let mut pointed = None;
    for side in Side::BOTH {
        let handles = &mut app.input.handles;
        let boundary = if app.editor.side() == Some(side) {
            let view = &mut app.pictures.views[side];
            editing::interact(ui, side, &app.model, view, &mut app.editor, handles, actions);
            None
        } else {
            app.pictures.of_mut(&app.model, side).interact(ui, side, &app.model, handles, actions)
        };
        pointed = pointed.or(boundary.map(|fraction| (side, fraction)));
    }
    if app.plots.point_at(pointed) {
        // the plots were laid out before this
        ui.request_repaint();
    }
}

/// Paints both pictures, their buttons and messages; returns the actions of the buttons.
pub fn show(app: &RiemapApp, ui: &mut Ui, arrangement: Arrangement) -> Actions {
    let mut actions = Actions::new();
    paint(app, ui, arrangement, &mut actions);
    message_bar::notice(app, ui);
    actions
}

/// Sets the areas of both views.
pub fn place(app: &mut RiemapApp, ui: &Ui, arrangement: Arrangement) {
    let rects = arrangement.divide(ui.max_rect());
    for side in Side::BOTH {
        let rect = rects[side];
        let margins = arrangement.margins(app, ui, side, rect);
        app.pictures.place(&app.model, side, rect, ui.pixels_per_point(), margins);
    }
}

fn paint(app: &RiemapApp, ui: &mut Ui, arrangement: Arrangement, actions: &mut Actions) {
    let dark = ui.visuals().dark_mode;
    if let Some(gpu) = &app.pictures.gpu {
        gpu.set_stroke(dark, ui.pixels_per_point());
    }
    let style = app.texture_style(dark).filter(|_| app.pictures.gpu.is_some());
    for side in Side::BOTH {
        paint_map(app, ui, side, style.as_ref());
        let title = paint_words(app, ui, side, arrangement, actions);
        paint_handles(app, ui, side);
        show_tools(app, ui, side, arrangement, title, actions);
    }
    let a = app.pictures.views.source.rect;
    let edge =
        if arrangement.stacked { [a.left_bottom(), a.right_bottom()] } else { [a.right_top(), a.right_bottom()] };
    ui.painter().line_segment(edge, Stroke::new(1.0, Palette::of(ui.visuals()).border));
}

fn paint_map(app: &RiemapApp, ui: &Ui, side: Side, style: Option<&TextureStyle>) {
    let view = &app.pictures.views[side];
    let now = ui.input(|input| input.time);
    let pace = app.pictures.gpu.as_ref().map_or(Pace::Full, |gpu| gpu.pace(now));
    let picture = app.pictures.of(&app.model, side);
    picture.paint(ui, (&app.model, side), style, app.pictures.cells.style(), pace);
    picture.paint_loops(ui, side, &app.model);
    picture.paint_best(ui, side, &app.model);
    editing::paint_sheet(ui, side, view, &app.editor);
}

/// Title, buttons and legends; returns how far down the title reaches.
fn paint_words(app: &RiemapApp, ui: &mut Ui, side: Side, arrangement: Arrangement, actions: &mut Actions) -> f32 {
    let view = &app.pictures.views[side];
    let tight = arrangement.is_tight(view.rect);
    let around = Surroundings {
        has_room: !arrangement.narrow && header::has_room(ui, app.pictures.views.source.rect.width()),
        edited: app.editor.reshaped_side(),
        folded: !app.screen.panels_open,
        embedded: app.options.embed,
    };
    let is_fitted = app.pictures.of(&app.model, side).is_fitted();
    let title = header::show(ui, side, &app.model, view.rect, is_fitted, around, actions);
    let scale = app.pictures.cells.scale().filter(|_| side == legend_side(&app.model));
    let relief = (side == Side::Source).then(|| app.model.best().landscape()).flatten();
    let has_legend = scale.is_some() || relief.is_some();
    let has_row = !tight || (view.rect.height() >= LEGEND_FROM && !has_legend);
    if has_row {
        let beside = if has_legend { legend::width(view.rect, tight) } else { 0.0 };
        sign_legend::show(ui, side, &app.model, view, beside);
    }
    app.pictures.uv.paint(ui, side, &app.model, view);
    overlays::quadrilateral::paint(ui, side, &app.model, view);
    overlays::paint::show(ui, side, &app.model, view);
    if let Some(scale) = scale {
        legend::paint(ui, view.rect, scale, tight);
    } else if let Some(marks) = relief.and_then(Landscapes::marks) {
        let title = tr(best_panel::criterion(app.model.best().aim()));
        let values = [marks.least, marks.middle, marks.worst].map(|value| significant(value, 3));
        legend::paint_ranks(ui, view.rect, title, best::LANDSCAPE_COLORS, &values, tight);
    }
    title
}

/// The dots, the mark of the plots' pointer, and the outline being edited.
fn paint_handles(app: &RiemapApp, ui: &Ui, side: Side) {
    let (view, picture) = (&app.pictures.views[side], app.pictures.of(&app.model, side));
    let marked = app.plots.marked().map(|marked| marked[side]);
    if app.editor.drawing(side).is_some() {
        // the dots are those of the outline under the sheet
    } else {
        if let Some(pointed) = app.pictures.pointed.filter(|pointed| pointed.side == side.other()) {
            planar::paint_image_mark(ui, view, pointed.image);
        }
        match side {
            Side::Source => {
                let handles = &app.input.handles;
                handles.probe.iter().for_each(|&at| probe::paint(ui, view, at, handles.is_probe_focused));
            }
            Side::Target => {
                let dots: Vec<_> = planar::places(side, &app.model, view).into_iter().map(|(_, place)| place).collect();
                app.pictures.probe.iter().for_each(|image| probe::paint_image(ui, view, image, &dots));
            }
        }
        marked.inspect(|&at| picture.paint_boundary_mark(ui, side, &app.model, at));
        picture.paint_dots(ui, side, &app.model, &app.input.handles);
    }
    editing::paint(ui, side, view, &app.editor);
    if side == Side::Source
        && !app.input.handles.ever_dragged
        && !app.windows.explore.is_touring()
        && app.model.shown().is_some()
        && app.editor.side().is_none()
    {
        planar::paint_hint(ui, view.rect, &picture.places(&app.model, side));
    }
}

/// The widgets over a picture: messages below its `title`, the edit bar, frames and progress.
fn show_tools(app: &RiemapApp, ui: &mut Ui, side: Side, arrangement: Arrangement, title: f32, actions: &mut Actions) {
    let view = &app.pictures.views[side];
    header::messages(ui, side, &app.model, arrangement.message_area(app, ui, side, title), actions);
    editing::show_bar(ui, side, view, arrangement.edit_area(app, side, view.rect), &app.editor, actions);
    planar::paint_focus(ui, side, view.rect, &app.input.handles);
    planar::paint_progress(ui, side, &app.model, view.rect);
    planar::paint_drop_target(ui, view.rect);
}
