//! What keys, mouse and fingers do.

use crate::app::language::tr;
use crate::app::theme::Palette;
use egui::{Context, Grid, Key, RichText, ScrollArea, Window};

/// Each with what it does, in groups.
const GROUPS: [(&str, &[[&str; 2]]); 3] = [
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
            ["Ctrl+Z, Ctrl+Shift+Z", "Takes a step back, or makes it again"],
            ["Ctrl+S", "Saves the session as a file"],
            ["Ctrl+E", "Opens the window that saves pictures, animations and other files"],
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

/// Shows the list while `open`.
pub fn show(context: &Context, open: &mut bool, takes_focus: bool) {
    if !*open {
        return;
    }
    let mut closed = context.input(|input| input.key_pressed(Key::Escape));
    let screen = context.content_rect();
    Window::new(tr("Keys and gestures"))
        .open(open)
        .collapsible(false)
        .resizable(false)
        .pivot(egui::Align2::CENTER_CENTER)
        .fixed_pos(screen.center())
        .show(context, |ui| {
            let weak = Palette::of(ui.visuals()).weak;
            let width = (screen.width() - 60.0).min(620.0);
            ui.set_max_width(width);
            ScrollArea::vertical().max_height(0.75 * screen.height()).show(ui, |ui| {
                for (group, rows) in GROUPS {
                    ui.add_space(6.0);
                    ui.label(RichText::new(tr(group)).strong());
                    Grid::new(group).num_columns(2).spacing([16.0, 6.0]).max_col_width(0.6 * width).show(ui, |ui| {
                        for [key, meaning] in rows {
                            ui.label(tr(key));
                            ui.add(egui::Label::new(RichText::new(tr(meaning)).color(weak)).wrap());
                            ui.end_row();
                        }
                    });
                }
            });
            let close = ui.button(tr("Close"));
            if takes_focus {
                close.request_focus();
            }
            closed |= close.clicked();
        });
    *open &= !closed;
}
