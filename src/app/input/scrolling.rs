//! Scrolling by itself: to what has just changed, and back to a control whose place other content has moved.

use egui::{Id, Response, Ui, Vec2, style::ScrollAnimation, vec2};

/// How long after a click content may come that belongs to it, in seconds: an outline is prepared in less.
const SETTLES: f64 = 5.0;

/// Whether a value differs from that in the last frame that asked with this id; not in the first one.
pub fn has_changed<T: Clone + PartialEq + Send + Sync + 'static>(ui: &Ui, id: Id, value: &T) -> bool {
    let last: Option<T> = ui.data(|data| data.get_temp(id));
    ui.data_mut(|data| data.insert_temp(id, value.clone()));
    last.is_some_and(|last| last != *value)
}

/// Keeps a control that was clicked at its place on the screen, while content above it in the same column comes or goes;
/// until the user scrolls. The control needs an id that does not count what is above it.
pub fn keep_place(ui: &Ui, control: &Response) {
    let id = control.id.with("kept place");
    let (now, pass) = (ui.input(|input| input.time), ui.ctx().cumulative_pass_nr());
    if control.clicked() {
        ui.data_mut(|data| data.insert_temp(id, Place { top: control.rect.top(), since: now, scrolled_in: 0 }));
        return;
    }
    let Some(place) = ui.data(|data| data.get_temp::<Place>(id)) else { return };
    if now - place.since > SETTLES || ui.input(|input| input.smooth_scroll_delta() != Vec2::ZERO) {
        ui.data_mut(|data| data.remove::<Place>(id));
        return;
    }
    let moved = control.rect.top() - place.top;
    // in the pass after it was scrolled, egui still lays it out as before
    if moved.abs() > 0.5 && pass > place.scrolled_in + 1 {
        ui.scroll_with_delta_animation(vec2(0.0, -moved), ScrollAnimation::none());
        ui.data_mut(|data| data.insert_temp(id, Place { scrolled_in: pass, ..place }));
        ui.request_repaint();
    }
}

/// The place of a control that was clicked.
#[derive(Clone, Copy)]
struct Place {
    /// Its upper edge on the screen.
    top: f32,
    /// When it was clicked, in seconds.
    since: f64,
    /// The pass in which it was last scrolled back.
    scrolled_in: u64,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::theme;
    use egui::{Button, ScrollArea, UiBuilder};
    use egui_kittest::Harness;
    use egui_kittest::kittest::Queryable;

    #[test]
    fn a_row_that_is_chosen_elsewhere_comes_into_view() {
        let list = |ui: &mut Ui, chosen: &mut usize| {
            ScrollArea::vertical().max_height(100.0).show(ui, |ui| {
                for k in 0..30 {
                    let row = ui.label(format!("row {k}"));
                    if k == *chosen && has_changed(ui, Id::unique("row"), &k) {
                        row.scroll_to_me(None);
                    }
                }
            });
        };
        let mut harness =
            Harness::builder().with_size([200.0, 300.0]).with_context_setup(theme::install).build_ui_state(list, 0);
        harness.run();
        let bottom = |harness: &Harness<'_, usize>| harness.get_by_label("row 25").rect().bottom();
        assert!(bottom(&harness) > 200.0);
        *harness.state_mut() = 25;
        harness.run();
        assert!((50.0..=110.0).contains(&bottom(&harness)), "{}", bottom(&harness));
    }

    #[test]
    fn a_clicked_control_stays_where_it_is_while_rows_come_above_it() {
        let column = |ui: &mut Ui, rows: &mut usize| {
            ScrollArea::vertical().max_height(250.0).show(ui, |ui| {
                (0..*rows).for_each(|k| drop(ui.label(format!("above {k}"))));
                let scope = UiBuilder::new().scope_id(Id::unique("go"));
                let go = ui.scope_builder(scope, |ui| ui.add(Button::new("go"))).inner;
                keep_place(ui, &go);
                if go.clicked() {
                    *rows += 4;
                }
                (0..30).for_each(|k| drop(ui.label(format!("below {k}"))));
            });
        };
        let mut harness =
            Harness::builder().with_size([200.0, 300.0]).with_context_setup(theme::install).build_ui_state(column, 3);
        harness.run();
        let top = |harness: &Harness<'_, usize>| harness.get_by_label("go").rect().top();
        let before = top(&harness);
        harness.get_by_label("go").click();
        harness.run();
        assert_eq!(*harness.state(), 7);
        assert!((top(&harness) - before).abs() < 1.0, "from {before} to {}", top(&harness));
    }
}
