//! The legend of signs at the lower edge of a picture: its dots, the marks, the painted region, and the ticks of overlays.

use crate::app::input::handles::{Handle, HandleKind};
use crate::app::overlays;
use crate::app::panels::header::over_the_mesh;
use crate::app::theme::explained::explain;
use crate::app::theme::text_metrics::text_width;
use crate::app::theme::{BOUNDARY_COLOUR, INTERIOR_COLOUR, Palette, widgets};
use crate::app::viewport::view::View;
use crate::app::viewport::{best, dots};
use crate::conformal::Side;
use crate::language::{Label as Words, key, tr};
use crate::model::Model;
use egui::{Align, Color32, Label, Layout, Rect, RichText, Sense, Ui, UiBuilder, vec2};

/// The height of one row of the legend above a picture's lower edge.
pub const LEGEND_HEIGHT: f32 = 32.0;

/// Shows the legend of the dots and, where they do not fit beside these, that of marks, region and overlays' ticks in rows
/// above; `beside` is the width at the right that other content takes.
pub fn show(ui: &mut Ui, side: Side, model: &Model, view: &View, beside: f32) {
    let low = view.rect.bottom();
    let place = view.rect.with_min_y(low - LEGEND_HEIGHT + 2.0).with_max_y(low - 8.0).shrink2(vec2(14.0, 0.0));
    let dots = dot_entries(ui, side, model, place.width());
    let others = other_entries(ui, side, model);
    let all: f32 = dots.iter().chain(&others).map(|entry| entry_width(ui, entry.text)).sum();
    let (first, above) = if all <= place.width() - beside { (others, Vec::new()) } else { (Vec::new(), others) };
    row(ui, place, |ui| entries(ui, dots.iter().chain(&first)));
    let mut place = place;
    for line in lines(ui, &above, place.width()).into_iter().rev() {
        place = place.translate(vec2(0.0, -place.height()));
        row(ui, place, |ui| entries(ui, line));
    }
}

/// Divides entries into rows that fit into `room`; one that does not fit has a row of its own.
fn lines<'a>(ui: &Ui, mut entries: &'a [Entry], room: f32) -> Vec<&'a [Entry]> {
    let mut rows = Vec::new();
    while !entries.is_empty() {
        let mut width = 0.0;
        let fits = |entry: &&Entry| {
            width += entry_width(ui, entry.text);
            width <= room
        };
        let (row, rest) = entries.split_at(entries.iter().take_while(fits).count().max(1));
        rows.push(row);
        entries = rest;
    }
    rows
}

/// One row of the legend.
fn row(ui: &mut Ui, place: Rect, content: impl FnOnce(&mut Ui)) {
    ui.scope_builder(UiBuilder::new().max_rect(place).layout(Layout::left_to_right(Align::Center)), |ui| {
        over_the_mesh(ui, content);
    });
}

/// The entries of the dots; where their words do not fit into `room`, their symbols alone.
fn dot_entries(ui: &Ui, side: Side, model: &Model, room: f32) -> Vec<Entry> {
    let dot = |ink, text, kind| {
        let explanation = Some(dots::explanation(Handle { side, kind }));
        Entry { ink, text, explanation, sign: widgets::dot }
    };
    if model.pins().is_some() {
        return vec![dot(BOUNDARY_COLOUR, tr(key::pins_in_legend()), HandleKind::Pin(0))];
    }
    let (words, symbols) = match side {
        Side::Source => ([key::interior_point_x1(), key::boundary_point_y1()], ["x₁", "y₁"]),
        Side::Target => ([key::x2_f_x1(), key::y2_f_y1()], ["x₂", "y₂"]),
    };
    let words = words.map(tr);
    let fit = words.iter().map(|text| entry_width(ui, text)).sum::<f32>() <= room;
    let [interior, boundary] = if fit { words } else { symbols };
    vec![dot(INTERIOR_COLOUR, interior, HandleKind::Interior), dot(BOUNDARY_COLOUR, boundary, HandleKind::Boundary)]
}

/// The entries of the marks, of the painted region and of the overlays' ticks.
fn other_entries(ui: &Ui, side: Side, model: &Model) -> Vec<Entry> {
    let marks = model.marks(side).is_some().then(|| Entry {
        ink: Palette::of(ui.visuals()).text,
        text: tr(key::four_marks()),
        explanation: Some(dots::explanation(Handle { side, kind: HandleKind::Mark(0) })),
        sign: widgets::square,
    });
    let is_painted = side == Side::Source && best::shows_region(model);
    let region = is_painted.then(|| Entry {
        ink: best::region_ink(ui).to_opaque(),
        text: tr(key::aim_region()),
        explanation: Some(key::region_in_legend()),
        sign: widgets::patch,
    });
    let dashes = overlays::paint::legend(side, model, ui.visuals().dark_mode).into_iter();
    let dashes = dashes.map(|(ink, text)| Entry { ink, text, explanation: None, sign: widgets::dash });
    marks.into_iter().chain(region).chain(dashes).collect()
}

/// Free space after an entry, in addition to the usual spacing.
const ENTRY_GAP: f32 = 2.0;

/// The width of an entry in a row, with the space around it.
fn entry_width(ui: &Ui, text: &str) -> f32 {
    widgets::SIGN_WIDTH
        + text_width(ui, text, widgets::caption_font(ui))
        + ENTRY_GAP
        + 2.0 * ui.spacing().item_spacing.x
}

/// An entry: its sign with this color, its words, and what explains them.
struct Entry {
    ink: Color32,
    text: &'static str,
    explanation: Option<Words>,
    sign: fn(&mut Ui, Color32),
}

fn entries<'a>(ui: &mut Ui, entries: impl IntoIterator<Item = &'a Entry>) {
    let weak = Palette::of(ui.visuals()).weak;
    for Entry { ink, text, explanation, sign } in entries {
        sign(ui, *ink);
        let label = Label::new(RichText::new(*text).small().color(weak));
        match explanation {
            Some(words) => explain(&ui.add(label.sense(Sense::click())), tr(*words)),
            None => drop(ui.add(label)),
        }
        ui.add_space(ENTRY_GAP);
    }
}
