//! The controls of what teaches: which polar grid, where the pattern lives, the way through the disk, random walks.

use super::super::action::{Action, Actions};
use super::super::model::Model;
use super::super::plots::Plots;
use super::super::theme::Palette;
use super::super::widgets::{Segment, captioned_slider, dash, group_heading, grouped, segmented};
use super::super::words;
use super::overlay::Origin;
use super::through_disk::{Found, ThroughDisk};
use super::walks::{SPEEDS, WalkAction, Walks};
use crate::app::language::{tr, tr_count, tr_message, tr_with};
use crate::conformal::Side;
use crate::session::{Command, Comparison, DiskWay, Session, TextureKind};
use egui::{Label, RichText, Ui};

const POLAR: [Segment<TextureKind>; 2] = [
    Segment {
        value: TextureKind::Conformal,
        label: "Conformal",
        tooltip: "The polar grid of the disk, on both sides: the circles are level sets of Green's function about x, the \
            rays leave equal harmonic measure between them, the first one ends at y. To a conformal map all cells are squares",
    },
    Segment {
        value: TextureKind::Polar,
        label: "Euclidean",
        tooltip: "True circles and rays about the interior point of the side where the pattern lives",
    },
];

const HOMES: [Segment<Side>; 2] = [
    Segment {
        value: Side::Source,
        label: "In the source",
        tooltip: "The pattern is drawn on the source and pushed forward to the target; goes best with Backward, which \
            fills the whole target",
    },
    Segment {
        value: Side::Target,
        label: "In the target",
        tooltip: "The pattern is drawn on the target and pulled back to the source; goes best with Forward, which fills \
            the whole source",
    },
];

const COMPARISONS: [Segment<Comparison>; 4] = [
    Segment { value: Comparison::Off, label: "Off", tooltip: "This map alone" },
    Segment {
        value: Comparison::Fresh,
        label: "Fresh",
        tooltip: "Both domains are mapped to the disk anew for every place of x₁ and x₂, by the geodesic algorithm: right, \
            but too slow to drag, so few boundary points are used until the dots rest",
    },
    Segment {
        value: Comparison::Precomputed,
        label: "Precomputed",
        tooltip: "Each domain is mapped to the disk once, for its middle; moving x is then only a Möbius map. Fast, but in \
            long arms the disk has no digits left: points fall together or change places, and no Möbius map gets them apart",
    },
    Segment {
        value: Comparison::Both,
        label: "Both",
        tooltip: "Fresh and precomputed disk maps side by side: what is lost with the second and not with the first is \
            lost to crowding",
    },
];

const THROUGH_DISK_TOOLTIP: &str = "Why not map both outlines to a disk and go through it? On the outline that is mapped to, \
    ticks inwards are this map's images of 60 points at equal steps of harmonic measure, ticks outwards those through the \
    disk: where both agree, each pair makes one line. The faint dots are the images of all boundary points. A point is \
    collapsed if no digits are left between it and the one before, and out of order if it comes out before that one";

const WALKS_TOOLTIP: &str = "Kakutani (1944): the harmonic measure of a part of the boundary is the chance that a random walk \
    from x₁ leaves through it. Each jump goes to a random point of the largest circle that fits. Bars: the share of the hits \
    in each piece of the boundary; strokes across: its harmonic measure";

/// The deviation to expect by chance alone is this over √walks: the mean of Kolmogorov's distribution, √(π/2) ln 2.
const KOLMOGOROV_MEAN: f64 = 0.868_731;

/// The texture's button for a kind: both polar grids have one.
pub fn family(texture: TextureKind) -> TextureKind {
    match texture {
        TextureKind::Polar => TextureKind::Conformal,
        other => other,
    }
}

/// The pattern's scale, in words.
pub fn scale(session: &Session) -> String {
    match session.texture {
        TextureKind::Conformal => tr_with("{0} rays", &[&(4.0 * (0.75 * session.texture_scale).round())]),
        _ => tr_with("{0} cells across", &[&session.texture_scale.round()]),
    }
}

/// Which polar grid, and where the pattern lives.
pub fn pattern(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    let session = model.session();
    if family(session.texture) == TextureKind::Conformal
        && let Some(kind) = segmented(ui, &POLAR, session.texture)
    {
        actions.push(Action::Session(Command::SetTexture(kind)));
    }
    if session.texture == TextureKind::Conformal {
        // It lives in the disk.
        problem(ui, model.shown_grid().error());
    } else if model.surface().is_none()
        && let Some(home) = segmented(ui, &HOMES, session.texture_side)
    {
        actions.push(Action::Session(Command::SetTextureSide(home)));
    }
}

/// The groups "Through the disk" and "Random walks".
pub fn show(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    if model.surface().is_some() {
        return; // both are of plane outlines
    }
    group_heading(ui, tr("Through the disk"));
    let comparison = model.session().comparison;
    if let Some(chosen) = segmented(ui, &COMPARISONS, comparison) {
        actions.push(Action::Session(Command::SetComparison(chosen)));
    }
    for way in DiskWay::ALL {
        if comparison.shows(way) {
            verdict(ui, way, &model.teaching().through_disk);
        }
    }
    group_heading(ui, tr("Random walks"));
    walks(ui, &model.teaching().walks, actions);
}

