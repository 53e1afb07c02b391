//! The gallery: maps worth seeing, each with a small picture and a line about it.

use super::thumbnail::{self, SIZE};
use crate::app::PHONE_WIDTH;
use crate::app::action::{Action, Actions};
use crate::app::language::tr;
use crate::app::theme::{Palette, ROUNDING, bold};
use crate::conformal::Direction;
use crate::outline::Preset;
use crate::session::{Colouring, Command, Comparison, OutlineSpec, Session, SurfaceShape, SurfaceSpec, TextureKind};
use crate::surface::SurfacePreset;
use egui::{
    Color32, Context, CornerRadius, Key, Rect, Response, Role, ScrollArea, Sense, TextStyle, TextureHandle,
    TextureOptions, Ui, WidgetInfo, Window, pos2, vec2,
};

/// One picture.
pub struct Piece {
    /// What it is called.
    pub title: &'static str,
    /// What there is to see.
    pub caption: &'static str,
    /// The map.
    pub session: Session,
}

/// All of them, from easy to hard, then the surfaces.
pub fn pieces() -> Vec<Piece> {
    let piece = |title, caption, session| Piece { title, caption, session };
    vec![
        piece("Gingerbread heart", "Every limb finds its place", planar(Preset::Gingerbread, Preset::Heart)),
        piece("Square the circle", "Four corners, smoothed away", planar(Preset::Square, Preset::Disk)),
        piece(
            "Polar star",
            "Circles of Green's function, rays of equal chance",
            Session { texture: TextureKind::Conformal, ..planar(Preset::Disk, Preset::Star) },
        ),
        piece(
            "Around the corner",
            "One re-entrant corner: the textbook singularity",
            planar(Preset::LShape, Preset::Disk),
        ),
        piece("Leaf to flower", "Sharp tips into sharp cusps", planar(Preset::MapleLeaf, Preset::Cinquefoil)),
        piece("A hand in a blob", "Five fingers, each a crowded channel", planar(Preset::Hand, Preset::Blob)),
        piece(
            "Unwound",
            "A long corridor: almost all of it is one boundary point of the disk",
            Session { texture: TextureKind::Grid, ..planar(Preset::Spiral, Preset::Disk) },
        ),
        piece("Crowding", "What a way through the disk loses, and the direct one keeps", crowding()),
        piece(
            "A globe, flattened",
            "Half a sphere over the disk: stereographic projection",
            solid(SurfacePreset::Hemisphere, Preset::Disk),
        ),
        piece("Saddle", "Negative curvature over a square", solid(SurfacePreset::Saddle, Preset::Square)),
        piece("Half a torus", "A bent tube, opened", solid(SurfacePreset::HalfTorus, Preset::Square)),
        piece(
            "Animal over a heart",
            "A head's texture, in any outline you like",
            solid(SurfacePreset::AnimalHead, Preset::Heart),
        ),
    ]
}

fn planar(source: Preset, target: Preset) -> Session {
    let mut session = Session { direction: Direction::Backward, ..Session::default() };
    session.source.outline = OutlineSpec::Preset(source);
    session.target.outline = OutlineSpec::Preset(target);
    session
}

fn solid(surface: SurfacePreset, outline: Preset) -> Session {
    let mut session = Session::default();
    session.source.outline = OutlineSpec::Preset(outline);
    session.apply(Command::SetSurface(SurfaceSpec { shape: SurfaceShape::preset(surface), ..SurfaceSpec::default() }));
    session
}

/// The V over the blob, with the way through the disk beside it (the paper's Figure 12).
pub fn crowding() -> Session {
    Session {
        comparison: Comparison::Precomputed,
        colouring: Colouring::Texture,
        ..planar(Preset::VShape, Preset::Blob)
    }
}

/// A picture with its two lines of words.
const CARD: egui::Vec2 = vec2(SIZE[0] as f32 + 16.0, SIZE[1] as f32 + 82.0);

/// Between them, in points.
const GAP: f32 = 8.0;
/// The share of the window that they may take.
const HEIGHT: f32 = 0.75;

