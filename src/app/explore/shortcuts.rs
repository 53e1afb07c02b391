//! What keys, mouse and fingers do.

use super::window::BESIDES;
use crate::app::language::tr;
use crate::app::room::scroll_beyond;
use crate::app::theme::{Palette, bold};
use egui::{Align, Label, Layout, RichText, Ui, vec2};

/// How wide the list is where there is room.
pub const WIDTH: f32 = 660.0;
/// What of it the keys take.
const KEYS_SHARE: f32 = 0.32;
/// Room for the scroll bar beside it.
const SCROLL_BAR: f32 = 8.0;

/// Each with what it does, in groups.
const GROUPS: [(&str, &[[&str; 2]]); 4] = [
    (
        "Mouse and fingers",
        &[
            ["Drag a dot", "Moves what the map is held by; the map follows"],
            ["Drag beside the dots", "Moves the picture; a surface is turned, with Shift moved"],
            ["Wheel, or two fingers", "Zooms; two fingers also move"],
            ["Double-click", "Shows all of it again"],
            ["Drop a file", "Opens an outline, a surface, an image or a session"],
        ],
    ),
    (
        "Keys",
        &[
            ["Tab", "Folds the panels away, or brings them back"],
            ["P", "Opens and closes the plots"],
            ["Space", "Sets the points in motion, or stops them where they are"],
            ["F", "Fills the screen, or gives it back"],
            ["Ctrl+Z", "Takes a step back"],
            ["Ctrl+Shift+Z or Ctrl+Y", "Makes it again"],
            ["Ctrl+S", "Saves the session as a file"],
            ["Ctrl+E", "Opens the window that saves pictures, animations and other files"],
        ],
    ),
    (
        "Drawing and reshaping",
        &[
            ["D, L, C", "Draws an outline: freehand, with straight edges, as a curve; for the side under the pointer"],
            ["Enter, Backspace", "Closes what is drawn; takes its last point back"],
            ["E", "Reshapes the outline under the pointer by its handles, or ends that"],
            ["Double-click on the outline", "Sets another handle; a right click or a long press takes one away"],
            ["N, Shift+N", "Go to the next handle, to the one before"],
            ["Arrow keys, Delete", "Move the chosen handle, with Shift finely; take it away"],
            ["Escape", "Ends drawing and reshaping, and closes windows"],
            ["Ctrl+V", "Takes an outline from the clipboard: path data, coordinates, GeoJSON"],
        ],
    ),
    (
        "Without a mouse",
        &[
            ["F6 or Shift+Tab", "Begins to walk through controls, pictures and dots; Tab goes on, Escape ends"],
            ["Arrow keys on a dot", "Move it; with Shift finely. A magenta dot goes along its boundary"],
            ["Arrow keys on a picture", "Move it, or turn the surface; + and − zoom, 0 shows all of it"],
            ["Space or Enter", "Presses a button"],
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
                    words(ui, KEYS_SHARE * width, RichText::new(tr(key)));
                    words(ui, ui.available_width() - SCROLL_BAR, RichText::new(tr(meaning)).color(weak));
                });
            }
        }
    });
}

/// A column of a row, as high as its words.
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
        let listed: Vec<&str> = GROUPS.iter().flat_map(|(_, rows)| rows.iter().map(|[keys, _]| *keys)).collect();
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
            let is_named = |keys: &&str| keys.split(", ").flat_map(|keys| keys.split(" or ")).any(|name| name == key);
            assert!(listed.iter().any(is_named), "{key} is not among {listed:?}");
        }
    }
}
