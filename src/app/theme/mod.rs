//! The theme: two palettes (dark slate, light), fonts, spacing, rounding, text sizes.
//!
//! Widgets take their colors from egui's visuals, which are set from the
//! [`Palette`] here; custom painting takes them from [`Palette::of`].

pub mod explained;
pub mod icons;
pub mod number_field;
pub mod text_metrics;
pub mod widgets;

use egui::{
    Color32, CornerRadius, FontData, FontDefinitions, FontFamily, FontId, Margin, Stroke, Style, TextStyle, Theme,
    Visuals,
};
use std::sync::Arc;

/// Below this width (in points) the controls become a sheet.
pub const PHONE_WIDTH: f32 = 700.0;
/// The height of buttons, segmented switches and rows.
pub const ROW_HEIGHT: f32 = 28.0;
/// The same height on touch screens, in points: a fingertip is 10 mm wide.
pub const FINGER_HEIGHT: f32 = 40.0;
/// The rounding of buttons and switches.
pub const ROUNDING: u8 = 6;

const REGULAR: &str = "Inter";
const SEMIBOLD: &str = "Inter SemiBold";
const TABULAR: &str = "Inter Tabular";
const REGULAR_FILE: &[u8] = include_bytes!("../fonts/Inter-Regular.otf");
const SEMIBOLD_FILE: &[u8] = include_bytes!("../fonts/Inter-SemiBold.otf");
const TABULAR_FILE: &[u8] = include_bytes!("../fonts/Inter-Tabular.otf");

/// The color of interior dots: Okabe–Ito's bluish green, a little lighter for the dark theme.
pub const INTERIOR_COLOUR: Color32 = Color32::from_rgb(22, 173, 121);
/// The color of boundary dots.
pub const BOUNDARY_COLOUR: Color32 = Color32::from_rgb(214, 58, 158);

/// The colors of a theme.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Palette {
    /// The background of the meshes.
    pub canvas: Color32,
    /// The background of panels and bars.
    pub panel: Color32,
    /// The background of menus, windows and tooltips.
    pub raised: Color32,
    /// The background of buttons and switches.
    pub control: Color32,
    /// The background of a button under the pointer.
    pub control_hovered: Color32,
    /// The edges of panels and controls.
    pub border: Color32,
    /// Text.
    pub text: Color32,
    /// Secondary text.
    pub weak: Color32,
    /// The background of selected controls and primary buttons.
    pub accent: Color32,
    /// The filled part of sliders, progress bars, focus rings, links.
    pub accent_soft: Color32,
    /// Text on `accent`.
    pub on_accent: Color32,
    /// The background of error messages.
    pub error_ground: Color32,
    /// The edge of error messages, and error text.
    pub error_edge: Color32,
}

const DARK: Palette = Palette {
    canvas: Color32::from_rgb(13, 17, 23),
    panel: Color32::from_rgb(22, 27, 34),
    raised: Color32::from_rgb(28, 34, 43),
    control: Color32::from_rgb(33, 38, 45),
    control_hovered: Color32::from_rgb(45, 52, 61),
    border: Color32::from_rgb(48, 54, 61),
    text: Color32::from_rgb(230, 237, 243),
    weak: Color32::from_rgb(148, 157, 168),
    accent: Color32::from_rgb(31, 111, 235),
    accent_soft: Color32::from_rgb(88, 166, 255),
    on_accent: Color32::WHITE,
    error_ground: Color32::from_rgb(61, 24, 28),
    error_edge: Color32::from_rgb(248, 81, 73),
};

const LIGHT: Palette = Palette {
    canvas: Color32::from_rgb(255, 255, 255),
    panel: Color32::from_rgb(246, 248, 250),
    raised: Color32::from_rgb(255, 255, 255),
    control: Color32::from_rgb(255, 255, 255),
    control_hovered: Color32::from_rgb(234, 238, 242),
    border: Color32::from_rgb(208, 215, 222),
    text: Color32::from_rgb(31, 35, 40),
    weak: Color32::from_rgb(89, 99, 110),
    accent: Color32::from_rgb(9, 105, 218),
    accent_soft: Color32::from_rgb(9, 105, 218),
    on_accent: Color32::WHITE,
    error_ground: Color32::from_rgb(255, 235, 233),
    error_edge: Color32::from_rgb(207, 34, 46),
};

