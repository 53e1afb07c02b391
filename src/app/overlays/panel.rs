//! The controls of polar grid and pattern side, of the comparison through the disk, and of the random walks.

use crate::app::input::action::{Action, Actions};
use crate::app::language::words;
use crate::app::language::words::grouped;
use crate::app::plots::Plots;
use crate::app::theme::Palette;
use crate::app::theme::explained::explained_heading;
use crate::app::theme::widgets::{Segment, captioned_slider, dash, segmented};
use crate::conformal::Side;
use crate::language::{Label as Words, Message, key, number, say, tr};
use crate::model::Model;
use crate::model::overlays::disk_comparison::{DiskComparison, Found};
use crate::model::overlays::overlay::Origin;
use crate::model::overlays::walks::{SPEEDS, WalkAction, Walks};
use crate::model::pattern::needs_grid;
use crate::session::{Command, Comparison, DiskWay, Session, TextureKind};
use egui::{Label, RichText, Ui};

const POLAR: [Segment<TextureKind>; 2] = [
    Segment { value: TextureKind::Conformal, label: key::conformal(), tooltip: key::conformal_tooltip() },
    Segment { value: TextureKind::Polar, label: key::euclidean(), tooltip: key::euclidean_tooltip() },
];

const HOMES: [Segment<Side>; 2] = [
    Segment { value: Side::Source, label: key::in_source(), tooltip: key::in_source_tooltip() },
    Segment { value: Side::Target, label: key::in_target(), tooltip: key::in_target_tooltip() },
];

const COMPARISONS: [Segment<Comparison>; 4] = [
    Segment { value: Comparison::Off, label: key::off(), tooltip: key::off_tooltip() },
    Segment { value: Comparison::Fresh, label: key::fresh(), tooltip: key::fresh_tooltip() },
    Segment { value: Comparison::Precomputed, label: key::precomputed(), tooltip: key::precomputed_tooltip() },
    Segment { value: Comparison::Both, label: key::both(), tooltip: key::both_tooltip() },
];

const THROUGH_DISK_TOOLTIP: Words = key::through_disk_tooltip();

const WALKS_TOOLTIP: Words = key::walks_tooltip();

/// The mean of Kolmogorov's distribution, √(π/2) ln 2: over √walks it is the deviation expected by chance alone.
const KOLMOGOROV_MEAN: f64 = 0.868_731;

/// The kind whose button represents `texture`: both polar grids share one button.
pub fn family(texture: TextureKind) -> TextureKind {
    match texture {
        TextureKind::Polar => TextureKind::Conformal,
        other => other,
    }
}

/// The pattern's scale, in words: the number of rays or of cells across.
pub fn scale(session: &Session) -> String {
    match session.texture() {
        TextureKind::Conformal => say(&key::rays(4.0 * (0.75 * session.texture_scale()).round())),
        _ => say(&key::cells_across(session.texture_scale().round())),
    }
}

/// The controls of the kind of polar grid and of the side on which the pattern is undistorted.
pub fn pattern(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    let session = model.session();
    if family(session.texture()) == TextureKind::Conformal
        && let Some(kind) = segmented(ui, &POLAR, session.texture())
    {
        actions.push(Action::Session(Command::SetTexture(kind)));
    }
    if needs_grid(session) {
        problem(ui, model.shown_grid().error());
    } else if model.chooses_pattern_home()
        && let Some(home) = segmented(ui, &HOMES, session.texture_side())
    {
        actions.push(Action::Session(Command::SetTextureSide(home)));
    }
}

/// The groups "Through the disk" and "Random walks", where they are defined.
pub fn show(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    if let Some(disk) = model.disk_comparison() {
        comparisons(ui, model.session().comparison(), disk, actions);
    }
    if let Some(steps) = model.walks() {
        explained_heading(ui, tr(key::random_walks_heading()), key::explain_walks());
        walks(ui, steps, actions);
    }
}

fn comparisons(ui: &mut Ui, comparison: Comparison, disk: &DiskComparison, actions: &mut Actions) {
    explained_heading(ui, tr(key::through_disk()), key::explain_through_disk());
    if let Some(chosen) = segmented(ui, &COMPARISONS, comparison) {
        actions.push(Action::Session(Command::SetComparison(chosen)));
    }
    for way in DiskWay::ALL {
        if comparison.shows(way) {
            verdict(ui, way, disk);
        }
    }
}

/// The errors that the controls show.
pub fn errors(model: &Model) -> impl Iterator<Item = &Message> {
    let session = model.session();
    let grid = model.shown_grid().error().filter(|_| needs_grid(session));
    let ways = DiskWay::ALL.into_iter().filter(|way| session.comparison().shows(*way));
    let disk = ways.filter_map(|way| model.disk_comparison()?.error(way));
    grid.into_iter().chain(disk).chain(model.walks().and_then(Walks::error))
}

