//! Dispatch of keys: Tab either folds the panels or moves the focus, and each key goes to the control that is focused
//! after all earlier keys have been processed.
//!
//! Tab folds the panels after the pointer was used. It moves the focus while a control is focused and before the
//! pointer was ever used. F6 and Shift+Tab always move the focus; Escape removes it.
//!
//! egui processes the focus keys of a frame before any control sees its keys, and learns which keys a control
//! captures only one frame after it was focused. So a key that moves the focus is delayed until the earlier keys have
//! been delivered, later keys are delayed to the next frame, and keys that could move the focus again by one more.

use egui::{Context, Event, Id, Key, RawInput};

/// The last used device, the focus, and the delayed keys.
#[derive(Debug, Clone, Default)]
pub struct Keyboard {
    /// The pointer was used, and no key has moved the focus since.
    by_pointer: bool,
    /// The focused control at the beginning of the last frame.
    focused: Option<Id>,
    /// Whether a key of the last frame has moved the focus.
    has_walked: bool,
    /// Keys that are delayed to the next frame.
    waiting: Vec<Event>,
}

impl Keyboard {
    /// Filters a frame's events before egui sees them; returns how many times the panels are to be toggled.
    pub fn take_in(&mut self, context: &Context, input: &mut RawInput) -> usize {
        let focused = context.memory(egui::Memory::focused);
        let is_new = focused != std::mem::replace(&mut self.focused, focused);
        let is_fresh = std::mem::take(&mut self.has_walked) || is_new;
        let (mut walks, mut folds) = (focused.is_some(), 0);
        let arrived = std::mem::take(&mut input.events);
        let (mut later, mut has_passed) = (Vec::new(), false);
        for event in std::mem::take(&mut self.waiting).into_iter().chain(arrived) {
            let waits = self.has_walked
                || !later.is_empty()
                || (has_passed && walks_from_here(&event))
                || (is_fresh && leads_away(&event));
            if waits && is_of_keyboard(&event) {
                if !is_repeated(&event, &later) {
                    later.push(event);
                }
                continue;
            }
            has_passed |= is_of_keyboard(&event) && !matches!(event, Event::Key { pressed: false, .. });
            match event {
                Event::PointerMoved(_) | Event::PointerButton { .. } | Event::Touch { .. } => self.by_pointer = true,
                // the releases of delayed presses would not arrive in this window
                Event::WindowFocused(false) => later.clear(),
                Event::Key { key: Key::F6, physical_key, pressed, repeat, modifiers } => {
                    (self.by_pointer, walks) = (false, true);
                    self.has_walked = pressed;
                    input.events.push(Event::Key { key: Key::Tab, physical_key, pressed, repeat, modifiers });
                    continue;
                }
                Event::Key { key: Key::Tab, pressed, modifiers, .. } => {
                    if self.by_pointer && !walks && !modifiers.any() {
                        folds += usize::from(pressed);
                        continue;
                    }
                    (self.by_pointer, walks) = (false, true);
                    self.has_walked = pressed;
                }
                Event::Key { key: Key::Escape, pressed: true, .. } => self.has_walked = walks,
                _ => {}
            }
            input.events.push(event);
        }
        self.waiting = later;
        if !self.waiting.is_empty() {
            context.request_repaint();
        }
        folds
    }
}

/// Whether the event is another press of a held Tab or F6 whose last press is still delayed. Such repeats are dropped,
/// so that they do not pile up faster than frames process them.
fn is_repeated(event: &Event, waiting: &[Event]) -> bool {
    let Event::Key { key: held @ (Key::Tab | Key::F6), pressed: true, .. } = event else { return false };
    let last = waiting.iter().rev().find(|event| matches!(event, Event::Key { key, .. } if key == held));
    matches!(last, Some(Event::Key { pressed: true, .. }))
}

/// Whether this key takes the focus away from nearly every focused control.
fn walks_from_here(event: &Event) -> bool {
    matches!(event, Event::Key { key: Key::Tab | Key::F6 | Key::Escape, pressed: true, .. })
}

/// Whether this key takes the focus away from a control that does not capture it.
fn leads_away(event: &Event) -> bool {
    let keys = [Key::ArrowUp, Key::ArrowRight, Key::ArrowDown, Key::ArrowLeft, Key::Escape];
    matches!(event, Event::Key { key, pressed: true, modifiers, .. } if keys.contains(key) && !modifiers.any())
}

