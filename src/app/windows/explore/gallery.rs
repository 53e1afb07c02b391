//! The gallery: example maps, each with a thumbnail and a caption.

use crate::app::input::action::{Action, Actions};
use crate::app::theme::text_metrics::scroll_beyond;
use crate::app::theme::widgets::give_keyboard;
use crate::app::theme::{Palette, ROUNDING, bold};
use crate::app::windows::explore::thumbnail;
use crate::app::windows::explore::thumbnail::SIZE;
use crate::app::windows::explore::window::BESIDES;
use crate::conformal::{Direction, Side};
use crate::geometry::DVec2;
use crate::language::{Label, key, tr};
use crate::outline::Preset;
use crate::session::{Colouring, Command, Comparison, OutlineSpec, Session, SurfaceShape, SurfaceSpec, TextureKind};
use crate::surface::SurfacePreset;
use egui::{
    Color32, CornerRadius, Rect, Response, Role, Sense, Stroke, StrokeKind, TextStyle, TextureHandle, TextureOptions,
    Ui, Vec2, WidgetInfo, pos2, vec2,
};
use std::sync::LazyLock;

/// An entry of the gallery.
pub struct Piece {
    pub title: Label,
    /// A line about what there is to see.
    pub caption: Label,
    /// The session with the map.
    pub session: Session,
}

impl Piece {
    /// Title and caption, for screen readers.
    fn said(&self) -> String {
        format!("{}: {}", tr(self.title), tr(self.caption))
    }
}

/// All entries, from easy to hard, then the surfaces; built once.
pub fn pieces() -> &'static [Piece] {
    static PIECES: LazyLock<Vec<Piece>> = LazyLock::new(make_pieces);
    &PIECES
}

fn make_pieces() -> Vec<Piece> {
    let piece = |title, caption, session| Piece { title, caption, session };
    vec![
        piece(key::gingerbread_heart(), key::gingerbread_heart_about(), planar(Preset::Gingerbread, Preset::Heart)),
        piece(key::square_circle(), key::square_circle_about(), planar(Preset::Square, Preset::Disk)),
        piece(
            key::polar_star(),
            key::polar_star_about(),
            planar(Preset::Disk, Preset::Star).and([Command::SetTexture(TextureKind::Conformal)]),
        ),
        piece(
            key::hyperbolic_tiles(),
            key::hyperbolic_tiles_about(),
            planar(Preset::Disk, Preset::Cinquefoil).and([Command::SetTexture(TextureKind::Tiling)]),
        ),
        piece(key::around_corner(), key::around_corner_about(), planar(Preset::LShape, Preset::Disk)),
        piece(key::leaf_flower(), key::leaf_flower_about(), planar(Preset::MapleLeaf, Preset::Cinquefoil)),
        piece(key::hand_blob(), key::hand_blob_about(), planar(Preset::Hand, Preset::Blob)),
        piece(
            key::unwound(),
            key::unwound_about(),
            planar(Preset::Spiral, Preset::Disk).and([Command::SetTexture(TextureKind::Grid)]),
        ),
        piece(key::crowding(), key::gallery_crowding_about(), crowding()),
        piece(key::globe_flattened(), key::globe_flattened_about(), solid(SurfacePreset::Hemisphere, Preset::Disk)),
        piece(key::saddle(), key::saddle_about(), solid(SurfacePreset::Saddle, Preset::Square)),
        piece(
            key::gallery_half_torus(),
            key::gallery_half_torus_about(),
            solid(SurfacePreset::HalfTorus, Preset::Square),
        ),
        piece(
            key::animal_over_heart(),
            key::animal_over_heart_about(),
            solid(SurfacePreset::AnimalHead, Preset::Heart),
        ),
    ]
}

fn planar(source: Preset, target: Preset) -> Session {
    Session::with([
        Command::SetDirection(Direction::Backward),
        Command::SetOutline { side: Side::Source, outline: OutlineSpec::Preset(source) },
        Command::SetOutline { side: Side::Target, outline: OutlineSpec::Preset(target) },
    ])
}

fn solid(surface: SurfacePreset, outline: Preset) -> Session {
    let surface = SurfaceSpec { shape: SurfaceShape::preset(surface), ..SurfaceSpec::default() };
    Session::with([
        Command::SetOutline { side: Side::Source, outline: OutlineSpec::Preset(outline) },
        Command::SetSurface { side: Side::Target, surface },
    ])
}

/// In the right arm of the V-shape, far from the point about which its disk map is computed before the constraints are
/// known.
const IN_THE_OTHER_ARM: DVec2 = DVec2::new(0.93, 0.75);