impl Palette {
    /// The palette that goes with `visuals`.
    pub fn of(visuals: &Visuals) -> Self {
        if visuals.dark_mode { DARK } else { LIGHT }
    }
}

/// The semibold font, for titles.
pub fn bold(size: f32) -> FontId {
    FontId::new(size, FontFamily::Name(SEMIBOLD.into()))
}

/// Inter only, without egui's default fonts, which would be a quarter of the download; `fonts/` has every
/// character that the app writes (tested).
fn fonts() -> FontDefinitions {
    let mut fonts = FontDefinitions::empty();
    for (name, bytes) in [(REGULAR, REGULAR_FILE), (SEMIBOLD, SEMIBOLD_FILE), (TABULAR, TABULAR_FILE)] {
        fonts.font_data.insert(String::from(name), Arc::new(FontData::from_static(bytes)));
    }
    // The monospaced family is used for numbers in columns only, which need digits of equal width.
    for (family, names) in [
        (FontFamily::Proportional, &[REGULAR][..]),
        (FontFamily::Monospace, &[TABULAR, REGULAR]),
        (FontFamily::Name(SEMIBOLD.into()), &[SEMIBOLD, REGULAR]),
    ] {
        fonts.families.insert(family, names.iter().copied().map(String::from).collect());
    }
    fonts
}

/// Sets up fonts and both themes.
pub fn install(context: &egui::Context) {
    context.set_fonts(fonts());
    context.set_style_of(Theme::Dark, style(&DARK, Visuals::dark()));
    context.set_style_of(Theme::Light, style(&LIGHT, Visuals::light()));
}

/// Lets everything that would move by itself be at its end at once.
pub fn end_animations(context: &egui::Context) {
    context.all_styles_mut(|style| style.animation_time = 0.0);
}

/// Whether things may move by themselves.
pub fn is_animated(ui: &egui::Ui) -> bool {
    ui.style().animation_time > 0.0
}

/// Sets the row height for touch or for a mouse.
pub fn suit_pointer(context: &egui::Context, fingers: bool) {
    let height = if fingers { FINGER_HEIGHT } else { ROW_HEIGHT };
    if context.global_style().spacing.interact_size.y != height {
        context.all_styles_mut(|style| style.spacing.interact_size.y = height);
    }
}

/// Whether controls have the height that fingers need.
pub fn suits_fingers(ui: &egui::Ui) -> bool {
    ui.ctx().global_style().spacing.interact_size.y > ROW_HEIGHT
}

/// The height of a control: `compact` for a mouse, the row height on touch screens.
pub fn control_height(ui: &egui::Ui, compact: f32) -> f32 {
    let row = ui.ctx().global_style().spacing.interact_size.y;
    if row > ROW_HEIGHT { row } else { compact }
}

fn style(palette: &Palette, visuals: Visuals) -> Style {
    let mut style = Style { visuals: coloured(palette, visuals), ..Style::default() };
    let sizes =
        [(TextStyle::Heading, 16.0), (TextStyle::Body, 13.0), (TextStyle::Button, 13.0), (TextStyle::Small, 12.0)];
    for (name, size) in sizes {
        style.text_styles.insert(name, FontId::new(size, FontFamily::Proportional));
    }
    style.spacing.item_spacing = egui::vec2(8.0, 6.0);
    style.spacing.button_padding = egui::vec2(11.0, 5.0);
    style.spacing.interact_size.y = ROW_HEIGHT;
    style.spacing.menu_margin = Margin::same(8);
    style.spacing.window_margin = Margin::same(12);
    style.spacing.slider_rail_height = 4.0;
    style.spacing.icon_width = 16.0;
    style.spacing.icon_width_inner = 9.0;
    style.spacing.icon_spacing = 8.0;
    style.spacing.tooltip_width = 320.0;
    // a bar tells that there is more than fits, also without a pointer over it
    style.spacing.scroll.dormant_handle_opacity = 0.6;
    style.spacing.scroll.floating_width = 4.0;
    style.interaction.tooltip_delay = 0.35;
    style.interaction.selectable_labels = false;
    style
}

