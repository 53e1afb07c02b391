//! A window in the middle of the screen, as wide as its content and the screen allow, with a close button below.

use crate::app::menus::figures_menu;
use crate::app::theme::widgets::{close_button, give_keyboard};
use crate::app::windows::explore::{gallery, shortcuts};
use crate::language::{key, tr};
use egui::{Align2, Context, Key, Pos2, Ui};

/// The height above and below a window's content together, in points: title, button, margins.
pub const BESIDES: f32 = 140.0;
/// The free width left and right of a window together, in points.
const MARGINS: f32 = 40.0;

/// The kinds of windows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Window {
    Gallery,
    Figures,
    Shortcuts,
}

impl Window {
    fn title(self) -> &'static str {
        tr(match self {
            Self::Gallery => key::gallery(),
            Self::Figures => key::paper_figures(),
            Self::Shortcuts => key::keys_and_gestures(),
        })
    }

    fn width(self, most: f32) -> f32 {
        match self {
            Self::Gallery => gallery::width(most),
            Self::Figures => figures_menu::WIDTH.min(most),
            Self::Shortcuts => shortcuts::WIDTH.min(most),
        }
    }

    /// The name in the record of the screen (`stats`), in English.
    pub fn name(self) -> &'static str {
        let name = match self {
            Self::Gallery => key::gallery(),
            Self::Figures => key::figures(),
            Self::Shortcuts => key::keys(),
        };
        name.english()
    }

    /// Shows the window around `content`, which may close it. Returns the center of the close button; `None` once the
    /// window is closed. With `takes_focus` the close button gets the keyboard focus.
    pub fn show(self, context: &Context, takes_focus: bool, content: impl FnOnce(&mut Ui)) -> Option<Pos2> {
        let screen = context.content_rect();
        let mut stays = true;
        let mut closed = context.input(|input| input.key_pressed(Key::Escape));
        let window = egui::Window::new(self.title())
            .id(egui::Id::unique(("explore", self as usize)))
            .open(&mut stays)
            .collapsible(false)
            .resizable(false)
            .pivot(Align2::CENTER_CENTER)
            .fixed_pos(screen.center())
            .show(context, |ui| {
                ui.set_width(self.width(screen.width() - MARGINS));
                content(ui);
                ui.add_space(4.0);
                let close = close_button(ui);
                if takes_focus {
                    give_keyboard(&close, tr(key::close()));
                }
                closed |= close.clicked();
                close.rect.center()
            });
        window?.inner.filter(|_| stays && !closed)
    }
}
