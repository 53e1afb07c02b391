//! `riemap render`: the picture that the app shows of a session; `riemap link`: its link.

use super::CliError;
use super::arguments::{LinkArguments, RenderArguments, ThemeArgument, read_file, read_outline};
use super::contours::Panel;
use super::output::{check_paths, print, write_all};
use super::picture::{self, Look, encode};
use super::surface_picture::{self, SurfacePanel};
use crate::app::still::{Still, StillCells, StillSurface};
use crate::conformal::Side;
use crate::render::{SceneCells, StrokeStyle};
use crate::session::link::{Decoded, MissingOutline, decode, encode as link_of, is_link};
use crate::session::{OutlineSpec, Session, TextureKind, file};
use crate::surface::MAX_BYTES;
use image::RgbaImage;

/// A picture this high has the strokes and dots of a screen with one pixel to the point.
const HEIGHT_OF_POINTS: f32 = 900.0;
/// Outer radius of the app's dots, in points.
const DOT_RADIUS: f32 = 10.0;

/// Draws a session.
pub fn run(arguments: &RenderArguments) -> Result<(), CliError> {
    check_paths(std::slice::from_ref(&arguments.out))?;
    let is_png = arguments.out.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("png"));
    if !is_png {
        return Err(CliError::Usage(format!("--out {}: the extension must be png", arguments.out.display())));
    }
    let session = with_files(open(&arguments.link)?, arguments)?;
    let surface = arguments.surface.as_ref().map(|name| read_file(name, MAX_BYTES)).transpose()?;
    let size = arguments.size.0;
    let scale = size[0].min(size[1]) as f32 / HEIGHT_OF_POINTS;
    let still = Still::new(session, surface, scale).map_err(|error| CliError::Input(error.to_string()))?;
    if still.session().texture == TextureKind::Image {
        eprintln!("riemap: images do not travel with sessions: a checkerboard stands in");
    }
    let picture = draw(&still, arguments.theme == ThemeArgument::Dark, scale, size)?;
    write_all(&[(arguments.out.clone(), encode(&picture)?)])
}

/// Prints the link of a session's file.
pub fn link(arguments: &LinkArguments) -> Result<(), CliError> {
    let Decoded { session, missing } = open(&arguments.session)?;
    refuse_missing(&missing)?;
    let encoded = link_of(&session).map_err(|error| CliError::Input(error.to_string()))?;
    for outline in &encoded.left_out {
        eprintln!("riemap: {outline}");
    }
    print(&encoded.fragment)
}

/// A link's session or a file's.
fn open(link: &str) -> Result<Decoded, CliError> {
    if is_link(link) {
        return decode(link).map_err(|error| CliError::Input(error.to_string()));
    }
    let bytes = read_file(link, file::MAX_BYTES)?;
    let session = file::read(&bytes).map_err(|error| CliError::Input(format!("{link}: {error}")))?;
    Ok(Decoded { session, missing: Vec::new() })
}

/// Puts in the outlines that a link only names.
fn with_files(decoded: Decoded, arguments: &RenderArguments) -> Result<Session, CliError> {
    let Decoded { mut session, mut missing } = decoded;
    for (side, name) in Side::BOTH.into_iter().zip([&arguments.source, &arguments.target]) {
        let Some(name) = name else { continue };
        let Some(place) = missing.iter().position(|outline| outline.side == side) else {
            return Err(CliError::Usage(format!("--{side}: the session has its outline of the {side}")));
        };
        let MissingOutline { interior, anchor, .. } = missing.remove(place);
        let outline = read_outline(name, false)?.outline;
        let points = outline.polygon.vertices().to_vec();
        let domain = if side == Side::Source { &mut session.source } else { &mut session.target };
        domain.outline = OutlineSpec::Points { name: outline.name, points };
        (session.interior[side as usize], session.anchor[side as usize]) = (interior, anchor);
    }
    refuse_missing(&missing)?;
    Ok(session)
}

fn refuse_missing(missing: &[MissingOutline]) -> Result<(), CliError> {
    let Some(MissingOutline { side, name, .. }) = missing.first() else { return Ok(()) };
    Err(CliError::Input(format!("the {side}'s outline \"{name}\" is not in the link: it travels as a file (--{side})")))
}

fn draw(still: &Still, dark: bool, scale: f32, size: [u32; 2]) -> Result<RgbaImage, CliError> {
    let look = Look {
        style: still.style(dark).ok_or_else(nothing)?,
        cells: Side::BOTH.map(|side| still.cells(side).and_then(planar)),
        stroke: Some(StrokeStyle::themed(dark, scale)),
        radius_px: DOT_RADIUS * scale,
    };
    let source = panel(still, Side::Source)?;
    match still.surface() {
        Some(surface) => {
            let StillSurface { surface, coordinates, points } = surface;
            let aspect = 0.5 * f64::from(size[0]) / f64::from(size[1]);
            let camera = still.camera(aspect).ok_or_else(nothing)?;
            let cells = still.cells(Side::Target).map(|cells| (cells.codes, cells.style));
            let solid = SurfacePanel { surface, coordinates, camera, handles: points, cells, right: true };
            surface_picture::draw(&source, &solid, &look, size)
        }
        None => picture::draw(&[source, panel(still, Side::Target)?], &look, size),
    }
}

fn planar(cells: StillCells<'_>) -> Option<SceneCells<'_>> {
    let StillCells { positions, triangles, codes, style } = cells;
    Some(SceneCells { positions: positions?, triangles, codes, style })
}

fn panel(still: &Still, side: Side) -> Result<Panel<'_>, CliError> {
    let geometry = still.geometry(side).ok_or_else(nothing)?;
    Ok(Panel {
        positions: geometry.positions,
        coordinates: geometry.texture_coordinates,
        triangles: geometry.triangles,
        boundary: still.boundary(side).ok_or_else(nothing)?,
        handles: still.points(side).ok_or_else(nothing)?,
    })
}

fn nothing() -> CliError {
    CliError::Input(String::from("there is nothing to draw"))
}
