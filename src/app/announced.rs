//! What the page around the app is told: the errors on the screen, each once.

use super::{RiemapApp, accessibility, message_bar};
use crate::language::Message;
use crate::platform::{self, PageEvent};

/// What was told.
#[derive(Debug, Default)]
pub struct Announced {
    errors: Vec<Message>,
}

impl Announced {
    /// Of the errors that are shown now, those that were not a frame ago.
    fn news(&mut self, errors: Vec<Message>) -> Vec<Message> {
        let news = errors.iter().filter(|error| !self.errors.contains(error)).cloned().collect();
        self.errors = errors;
        news
    }
}

impl RiemapApp {
    /// Tells the page the errors that are new in this frame, and those who hear the screen the control that was used.
    pub(super) fn announce(&mut self, ui: &egui::Ui) {
        message_bar::end(self, ui.ctx());
        let errors = self.errors();
        for error in self.announced.news(errors) {
            platform::tell_page(PageEvent::Error, &error.english());
        }
        let spoken = ui.output(|output| output.events.last().map(|event| accessibility::control(event.widget_info())));
        if let Some(spoken) = spoken {
            platform::say(&spoken);
            self.spoken += 1;
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