fn problem(ui: &mut Ui, error: Option<&Message>) {
    if let Some(error) = error {
        let ink = Palette::of(ui.visuals()).error_edge;
        ui.add(Label::new(RichText::new(say(error)).small().color(ink)).wrap());
    }
}

/// The color and name of a way through the disk, and the result or the error of its comparison.
fn verdict(ui: &mut Ui, way: DiskWay, disk: &DiskComparison) {
    let palette = Palette::of(ui.visuals());
    let lines = disk.found(way).map(verdicts);
    if lines.is_some() || disk.error(way).is_some() {
        ui.horizontal(|ui| {
            ui.spacing_mut().interact_size.y = 16.0;
            dash(ui, Plots::overlay_ink(Origin::Disk(way), ui.visuals().dark_mode));
            ui.label(RichText::new(tr(Origin::Disk(way).name())).small().color(palette.text));
        });
    }
    for line in lines.into_iter().flatten() {
        ui.add(Label::new(RichText::new(line).small().color(palette.weak)).wrap())
            .on_hover_text(tr(THROUGH_DISK_TOOLTIP));
    }
    problem(ui, disk.error(way));
}

/// The result of a comparison in words, one statement per line.
pub fn verdicts(found: &Found) -> Vec<String> {
    let lost = |side: &Side| {
        let collapsed = || {
            let words = say(&key::points_collapsed(grouped(found.collapsed[*side]), grouped(found.samples[*side])));
            match found.directly_collapsed[*side] {
                0 => format!("{words} {}", tr(key::this_map_had_none())),
                direct => format!("{words} {}", say(&key::this_map_had(grouped(direct)))),
            }
        };
        let disordered = || say(&key::out_order(grouped(found.disordered[*side])));
        let name = words::side_within(*side);
        match (found.collapsed[*side], found.disordered[*side]) {
            (0, 0) => None,
            (_, 0) => Some(format!("{name}: {}", collapsed())),
            (0, _) => Some(format!("{name}: {}", disordered())),
            _ => Some(format!("{name}: {}, {}", collapsed(), disordered())),
        }
    };
    let mut lines: Vec<String> = Side::BOTH.iter().filter_map(lost).collect();
    if lines.is_empty() {
        lines.push(say(&key::all_points_kept_apart(grouped(found.samples.source + found.samples.target))));
    }
    lines.push(say(&key::largest_difference(percent(found.difference))));
    lines
}

/// A fraction in percent: two decimals below 1 %, one below 10 %, else none; "under 0.01 %" below that.
pub fn percent(part: f64) -> String {
    match 100.0 * part {
        p if p < 0.01 => String::from(tr(key::under_a_hundredth_percent())),
        p if p < 1.0 => format!("{}\u{a0}%", number(p, 2)),
        p if p < 10.0 => format!("{}\u{a0}%", number(p, 1)),
        p => format!("{}\u{a0}%", number(p, 0)),
    }
}

fn walks(ui: &mut Ui, walks: &Walks, actions: &mut Actions) {
    let palette = Palette::of(ui.visuals());
    ui.horizontal(|ui| {
        let label = if walks.is_running() { key::pause() } else { key::start() };
        if ui.button(tr(label)).on_hover_text(tr(WALKS_TOOLTIP)).clicked() {
            actions.push(Action::Walks(WalkAction::Toggle));
        }
        let clear = ui.add_enabled(walks.count() > 0, egui::Button::new(tr(key::clear())));
        if clear.on_hover_text(tr(key::clear_tooltip())).clicked() {
            actions.push(Action::Walks(WalkAction::Clear));
        }
        let count = walks.count() as usize;
        let counted = say(&key::walks(count, grouped(count)));
        ui.label(RichText::new(counted).color(palette.weak));
    });
    let shown = say(&key::per_second(grouped(walks.speed().round() as usize)));
    if let Some(speed) = captioned_slider(ui, tr(key::speed()), &shown, walks.speed(), SPEEDS, true) {
        actions.push(Action::Walks(WalkAction::Speed(speed.round())));
    }
    if let Some(deviation) = walks.deviation() {
        let chance = percent(KOLMOGOROV_MEAN / (walks.count() as f64).sqrt());
        let line = say(&key::largest_deviation(percent(deviation), chance));
        ui.add(Label::new(RichText::new(line).small().color(palette.weak)).wrap()).on_hover_text(tr(WALKS_TOOLTIP));
    }
    problem(ui, walks.error());
}