/// Shows the gallery while `open`; one picture is made in a frame.
pub fn show(
    context: &Context,
    open: &mut bool,
    made: &mut Vec<Option<TextureHandle>>,
    takes_focus: bool,
    actions: &mut Actions,
) {
    if !*open {
        return;
    }
    let pieces = pieces();
    if let Some(next) = pieces.get(made.len()) {
        let picture = thumbnail::of(&next.session);
        made.push(picture.map(|picture| context.load_texture(next.title, picture, TextureOptions::LINEAR)));
        context.request_repaint();
    }
    let screen = context.content_rect();
    let columns = if screen.width() < PHONE_WIDTH { 1 } else { 3 };
    let (mut chosen, mut closed) = (None, context.input(|input| input.key_pressed(Key::Escape)));
    Window::new(tr("Gallery"))
        .open(open)
        .collapsible(false)
        .resizable(false)
        .pivot(egui::Align2::CENTER_CENTER)
        .fixed_pos(screen.center())
        .default_width(columns as f32 * (CARD.x + GAP))
        .show(context, |ui| {
            let height = HEIGHT * screen.height();
            ui.spacing_mut().item_spacing = vec2(GAP, GAP);
            ScrollArea::vertical().max_height(height).min_scrolled_height(height).show(ui, |ui| {
                for (row, cards) in pieces.chunks(columns).enumerate() {
                    ui.horizontal(|ui| {
                        for (k, piece) in cards.iter().enumerate() {
                            let picture = made.get(row * columns + k).and_then(Option::as_ref);
                            let card = card(ui, piece, picture);
                            if takes_focus && row + k == 0 {
                                card.request_focus();
                            }
                            if card.clicked() {
                                chosen = Some(piece.session.clone());
                            }
                        }
                    });
                }
            });
            closed |= ui.button(tr("Close")).clicked();
        });
    *open &= !closed;
    if let Some(session) = chosen {
        *open = false;
        actions.push(Action::Session(Command::Open(Box::new(session))));
    }
}

fn card(ui: &mut Ui, piece: &Piece, picture: Option<&TextureHandle>) -> Response {
    let palette = Palette::of(ui.visuals());
    let (rect, response) = ui.allocate_exact_size(CARD, Sense::click());
    let (title, caption) = (tr(piece.title), tr(piece.caption));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, format!("{title}: {caption}")));
    let fill = if response.hovered() || response.has_focus() { palette.control_hovered } else { palette.control };
    ui.painter().rect_filled(rect, CornerRadius::same(ROUNDING), fill);
    let frame = Rect::from_min_size(rect.min + vec2(8.0, 8.0), vec2(SIZE[0] as f32, SIZE[1] as f32));
    if let Some(picture) = picture {
        let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        ui.painter().image(picture.id(), frame, whole, Color32::WHITE);
    }
    let words = |text: &str, font, colour| ui.painter().layout(text.to_owned(), font, colour, frame.width());
    let title = words(title, bold(13.0), palette.text);
    let below = frame.left_bottom() + vec2(0.0, 6.0);
    let caption_at = below + vec2(0.0, title.size().y + 2.0);
    ui.painter().galley(below, title, palette.text);
    ui.painter().galley(caption_at, words(caption, TextStyle::Small.resolve(ui.style()), palette.weak), palette.weak);
    response
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn every_picture_can_be_made_and_none_is_like_another() {
        let all: Vec<_> = pieces().iter().map(|piece| thumbnail::of(&piece.session).unwrap()).collect();
        for (k, picture) in all.iter().enumerate() {
            assert!(all[..k].iter().all(|other| other.pixels != picture.pixels), "{}", pieces()[k].title);
        }
    }

    #[test]
    fn every_picture_has_words_of_its_own() {
        let words: std::collections::HashSet<_> = pieces().iter().map(|piece| (piece.title, piece.caption)).collect();
        assert_eq!(words.len(), pieces().len());
    }
}