/// What the groups say is wrong.
pub fn errors(model: &Model) -> impl Iterator<Item = &str> {
    let session = model.session();
    let grid = model.shown_grid().error().filter(|_| session.texture == TextureKind::Conformal);
    let disk = DiskWay::ALL.into_iter().filter(|way| session.comparison.shows(*way));
    let of_plane =
        disk.filter_map(|way| model.teaching().through_disk.error(way)).chain(model.teaching().walks.error());
    grid.into_iter().chain(of_plane.filter(|_| model.surface().is_none()))
}

fn problem(ui: &mut Ui, error: Option<&str>) {
    if let Some(error) = error {
        let ink = Palette::of(ui.visuals()).error_edge;
        ui.add(Label::new(RichText::new(tr_message(error)).small().color(ink)).wrap());
    }
}

/// The way's colour and name, and what was found or went wrong.
fn verdict(ui: &mut Ui, way: DiskWay, disk: &ThroughDisk) {
    let palette = Palette::of(ui.visuals());
    let lines = disk.found(way).map(verdicts);
    if lines.is_some() || disk.error(way).is_some() {
        ui.horizontal(|ui| {
            ui.spacing_mut().interact_size.y = 16.0;
            dash(ui, Plots::overlay_ink(Origin::Disk(way), ui.visuals().dark_mode));
            ui.label(RichText::new(Origin::Disk(way).name()).small().color(palette.text));
        });
    }
    for line in lines.into_iter().flatten() {
        ui.add(Label::new(RichText::new(line).small().color(palette.weak)).wrap())
            .on_hover_text(tr(THROUGH_DISK_TOOLTIP));
    }
    problem(ui, disk.error(way));
}

/// What the comparison says, a line each.
pub fn verdicts(found: &Found) -> Vec<String> {
    let lost = |side: &Side| {
        let k = *side as usize;
        let collapsed = || {
            let words =
                tr_with("{0} of {1} points collapsed", &[&grouped(found.collapsed[k]), &grouped(found.samples[k])]);
            match found.directly_collapsed[k] {
                0 => format!("{words} {}", tr("(this map: none)")),
                direct => format!("{words} {}", tr_with("(this map: {0})", &[&grouped(direct)])),
            }
        };
        let disordered = || tr_with("{0} out of order", &[&grouped(found.disordered[k])]);
        let side = words::side_within(*side);
        match (found.collapsed[k], found.disordered[k]) {
            (0, 0) => None,
            (_, 0) => Some(format!("{side}: {}", collapsed())),
            (0, _) => Some(format!("{side}: {}", disordered())),
            _ => Some(format!("{side}: {}, {}", collapsed(), disordered())),
        }
    };
    let mut lines: Vec<String> = Side::BOTH.iter().filter_map(lost).collect();
    if lines.is_empty() {
        lines.push(tr_with("all {0} points kept apart", &[&grouped(found.samples.iter().sum())]));
    }
    lines.push(tr_with("largest difference {0} of the length", &[&percent(found.difference)]));
    lines
}

/// A part of a whole, with as many digits as are worth reading.
pub fn percent(part: f64) -> String {
    match 100.0 * part {
        p if p < 0.01 => String::from(tr("under 0.01 %")),
        p if p < 1.0 => format!("{p:.2} %"),
        p if p < 10.0 => format!("{p:.1} %"),
        p => format!("{p:.0} %"),
    }
}

fn walks(ui: &mut Ui, walks: &Walks, actions: &mut Actions) {
    let palette = Palette::of(ui.visuals());
    ui.horizontal(|ui| {
        let label = if walks.is_running() { "Pause" } else { "Start" };
        if ui.button(tr(label)).on_hover_text(tr(WALKS_TOOLTIP)).clicked() {
            actions.push(Action::Walks(WalkAction::Toggle));
        }
        let clear = ui.add_enabled(walks.count() > 0, egui::Button::new(tr("Clear")));
        if clear.on_hover_text(tr("Forget all hits")).clicked() {
            actions.push(Action::Walks(WalkAction::Clear));
        }
        let count = walks.count() as usize;
        let counted = tr_count(count, ["{0} walk", "{0} walks"], &[&grouped(count)]);
        ui.label(RichText::new(counted).color(palette.weak));
    });
    let shown = tr_with("{0} per second", &[&grouped(walks.speed().round() as usize)]);
    if let Some(speed) = captioned_slider(ui, tr("Speed"), &shown, walks.speed(), SPEEDS, true) {
        actions.push(Action::Walks(WalkAction::Speed(speed.round())));
    }
    if let Some(deviation) = walks.deviation() {
        let chance = percent(KOLMOGOROV_MEAN / (walks.count() as f64).sqrt());
        let line = tr_with("largest deviation from ω: {0} (chance: about {1})", &[&percent(deviation), &chance]);
        ui.add(Label::new(RichText::new(line).small().color(palette.weak)).wrap()).on_hover_text(tr(WALKS_TOOLTIP));
    }
    problem(ui, walks.error());
}
