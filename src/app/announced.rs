//! What is reported to the page around the app, each new error once, and to a screen reader.

use super::frame::REST_SECONDS;
use super::viewport::probe;
use super::{RiemapApp, accessibility, message_bar};
use crate::conformal::Side;
use crate::language::{self, Language, Message};
use crate::model::PointedImage;
use crate::model::best::Outcome;
use crate::platform::{self, PageEvent};
use crate::worker::FoundInvariants;

/// The reports so far.
#[derive(Debug, Default)]
pub struct Announced {
    errors: Vec<Message>,
    /// The state at the last description of the picture.
    described: Option<News>,
    /// The count of controls that were read out.
    pub controls: u64,
}

/// The state that a description of the screen depends on; the picture is described again when it changes.
#[derive(Debug, Clone, PartialEq)]
struct News {
    generation: u64,
    is_ready: bool,
    /// Which sides' invariants are shown.
    invariants: [Option<Result<FoundInvariants, Message>>; 2],
    /// The map at a point that was clicked.
    pointed: Option<PointedImage>,
    errors: Vec<Message>,
    /// The size and the turning of the probe's image, in words.
    probe: Option<String>,
    /// What the last formula reached, as the export window says it.
    formula: Vec<(Message, bool)>,
    /// The result of the last search for the best map.
    best: Option<Outcome>,
    /// The step of the tour.
    step: Option<usize>,
    /// The language of the description.
    language: Language,
    /// The time at which the notice ends.
    notice_until: Option<f64>,
}

impl Announced {
    /// The errors of this frame that were not shown in the previous one.
    fn news(&mut self, errors: Vec<Message>) -> Vec<Message> {
        let news = errors.iter().filter(|error| !self.errors.contains(error)).cloned().collect();
        self.errors = errors;
        news
    }
}

impl RiemapApp {
    /// Reports to the page the errors that are new in this frame, and to a screen reader the control that was used.
    pub(super) fn announce(&mut self, ui: &egui::Ui) {
        message_bar::end(self, ui.ctx());
        let errors = self.errors();
        for error in self.announced.news(errors) {
            platform::tell_page(PageEvent::Error, &error.english());
        }
        let announcement =
            ui.output(|output| output.events.last().map(|event| accessibility::control(event.widget_info())));
        if let Some(announcement) = announcement {
            platform::say(&announcement);
            self.announced.controls += 1;
        }
    }

    /// Describes the screen to a screen reader whenever its state has changed and rests.
    pub(super) fn describe(&mut self, context: &egui::Context, now: f64) {
        let rested = now - self.last_change;
        if rested < REST_SECONDS {
            // a drag is not described while it lasts
            context.request_repaint_after_secs((REST_SECONDS - rested) as f32);
            return;
        }
        let news = self.news();
        if self.announced.described.as_ref() == Some(&news) {
            return;
        }
        platform::describe(&accessibility::state(self));
        self.announced.described = Some(news);
    }

    /// The map at a point that was clicked or tapped; those under a moving pointer are not described.
    pub(super) fn clicked(&self) -> Option<PointedImage> {
        self.pictures.pointed.filter(|_| self.input.handles.pointed.is_some_and(|at| at.stays))
    }

    fn news(&self) -> News {
        News {
            generation: self.model.generation(),
            is_ready: self.model.is_ready(),
            invariants: Side::BOTH.map(|side| self.model.invariants(side).cloned()),
            pointed: self.clicked(),
            errors: self.errors(),
            probe: self.pictures.probe.as_ref().map(probe::words),
            formula: self.windows.exporter.formula_notes(),
            best: self.model.best().outcome().cloned(),
            step: self.windows.explore.step(),
            language: language::current(),
            notice_until: self.messages.notice.map(|notice| notice.until),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_is_told_when_it_appears_and_again_when_it_comes_back() {
        let mut announced = Announced::default();
        let [a, b] = ["a", "b"].map(Message::from);
        assert_eq!(announced.news(vec![a.clone()]), vec![a.clone()]);
        assert_eq!(announced.news(vec![a.clone(), b.clone()]), [b]);
        assert_eq!(announced.news(Vec::new()), []);
        assert_eq!(announced.news(vec![a.clone()]), [a]);
    }
}