fn is_of_keyboard(event: &Event) -> bool {
    matches!(event, Event::Key { .. } | Event::Text(_) | Event::Ime(_) | Event::Copy | Event::Cut | Event::Paste(_))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::input::handles::{Handle, HandleKind, HandleState};
    use crate::app::input::keyboard_navigation;
    use crate::app::input::keyboard_navigation::KeyStep;
    use crate::conformal::Side;
    use egui::{Modifiers, pos2, vec2};

    fn key(key: Key, modifiers: Modifiers) -> Event {
        Event::Key { key, physical_key: None, pressed: true, repeat: false, modifiers }
    }

    fn plain(of: Key) -> Event {
        key(of, Modifiers::NONE)
    }

    /// The release that belongs to a press.
    fn released(press: &Event) -> Event {
        let mut end = press.clone();
        if let Event::Key { pressed, .. } = &mut end {
            *pressed = false;
        }
        end
    }

    /// How often the panels are toggled, and how many Tab keys are passed to egui.
    fn after(mut events: Vec<Event>) -> (usize, usize) {
        let (mut keyboard, context) = (Keyboard::default(), Context::default());
        let (mut folds, mut tabs) = (0, 0);
        for _ in 0..4 {
            let mut input = RawInput { events: std::mem::take(&mut events), ..RawInput::default() };
            folds += keyboard.take_in(&context, &mut input);
            let is_tab = |event: &&Event| matches!(event, Event::Key { key: Key::Tab, .. });
            tabs += input.events.iter().filter(is_tab).count();
        }
        (folds, tabs)
    }

    #[test]
    fn tab_folds_the_panels_after_the_pointer_was_used_and_else_moves_the_focus() {
        let moved = || Event::PointerMoved(pos2(3.0, 4.0));
        let tab = || plain(Key::Tab);
        assert_eq!(after(vec![moved(), tab()]), (1, 0));
        assert_eq!(after(vec![tab()]), (0, 1));
        assert_eq!(after(vec![moved(), key(Key::Tab, Modifiers::SHIFT), tab()]), (0, 2));
        assert_eq!(after(vec![moved(), plain(Key::F6), tab()]), (0, 2));
        assert_eq!(after(vec![moved(), tab(), tab()]), (2, 0));
    }

    /// A screen with a button, two dots and another button.
    #[derive(Default)]
    struct Screen {
        context: Context,
        keyboard: Keyboard,
        handles: HandleState,
        clicks: [usize; 2],
        key_steps: Vec<KeyStep>,
    }

    impl Screen {
        /// Runs frames with these events, and then eight without events.
        fn run<const N: usize>(&mut self, frames: [Vec<Event>; N]) {
            for events in frames.into_iter().chain(std::iter::repeat_n(Vec::new(), 8)) {
                let mut input = RawInput { events, ..RawInput::default() };
                self.keyboard.take_in(&self.context, &mut input);
                let mut shown = self.context.clone().run_ui(input, |ui| {
                    self.clicks[0] += usize::from(ui.button("before").clicked());
                    let places =
                        vec![(HandleKind::Interior, pos2(60.0, 200.0)), (HandleKind::Boundary, pos2(160.0, 200.0))];
                    self.key_steps.extend(keyboard_navigation::of_dots(ui, Side::Source, &places, &mut self.handles));
                    self.clicks[1] += usize::from(ui.button("after").clicked());
                });
                shown.textures_delta.clear(); // nothing is drawn
            }
        }

        fn focused(&self) -> Option<HandleKind> {
            self.handles.focused.map(|Handle { kind, .. }| kind)
        }
    }

    #[test]
    fn arrow_keys_reach_the_dot_that_the_tab_before_them_has_focused() {
        let [tab, right] = [Key::Tab, Key::ArrowRight].map(plain);
        let moved: f32 = 20.0;
        for frames in [
            [vec![tab.clone(), tab.clone(), right.clone(), right.clone()], Vec::new(), Vec::new()],
            [vec![tab.clone()], vec![tab.clone(), right.clone()], vec![right.clone()]],
            [vec![tab.clone(), tab.clone()], vec![right.clone()], vec![right]],
        ] {
            let mut screen = Screen::default();
            screen.run(frames);
            assert_eq!(screen.focused(), Some(HandleKind::Interior));
            let way = screen.key_steps.iter().fold(egui::Vec2::ZERO, |way, key_step| match key_step {
                KeyStep::Interior(step) => way + *step,
                _ => way,
            });
            assert_eq!(way, vec2(moved, 0.0), "{:?}", screen.key_steps);
        }
    }

    #[test]
    fn keys_of_one_frame_are_delivered_in_order() {
        let [tab, space, escape] = [Key::Tab, Key::Space, Key::Escape].map(plain);
        let mut screen = Screen::default();
        let all = [&tab, &space, &tab, &tab, &tab, &space, &escape, &tab, &tab];
        screen.run([all.into_iter().flat_map(|press| [press.clone(), released(press)]).collect()]);
        assert_eq!(screen.clicks, [1, 1]);
        assert_eq!(screen.focused(), Some(HandleKind::Interior), "from the beginning after Escape");
    }

    #[test]
    fn a_held_tab_moves_the_focus_at_most_once_per_frame() {
        let mut keyboard = Keyboard::default();
        let release = released(&plain(Key::Tab));
        let mut events = vec![plain(Key::Tab); 30];
        events.extend([release.clone(), plain(Key::Tab), release.clone()]);
        let mut input = RawInput { events, ..RawInput::default() };
        keyboard.take_in(&Context::default(), &mut input);
        assert_eq!(input.events, [plain(Key::Tab)]);
        assert_eq!(keyboard.waiting, [plain(Key::Tab), release.clone(), plain(Key::Tab), release]);
    }

    #[test]
    fn delayed_keys_are_dropped_when_the_window_loses_focus() {
        let mut screen = Screen::default();
        let [tab, right] = [Key::Tab, Key::ArrowRight].map(plain);
        screen.run([vec![tab.clone(), tab, right, Event::WindowFocused(false)]]);
        assert_eq!((screen.focused(), screen.key_steps.len()), (None, 0));
    }
}
