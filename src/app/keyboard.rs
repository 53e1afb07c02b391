//! Who gets the Tab key: a hand at the pointer folds the panels with it, a person at the keyboard walks
//! from control to control.
//!
//! After the pointer was used, Tab folds; while a control has the keyboard, and before the pointer was ever
//! used, it goes to the next control, as everywhere. F6 or Shift+Tab begin to walk from anywhere, Escape ends it.

use egui::{Context, Event, Key, RawInput};

/// What was used last.
#[derive(Debug, Clone, Copy, Default)]
pub struct Keyboard {
    /// The pointer, and no key since then that walks.
    by_pointer: bool,
}

impl Keyboard {
    /// Looks at a frame's events before egui does; returns how many times the panels are to be folded or brought back.
    pub fn take_in(&mut self, context: &Context, input: &mut RawInput) -> usize {
        let mut walks = context.memory(|memory| memory.focused().is_some());
        let (mut folds, mut events) = (0, Vec::with_capacity(input.events.len()));
        for event in std::mem::take(&mut input.events) {
            match event {
                Event::PointerMoved(_) | Event::PointerButton { .. } | Event::Touch { .. } => self.by_pointer = true,
                Event::Key { key: Key::F6, physical_key, pressed, repeat, modifiers } => {
                    (self.by_pointer, walks) = (false, true);
                    events.push(Event::Key { key: Key::Tab, physical_key, pressed, repeat, modifiers });
                    continue;
                }
                Event::Key { key: Key::Tab, pressed, modifiers, .. } => {
                    if self.by_pointer && !walks && !modifiers.any() {
                        folds += usize::from(pressed);
                        continue;
                    }
                    (self.by_pointer, walks) = (false, true);
                }
                _ => {}
            }
            events.push(event);
        }
        input.events = events;
        folds
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::{Modifiers, pos2};

    fn key(key: Key, modifiers: Modifiers) -> Event {
        Event::Key { key, physical_key: None, pressed: true, repeat: false, modifiers }
    }

    /// How often the panels fold, and how many Tab keys are left for egui.
    fn after(events: Vec<Event>) -> (usize, usize) {
        let mut input = RawInput { events, ..RawInput::default() };
        let folds = Keyboard::default().take_in(&Context::default(), &mut input);
        let is_tab = |event: &&Event| matches!(event, Event::Key { key: Key::Tab, .. });
        (folds, input.events.iter().filter(is_tab).count())
    }

    #[test]
    fn tab_folds_for_a_pointer_and_walks_for_a_keyboard() {
        let moved = || Event::PointerMoved(pos2(3.0, 4.0));
        let tab = || key(Key::Tab, Modifiers::NONE);
        assert_eq!(after(vec![moved(), tab()]), (1, 0));
        assert_eq!(after(vec![tab()]), (0, 1));
        assert_eq!(after(vec![moved(), key(Key::Tab, Modifiers::SHIFT), tab()]), (0, 2));
        assert_eq!(after(vec![moved(), key(Key::F6, Modifiers::NONE), tab()]), (0, 2));
        assert_eq!(after(vec![moved(), tab(), tab()]), (2, 0));
    }
}