/// The V-shape and the blob, compared with the map through the disk (the paper's Figure 12): with x₁ in the other arm,
/// all steps along the V come to one point of the blob.
pub fn crowding() -> Session {
    planar(Preset::VShape, Preset::Blob).and([
        Command::SetDirection(Direction::Forward),
        Command::MoveInterior { side: Side::Source, point: IN_THE_OTHER_ARM.into() },
        Command::SetComparison(Comparison::Precomputed),
        Command::SetColouring(Colouring::Texture),
    ])
}

/// Free space around a thumbnail, in points.
const PADDING: f32 = 8.0;
/// The size of an entry with the text below the thumbnail.
const CARD: Vec2 = vec2(SIZE[0] as f32 + 2.0 * PADDING, SIZE[1] as f32 + 82.0);
/// The size of an entry with the text beside the thumbnail: where there is room for one column only.
const ROW: Vec2 = vec2(420.0, SIZE[1] as f32 + 2.0 * PADDING);

/// The gap between entries, in points.
const GAP: f32 = 8.0;
const MOST_COLUMNS: f32 = 3.0;

fn columns(most: f32) -> f32 {
    ((most + GAP) / (CARD.x + GAP)).floor().min(MOST_COLUMNS)
}

/// The width of the gallery where at most `most` points are available.
pub fn width(most: f32) -> f32 {
    let columns = columns(most);
    if columns < 2.0 { ROW.x.min(most) } else { columns * (CARD.x + GAP) - GAP }
}

/// Shows the gallery; renders one missing thumbnail per frame into `made`. Choosing an entry closes the gallery. With
/// `takes_focus` the first entry gets the keyboard focus.
pub fn show(ui: &mut Ui, made: &mut Vec<Option<TextureHandle>>, takes_focus: bool, actions: &mut Actions) {
    let pieces = pieces();
    if let Some(next) = pieces.get(made.len()) {
        let picture = thumbnail::of(&next.session);
        made.push(picture.map(|picture| ui.ctx().load_texture(next.title.english(), picture, TextureOptions::LINEAR)));
        ui.request_repaint();
    }
    ui.spacing_mut().item_spacing = vec2(GAP, GAP);
    let width = ui.available_width();
    let columns = columns(width);
    let size = if columns < 2.0 { vec2(width, ROW.y) } else { CARD };
    scroll_beyond(ui, BESIDES, |ui| {
        ui.horizontal_wrapped(|ui| {
            for (k, piece) in pieces.iter().enumerate() {
                let card = card(ui, piece, made.get(k).and_then(Option::as_ref), size);
                if takes_focus && k == 0 {
                    give_keyboard(&card, &piece.said());
                }
                if card.clicked() {
                    actions.push(Action::Session(Command::Open(Box::new(piece.session.clone()))));
                    ui.close();
                }
            }
        });
    });
}

fn card(ui: &mut Ui, piece: &Piece, picture: Option<&TextureHandle>, size: Vec2) -> Response {
    let palette = Palette::of(ui.visuals());
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let (title, caption) = (tr(piece.title), tr(piece.caption));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, piece.said()));
    let fill = if response.hovered() || response.has_focus() { palette.control_hovered } else { palette.control };
    let edge = Stroke::new(1.0, palette.border);
    ui.painter().rect(rect, CornerRadius::same(ROUNDING), fill, edge, StrokeKind::Inside);
    let frame = Rect::from_min_size(rect.min + Vec2::splat(PADDING), vec2(SIZE[0] as f32, SIZE[1] as f32));
    if let Some(picture) = picture {
        let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        ui.painter().image(picture.id(), frame, whole, Color32::WHITE);
    }
    let is_beside = size.y < CARD.y;
    let place = if is_beside { frame.right_top() + vec2(PADDING, 2.0) } else { frame.left_bottom() + vec2(0.0, 6.0) };
    let width = rect.right() - PADDING - place.x;
    let words = |text: &str, font, colour| ui.painter().layout(text.to_owned(), font, colour, width);
    let title = words(title, bold(13.0), palette.text);
    let below = place + vec2(0.0, title.size().y + 2.0);
    ui.painter().galley(place, title, palette.text);
    ui.painter().galley(below, words(caption, TextStyle::Small.resolve(ui.style()), palette.weak), palette.weak);
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
            assert!(all[..k].iter().all(|other| other.pixels != picture.pixels), "{}", pieces()[k].title.english());
        }
    }

    #[test]
    fn every_picture_has_words_of_its_own() {
        let words: std::collections::HashSet<_> = pieces().iter().map(|piece| (piece.title, piece.caption)).collect();
        assert_eq!(words.len(), pieces().len());
    }
}
