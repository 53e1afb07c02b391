//! The window that shares the session: its link as a QR code, to copy, and in the system's own dialog where there is one.
//!
//! The link is made anew whenever the session on the screen changes. The code has 8-bit data and the lowest level of
//! error correction, which holds [`MOST_BYTES`] bytes (ISO/IEC 18004, version 40-L); a longer link says so.

use crate::app::input::action::{Action, Actions, ShareAction};
use crate::app::theme::widgets::close_button;
use crate::app::theme::{Palette, ROW_HEIGHT, control_height};
use crate::language::{Message, key, say, tr};
use crate::platform;
use crate::session::Session;
use egui::{
    Align2, Button, Color32, ColorImage, Context, Image, Key, Label, Modifiers, RichText, TextureHandle,
    TextureOptions, Ui, vec2,
};
use qrcodegen::{QrCode, QrCodeEcc};

/// The most bytes that a QR code holds.
const MOST_BYTES: usize = 2953;
/// The light modules around a code that scanners need.
const QUIET: i32 = 4;
/// The largest width of a code, in points, and the least height of the screen around it.
const WIDEST: f32 = 360.0;
const AROUND_CODE: f32 = 260.0;
const LEAST_CODE: f32 = 120.0;

/// The link of a session.
#[derive(Debug, Clone)]
pub struct SharedLink {
    /// The address that opens it.
    pub address: String,
    /// What the link does not contain.
    pub lacks: Option<Message>,
}

/// The window; closed by default.
#[derive(Default)]
pub struct Share {
    is_open: bool,
    shown: Option<Shown>,
}

struct Shown {
    /// The session that the link is of.
    session: Session,
    link: Result<SharedLink, Message>,
    code: Option<Code>,
}

struct Code {
    texture: TextureHandle,
    /// Modules along an edge, with the quiet zone.
    modules: usize,
}

impl Share {
    /// Opens or closes the window.
    pub fn set_open(&mut self, open: bool) {
        (self.is_open, self.shown) = (open, None);
    }

    /// Whether the window is open and has no link of this session yet.
    pub fn needs(&self, session: &Session) -> bool {
        self.is_open && self.shown.as_ref().is_none_or(|shown| shown.session != *session)
    }

    /// Takes the link of a session.
    pub fn renew(&mut self, context: &Context, session: Session, link: Result<SharedLink, Message>) {
        let code = link.as_ref().ok().and_then(|link| code_of(context, &link.address));
        self.shown = Some(Shown { session, link, code });
    }

    /// The address that is shown.
    pub fn address(&self) -> Option<&str> {
        Some(&self.shown.as_ref()?.link.as_ref().ok()?.address)
    }

    /// The modules along an edge of the code that is shown.
    pub fn modules(&self) -> Option<usize> {
        self.shown.as_ref()?.code.as_ref().map(|code| code.modules)
    }

    /// Draws the window if it is open.
    pub fn show(&self, context: &Context, actions: &mut Actions) {
        let Some(shown) = self.shown.as_ref().filter(|_| self.is_open) else { return };
        let screen = context.content_rect();
        let mut stays = !context.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape));
        let window = egui::Window::new(tr(key::share()))
            .id(egui::Id::unique("share"))
            .open(&mut stays)
            .collapsible(false)
            .resizable(false)
            .pivot(Align2::CENTER_CENTER)
            .fixed_pos(screen.center());
        window.show(context, |ui| content(ui, shown, actions));
        if !stays {
            actions.push(Action::Share(ShareAction::Close));
        }
    }
}

/// The code of a text as a texture; `None` if the text is too long.
fn code_of(context: &Context, text: &str) -> Option<Code> {
    let code = QrCode::encode_text(text, QrCodeEcc::Low).ok()?;
    let modules = (code.size() + 2 * QUIET) as usize;
    let places = (0..modules * modules).map(|k| ((k % modules) as i32 - QUIET, (k / modules) as i32 - QUIET));
    let pixels = places.map(|(x, y)| if code.get_module(x, y) { Color32::BLACK } else { Color32::WHITE }).collect();
    let image = ColorImage::new([modules, modules], pixels);
    Some(Code { texture: context.load_texture("qr", image, TextureOptions::NEAREST), modules })
}

fn content(ui: &mut Ui, shown: &Shown, actions: &mut Actions) {
    let screen = ui.ctx().content_rect();
    let side = (screen.height() - AROUND_CODE).min(screen.width() - 60.0).clamp(LEAST_CODE, WIDEST);
    ui.set_width(side.max(WIDEST.min(screen.width() - 60.0)));
    let weak = Palette::of(ui.visuals()).weak;
    let note = |ui: &mut Ui, text: String| ui.add(Label::new(RichText::new(text).small().color(weak)).wrap());
    match &shown.link {
        Err(reason) => {
            note(ui, say(reason));
        }
        Ok(link) => {
            match &shown.code {
                Some(code) => {
                    // whole pixels per module, so that all have the same size
                    let scale = ui.pixels_per_point();
                    let pixels = (side * scale / code.modules as f32).floor().max(1.0);
                    let side = pixels * code.modules as f32 / scale;
                    let image = Image::new((code.texture.id(), vec2(side, side))).alt_text(tr(key::qr_code()));
                    ui.vertical_centered(|ui| ui.add(image));
                    note(ui, tr(key::scan_code()).into());
                }
                None => {
                    note(ui, say(&key::link_too_long_for_code(link.address.len(), MOST_BYTES)));
                }
            }
            if let Some(lacks) = &link.lacks {
                note(ui, say(&key::link_lacks(lacks.clone())));
            }
            ui.add(Label::new(RichText::new(&link.address).small().color(weak)).truncate());
        }
    }
    ui.add_space(6.0);
    ui.horizontal_wrapped(|ui| buttons(ui, shown.link.is_ok(), actions));
}

fn buttons(ui: &mut Ui, has_link: bool, actions: &mut Actions) {
    let palette = Palette::of(ui.visuals());
    let height = control_height(ui, ROW_HEIGHT);
    let mut ways = vec![(key::copy_link(), Action::CopyLink)];
    if platform::can_share() {
        ways.insert(0, (key::share_by_system(), Action::Share(ShareAction::Send)));
    }
    for (k, (label, action)) in ways.into_iter().enumerate() {
        let text = RichText::new(tr(label));
        let button = match k {
            0 => Button::new(text.color(palette.on_accent)).fill(palette.accent),
            _ => Button::new(text),
        };
        if ui.add_enabled(has_link, button.min_size(vec2(0.0, height))).clicked() {
            actions.push(action);
        }
    }
    if close_button(ui).clicked() {
        actions.push(Action::Share(ShareAction::Close));
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn a_code_holds_what_the_standard_allows_and_not_a_byte_more() {
        let context = Context::default();
        let text = |length: usize| "a".repeat(length);
        assert_eq!(code_of(&context, &text(MOST_BYTES)).unwrap().modules, 177 + 8);
        assert!(code_of(&context, &text(MOST_BYTES + 1)).is_none());
        assert_eq!(code_of(&context, "https://example.org/#s=1").unwrap().modules, 25 + 8, "version 2");
    }
}
