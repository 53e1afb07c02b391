//! What the page around the app is told: the errors on the screen, each once.

use super::RiemapApp;
use crate::platform::{self, PageEvent};

/// What was told.
#[derive(Debug, Default)]
pub struct Announced {
    errors: Vec<String>,
}

impl Announced {
    /// Of the errors that are shown now, those that were not a frame ago.
    fn news(&mut self, errors: Vec<String>) -> Vec<String> {
        let news = errors.iter().filter(|error| !self.errors.contains(error)).cloned().collect();
        self.errors = errors;
        news
    }
}

impl RiemapApp {
    /// Tells the page what is new in this frame.
    pub(super) fn announce(&mut self) {
        let errors = self.errors();
        for error in self.announced.news(errors) {
            platform::tell_page(PageEvent::Error, &error);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_is_told_when_it_appears_and_again_when_it_comes_back() {
        let mut announced = Announced::default();
        let [a, b] = ["a", "b"].map(String::from);
        assert_eq!(announced.news(vec![a.clone()]), vec![a.clone()]);
        assert_eq!(announced.news(vec![a.clone(), b.clone()]), [b]);
        assert_eq!(announced.news(Vec::new()), [""; 0]);
        assert_eq!(announced.news(vec![a.clone()]), [a]);
    }
}
