//! The list of keys and gestures.

use crate::app::theme::text_metrics::scroll_beyond;
use crate::app::theme::{Palette, bold};
use crate::app::windows::explore::window::BESIDES;
use crate::language::{Label as Words, key, tr};
use egui::{Align, Label, Layout, RichText, Ui, vec2};

/// The width of the list where there is room, in points.
pub const WIDTH: f32 = 660.0;
/// The fraction of the width that the column of keys takes.
const KEYS_SHARE: f32 = 0.32;
/// Room for the scroll bar beside the list.
const SCROLL_BAR: f32 = 8.0;

/// The groups of the list: pairs of a key or gesture and its effect.
const GROUPS: [(Words, &[[Words; 2]]); 4] = [
    (
        key::mouse_fingers(),
        &[
            [key::drag_dot_gesture(), key::drag_dot_gesture_about()],
            [key::drag_with_alt(), key::drag_with_alt_about()],
            [key::drag_beside_dots(), key::drag_beside_dots_about()],
            [key::wheel_two_fingers(), key::wheel_two_fingers_about()],
            [key::double_click(), key::double_click_about()],
            [key::drop_file(), key::drop_file_about()],
        ],
    ),
    (
        key::keys(),
        &[
            [key::key_tab(), key::key_tab_about()],
            [key::key_p(), key::key_p_about()],
            [key::space(), key::space_about()],
            [key::key_f(), key::key_f_about()],
            [key::ctrl_z(), key::ctrl_z_about()],
            [key::ctrl_shift_z_ctrl_y(), key::ctrl_shift_z_ctrl_y_about()],
            [key::ctrl_s(), key::ctrl_s_about()],
            [key::ctrl_e(), key::ctrl_e_about()],
        ],
    ),
    (
        key::drawing_reshaping(),
        &[
            [key::d_l_c(), key::d_l_c_about()],
            [key::enter_backspace(), key::enter_backspace_about()],
            [key::key_e(), key::key_e_about()],
            [key::double_click_outline(), key::double_click_outline_about()],
            [key::n_shift_n(), key::n_shift_n_about()],
            [key::arrow_keys_delete(), key::arrow_keys_delete_about()],
            [key::escape(), key::escape_about()],
            [key::ctrl_v(), key::ctrl_v_about()],
        ],
    ),
    (
        key::without_mouse(),
        &[
            [key::f6_shift_tab(), key::f6_shift_tab_about()],
            [key::arrow_keys_dot(), key::arrow_keys_dot_about()],
            [key::arrow_keys_picture(), key::arrow_keys_picture_about()],
            [key::space_enter(), key::space_enter_about()],
        ],
    ),
];

/// Shows the list.
pub fn show(ui: &mut Ui) {
    let weak = Palette::of(ui.visuals()).weak;
    scroll_beyond(ui, BESIDES, |ui| {
        let width = ui.available_width() - SCROLL_BAR;
        for (group, rows) in GROUPS {
            ui.add_space(8.0);
            ui.label(RichText::new(tr(group)).font(bold(13.0)));
            for [key, meaning] in rows {
                ui.horizontal_top(|ui| {
                    words(ui, KEYS_SHARE * width, RichText::new(tr(*key)));
                    words(ui, ui.available_width() - SCROLL_BAR, RichText::new(tr(*meaning)).color(weak));
                });
            }
        }
    });
}

/// A cell of this width, as high as its text.
fn words(ui: &mut Ui, width: f32, text: RichText) {
    let left_aligned = Layout::top_down(Align::Min);
    ui.allocate_ui_with_layout(vec2(width, 0.0), left_aligned, |ui| {
        ui.set_min_width(width);
        ui.add(Label::new(text).wrap());
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_that_the_app_answers_to_is_listed() {
        let listed: Vec<Words> = GROUPS.iter().flat_map(|(_, rows)| rows.iter().map(|[keys, _]| *keys)).collect();
        for key in [
            "Tab",
            "P",
            "Space",
            "F",
            "Ctrl+Z",
            "Ctrl+Shift+Z",
            "Ctrl+Y",
            "Ctrl+S",
            "Ctrl+E",
            "Ctrl+V",
            "D",
            "L",
            "C",
            "E",
            "N",
            "Shift+N",
            "Enter",
            "Backspace",
            "Delete",
            "Escape",
            "F6",
            "Shift+Tab",
        ] {
            let is_named =
                |keys: &Words| keys.english().split(", ").flat_map(|keys| keys.split(" or ")).any(|name| name == key);
            assert!(listed.iter().any(is_named), "{key} is not among {listed:?}");
        }
    }
}
