//! What the app knows of itself: the numbers on the screen, errors and notes, where the dots are.

use super::{RiemapApp, editing};
use crate::app::overlays;
use crate::app::status::stats;
use crate::app::status::stats::{HandlePositions, ScreenFacts, Stats};
use crate::app::viewport::gpu::Gpu;
use crate::conformal::{Extension, Side};
use crate::language::Message;
use crate::model::Processor;

impl RiemapApp {
    /// The numbers on the screen.
    pub fn stats(&self) -> Stats {
        let place = |side: Side, point: Option<glam::DVec2>| {
            point.map(|point| self.views[side as usize].to_screen(point)).map(|place| self.css_pixels(place))
        };
        let in_space = |point: Option<glam::DVec3>| self.orbit.to_screen(point?).map(|place| self.css_pixels(place));
        let [x2, y2] = match self.model.surface(Side::Target) {
            Some(_) => [self.model.surface_point(Side::Target), self.model.surface_anchor(Side::Target)].map(in_space),
            None => [self.model.interior(Side::Target), self.model.anchor(Side::Target)]
                .map(|point| place(Side::Target, point)),
        };
        let handles = HandlePositions {
            x1: place(Side::Source, self.model.interior(Side::Source)),
            x2,
            y1: place(Side::Source, self.model.anchor(Side::Source)),
            y2,
        };
        let backend = self.gpu.as_ref().map(Gpu::backend).unwrap_or_default();
        let screen = ScreenFacts {
            backend,
            handles,
            errors: self.errors().iter().map(Message::english).collect(),
            notes: self.notes().iter().map(Message::english).collect(),
            undo: self.persistence.history().undo_count(),
            dark: self.theme == egui::Theme::Dark,
            spoken: self.spoken,
            playing: self.player.is_playing(),
            export: self.exporter.places().cloned(),
            close: self.explore.close().map(|(name, place)| (name, self.css_pixels(place))).into_iter().collect(),
            export_count: self.exporter.count(),
            marked_boundary: self.plots.marked(),
            exact_difference: self.plots.exact().map(|exact| exact.difference),
            cauchy_green: self.cauchy_green(),
            editing: editing::stats(&self.editor, &self.views),
        };
        stats::collect(&self.model, screen)
    }

    /// A place on the screen as the page measures it.
    fn css_pixels(&self, place: egui::Pos2) -> [f32; 2] {
        [place.x * self.zoom, place.y * self.zoom]
    }

    /// All that is said to be wrong: beside the inputs, over the pictures, in the panel and in the windows.
    pub(super) fn errors(&self) -> Vec<Message> {
        let sides = Side::BOTH
            .into_iter()
            .flat_map(|side| self.model.user_errors(side))
            .map(|user_error| user_error.text.clone());
        let map = self.model.map_error().map(|(_, text)| text.clone());
        let inputs = sides.chain(map).chain(self.message.clone());
        let panel = overlays::panel::errors(&self.model).cloned();
        let windows = self.editor.errors().chain(self.reports.errors()).cloned().chain(self.exporter.errors());
        inputs.chain(panel).chain(windows).collect()
    }

    pub(super) fn notes(&self) -> Vec<Message> {
        Side::BOTH.into_iter().flat_map(|side| self.model.notes(side)).collect()
    }

    /// Where the Cauchy–Green extension in the picture comes from, if it is asked for.
    pub(super) fn cauchy_green(&self) -> Option<Processor> {
        let on_gpu = self.gpu.as_ref().is_some_and(|gpu| gpu.extends(&self.model));
        let asked = self.model.session().extension() == Extension::CauchyGreen;
        asked.then_some(if on_gpu { Processor::Gpu } else { Processor::Cpu })
    }
}
