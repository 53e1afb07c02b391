//! Touches that the system takes away: by a gesture of its own, a call, a palm.

use egui::{Event, Modifiers, PointerButton, TouchPhase};

/// Lets go of what a cancelled touch has held; browsers tell of it, but not that the pointer is up.
pub fn end_cancelled(events: &mut Vec<Event>) {
    let released = |event: &Event| {
        let Event::Touch { phase: TouchPhase::Cancel, pos, .. } = *event else { return None };
        let button =
            Event::PointerButton { pos, button: PointerButton::Primary, pressed: false, modifiers: Modifiers::NONE };
        Some([button, Event::PointerGone])
    };
    let ends: Vec<Event> = events.iter().filter_map(released).flatten().collect();
    events.extend(ends);
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::{Context, RawInput, TouchDeviceId, TouchId, pos2};

    #[test]
    fn a_cancelled_touch_holds_nothing_any_more() {
        let (context, pos) = (Context::default(), pos2(20.0, 30.0));
        let touch = |phase| Event::Touch { device_id: TouchDeviceId(0), id: TouchId(1), phase, pos, force: None };
        let press =
            Event::PointerButton { pos, button: PointerButton::Primary, pressed: true, modifiers: Modifiers::NONE };
        let is_down = |mut events: Vec<Event>| {
            end_cancelled(&mut events);
            let input = RawInput { events, ..RawInput::default() };
            context.run_ui(input, |_| {}).textures_delta.clear();
            context.input(|input| input.pointer.any_down())
        };
        assert!(is_down(vec![touch(TouchPhase::Start), press]));
        assert!(is_down(vec![touch(TouchPhase::Move)]));
        assert!(!is_down(vec![touch(TouchPhase::Cancel)]));
    }
}