fn coloured(palette: &Palette, mut visuals: Visuals) -> Visuals {
    let rounding = CornerRadius::same(ROUNDING);
    visuals.panel_fill = palette.panel;
    visuals.window_fill = palette.raised;
    visuals.window_stroke = Stroke::new(1.0, palette.border);
    visuals.window_corner_radius = CornerRadius::same(10);
    visuals.menu_corner_radius = CornerRadius::same(10);
    visuals.extreme_bg_color = palette.canvas;
    visuals.faint_bg_color = palette.control;
    visuals.hyperlink_color = palette.accent_soft;
    visuals.error_fg_color = palette.error_edge;
    visuals.override_text_color = None;
    visuals.weak_text_color = Some(palette.weak);
    visuals.selection.bg_fill = palette.accent;
    visuals.selection.stroke = Stroke::new(1.0, palette.on_accent);
    visuals.slider_trailing_fill = true;
    visuals.handle_shape = egui::style::HandleShape::Circle;
    visuals.interact_cursor = Some(egui::CursorIcon::PointingHand);
    let edge = Stroke::new(1.0, palette.border);
    let ink = Stroke::new(1.0, palette.text);
    let widgets = &mut visuals.widgets;
    for (state, fill) in [
        (&mut widgets.noninteractive, palette.panel),
        (&mut widgets.inactive, palette.control),
        (&mut widgets.hovered, palette.control_hovered),
        (&mut widgets.active, palette.control_hovered),
        (&mut widgets.open, palette.control_hovered),
    ] {
        state.bg_fill = fill;
        state.weak_bg_fill = fill;
        state.bg_stroke = edge;
        state.fg_stroke = ink;
        state.corner_radius = rounding;
        state.expansion = 0.0;
    }
    // the focus ring must be seen at a glance
    widgets.active.bg_stroke = Stroke::new(2.0, palette.accent_soft);
    visuals
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use std::collections::BTreeSet;
    use std::path::Path;

    /// The characters between quotation marks in a source file, without comments and tests.
    fn quoted(text: &str) -> BTreeSet<char> {
        let program = text.split("#[cfg(test)]").next().unwrap_or_default();
        let lines = program.lines().filter(|line| !line.trim_start().starts_with("//"));
        lines.flat_map(|line| line.split('"').skip(1).step_by(2)).flat_map(str::chars).collect()
    }

    fn all_quoted(folder: &Path, found: &mut BTreeSet<char>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let text = |part: Option<&std::ffi::OsStr>| part.unwrap_or_default().to_string_lossy().into_owned();
            let (stem, ending) = (text(path.file_stem()), text(path.extension()));
            // the command line writes to a terminal, not with these fonts
            if path.is_dir() && stem != "cli" {
                all_quoted(&path, found);
            } else if ending == "rs" && !stem.ends_with("tests") {
                found.extend(quoted(&std::fs::read_to_string(&path).unwrap()));
            } else if ending == "ftl" && stem != "cli" {
                found.extend(std::fs::read_to_string(&path).unwrap().chars().filter(|sign| *sign != '\n'));
            }
        }
    }

    #[test]
    fn the_fonts_have_every_character_that_is_written() {
        // characters in `\u{…}` and in character literals, and the symbols of a Mac's keys
        let mut needed: BTreeSet<char> = "\u{2009}⁰¹²³⁴⁵⁶⁷⁸⁹⁻₀₁₂…⌘⇧⌥⌃".chars().collect();
        all_quoted(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut needed);
        assert!(needed.contains(&'ω') && needed.contains(&'→'), "the source files are scanned");
        // the byte order mark is read from files and never written
        needed.remove(&'\u{feff}');
        let context = egui::Context::default();
        install(&context);
        context.run_ui(egui::RawInput::default(), |_| {}).textures_delta.clear();
        for font in [FontId::proportional(13.0), FontId::monospace(13.0), bold(13.0)] {
            let missing: Vec<_> =
                needed.iter().filter(|&&sign| !context.fonts_mut(|fonts| fonts.has_glyph(&font, sign))).collect();
            assert!(missing.is_empty(), "{font:?} lacks {missing:?}");
        }
    }
}
