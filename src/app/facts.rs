//! The app's state as data: the numbers on the screen, errors and notes, positions of the dots.

use super::{RiemapApp, accessibility, editing};
use crate::app::input::handles::HandleKind;
use crate::app::overlays;
use crate::app::status::stats::{HandlePositions, PlotStats, ScreenStats, Stats};
use crate::app::status::window_stats::{FormulaStats, ProjectionStats, ReportStats, ShareStats, WindowStats};
use crate::app::viewport::gpu::Gpu;
use crate::app::viewport::marks;
use crate::app::windows::Windows;
use crate::conformal::{Extension, PerSide, Side};
use crate::language::Message;
use crate::model::Processor;
use crate::worker::FoundProjection;

impl RiemapApp {
    /// The numbers on the screen.
    pub fn stats(&self) -> Stats {
        let screen = ScreenStats {
            backend: self.pictures.gpu.as_ref().map(Gpu::backend).unwrap_or_default(),
            dark: self.screen.theme == egui::Theme::Dark,
            errors: self.errors().iter().map(Message::english).collect(),
            notes: self.notes().iter().map(Message::english).collect(),
            spoken: self.announced.controls,
            undo: self.persistence.history().undo_count(),
            playing: self.player.is_playing(),
            cauchy_green: self.cauchy_green(),
            pointed: self.pictures.pointed,
            image: self.pictures.image.as_ref().map(|image| image.file.name.clone()),
            handles: self.handle_positions(),
            loops: Side::BOTH.map(|side| {
                let places = self.pictures.of(&self.model, side).places_of_loops(&self.model, side);
                places.into_iter().map(|place| self.css_pixels(place)).collect()
            }),
            editing: editing::stats(&self.editor, &self.pictures.views),
            plots: PlotStats {
                marked_boundary: self.plots.marked().map(PerSide::into_array),
                exact_difference: self.plots.exact().map(|exact| exact.difference),
            },
            windows: self.window_stats(),
        };
        Stats::new(&self.model, screen)
    }

    fn window_stats(&self) -> WindowStats {
        let Windows { explore, exporter, projection, reports, .. } = &self.windows;
        WindowStats {
            export: exporter.places().cloned(),
            export_count: exporter.count(),
            formula: FormulaStats {
                progress: exporter.formula_progress(),
                reached: exporter.formula_notes().iter().map(|(note, _)| note.english()).collect(),
            },
            projection: projection.is_open().then(|| ProjectionStats {
                progress: projection.progress(),
                ..projection.found().map(projected).unwrap_or_default()
            }),
            report: reports.is_open().then(|| ReportStats { measured: reports.measured(), left: reports.left() }),
            share: self.windows.share.address().map(|address| {
                let modules = self.windows.share.modules();
                ShareStats { bytes: address.len(), modules }
            }),
            close: explore.close().map(|(name, place)| (name, self.css_pixels(place))).into_iter().collect(),
        }
    }

    fn handle_positions(&self) -> HandlePositions {
        let ([x1, y1], [x2, y2]) = (self.places_of_dots(Side::Source), self.places_of_dots(Side::Target));
        let pins = Side::BOTH.map(|side| self.places_of_pins(side));
        let marks = Side::BOTH.map(|side| {
            let places = marks::places(side, &self.model, &self.pictures.views[side]);
            places.into_iter().map(|(_, place)| self.css_pixels(place)).collect()
        });
        HandlePositions { x1, x2, y1, y2, pins, marks, caught: accessibility::caught(self) }
    }

    /// The positions of a side's interior point and boundary point.
    fn places_of_dots(&self, side: Side) -> [Option<[f32; 2]>; 2] {
        let places = self.pictures.of(&self.model, side).places_of_dots(&self.model, side);
        places.map(|place| place.map(|place| self.css_pixels(place)))
    }

    /// The positions of a side's pins; none where the points determine the map.
    fn places_of_pins(&self, side: Side) -> Vec<[f32; 2]> {
        let places = self.pictures.of(&self.model, side).places(&self.model, side);
        let pins = places.into_iter().filter(|(kind, _)| matches!(kind, HandleKind::Pin(_)));
        pins.map(|(_, place)| self.css_pixels(place)).collect()
    }

    /// A position on the screen in the page's CSS pixels.
    fn css_pixels(&self, place: egui::Pos2) -> [f32; 2] {
        [place.x * self.screen.zoom, place.y * self.screen.zoom]
    }

    /// All errors that are shown: beside the inputs, over the pictures, in the panel and in the windows.
    pub(super) fn errors(&self) -> Vec<Message> {
        let sides = Side::BOTH
            .into_iter()
            .flat_map(|side| self.model.user_errors(side))
            .map(|user_error| user_error.text.clone());
        let map = self.model.map_error().map(|(_, text)| text.clone());
        let inputs = sides.chain(map).chain(self.messages.common.clone());
        let panel = overlays::panel::errors(&self.model).cloned();
        let windows =
            self.editor.errors().chain(self.windows.reports.errors()).cloned().chain(self.windows.exporter.errors());
        inputs.chain(panel).chain(windows).chain(self.windows.projection.error()).collect()
    }

    pub(super) fn notes(&self) -> Vec<Message> {
        Side::BOTH.into_iter().flat_map(|side| self.model.notes(side)).collect()
    }

    /// The processor that evaluates the Cauchy–Green extension in the picture, if that extension is requested.
    pub(super) fn cauchy_green(&self) -> Option<Processor> {
        let on_gpu = self.pictures.gpu.as_ref().is_some_and(|gpu| gpu.extends(&self.model));
        let asked = self.model.session().extension() == Extension::CauchyGreen;
        asked.then_some(if on_gpu { Processor::Gpu } else { Processor::Cpu })
    }
}

/// A map projection that was computed.
fn projected(found: &FoundProjection) -> ProjectionStats {
    ProjectionStats {
        progress: None,
        scale_ratio: Some(found.report.scale_ratio),
        stereographic_scale_ratio: Some(found.report.stereographic_scale_ratio),
        scale_lines: found.scales.iter().map(|scale| scale.lines.len()).sum(),
        notes: found.notes().iter().map(Message::english).collect(),
    }
}
