//! What is reported to the page around the app, each new error once, and to a screen reader.

use super::frame::REST_SECONDS;
use super::{RiemapApp, accessibility, message_bar};
use crate::language::Message;
use crate::model::PointedImage;
use crate::platform::{self, PageEvent};

/// The reports so far.
#[derive(Debug, Default)]
pub struct Announced {
    errors: Vec<Message>,
    /// The last description of the screen.
    described: String,
    /// The count of controls that were read out.
    pub controls: u64,
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
        // a drag is not described while it lasts; that of a mark changes no map
        let rested = if self.input.handles.grip.is_some() { 0.0 } else { now - self.last_change };
        if rested < REST_SECONDS {
            context.request_repaint_after_secs((REST_SECONDS - rested) as f32);
            return;
        }
        let description = accessibility::state(self);
        if self.announced.described != description {
            platform::describe(&description);
            self.announced.described = description;
        }
    }

    /// The map at a point that was clicked or tapped; those under a moving pointer are not described.
    pub(super) fn clicked(&self) -> Option<PointedImage> {
        self.pictures.pointed.filter(|_| self.input.handles.pointed.is_some_and(|at| at.stays))
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
