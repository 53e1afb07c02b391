//! Touches that the system cancels: for a system gesture, a call, or a palm.

use egui::{Event, Modifiers, PointerButton, TouchId, TouchPhase, vec2};

/// An offset larger than a click may move and than any screen is wide: walls of screens have 1e5 points.
const AWAY: egui::Vec2 = vec2(1e7, 0.0);

/// The touch that acts as the pointer.
#[derive(Debug, Default)]
pub struct Touches {
    first: Option<TouchId>,
}

/// Whether this event marks a canceled touch: everything since its press must be discarded.
pub fn lets_go(event: &Event) -> bool {
    matches!(event, Event::PointerMoved(place) if place.x > 0.5 * AWAY.x)
}

impl Touches {
    /// Adds a pointer release without a click after a canceled touch: egui is not told that the pointer is up.
    pub fn take_in(&mut self, events: &mut Vec<Event>) {
        for event in std::mem::take(events) {
            let Event::Touch { id, phase, pos, .. } = event else {
                events.push(event);
                continue;
            };
            events.push(event);
            match phase {
                TouchPhase::Start => self.first = self.first.or(Some(id)),
                TouchPhase::Move => {}
                TouchPhase::End | TouchPhase::Cancel if self.first != Some(id) => {}
                TouchPhase::End => self.first = None,
                TouchPhase::Cancel => {
                    self.first = None;
                    let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
                    events.extend([
                        Event::PointerMoved(pos + AWAY),
                        Event::PointerMoved(pos),
                        Event::PointerButton { pos, button, pressed: false, modifiers },
                        Event::PointerGone,
                    ]);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::{Context, Pos2, RawInput, Rect, Sense, TouchDeviceId, pos2};

    const PLACE: Pos2 = pos2(20.0, 30.0);

    fn touch(finger: u64, phase: TouchPhase) -> Event {
        Event::Touch { device_id: TouchDeviceId(0), id: TouchId(finger), phase, pos: PLACE, force: None }
    }

    fn button(pressed: bool) -> Event {
        Event::PointerButton { pos: PLACE, button: PointerButton::Primary, pressed, modifiers: Modifiers::NONE }
    }

    /// Whether the pointer is down after each frame, and whether the button at `PLACE` was ever clicked.
    fn after(frames: Vec<Vec<Event>>) -> (Vec<bool>, bool) {
        let (context, mut touches, mut is_clicked) = (Context::default(), Touches::default(), false);
        let mut is_down = Vec::new();
        for mut events in [vec![], vec![Event::PointerMoved(PLACE)]].into_iter().chain(frames) {
            touches.take_in(&mut events);
            let input = RawInput { events, ..RawInput::default() };
            let mut shown = context.run_ui(input, |ui| {
                let place = Rect::from_center_size(PLACE, vec2(20.0, 20.0));
                is_clicked |= ui.interact(place, egui::Id::unique("button"), Sense::click_and_drag()).clicked();
            });
            shown.textures_delta.clear();
            is_down.push(context.input(|input| input.pointer.any_down()));
        }
        (is_down.split_off(2), is_clicked)
    }

    #[test]
    fn a_cancelled_touch_releases_the_pointer_without_a_click() {
        use TouchPhase::{Cancel, End, Start};
        let press = || vec![touch(1, Start), button(true)];
        assert_eq!(after(vec![press(), vec![touch(1, End), button(false)]]), (vec![true, false], true));
        assert_eq!(after(vec![press(), vec![touch(1, Cancel)]]), (vec![true, false], false));
        // the next touch may begin in the same frame; a canceled touch that is not the pointer releases nothing
        let again = vec![touch(1, Cancel), touch(2, Start), button(true)];
        assert_eq!(after(vec![press(), again]), (vec![true, true], false));
        assert_eq!(after(vec![press(), vec![touch(2, Start)], vec![touch(2, Cancel)]]), (vec![true; 3], false));
    }
}
