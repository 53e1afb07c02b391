//! `riemap render`: a session as a picture, as the app shows it, or as another file; `riemap link`: a session's link.

use super::CliError;
use super::flatten_arguments::with_neighbors;
use super::moved::say_moved;
use super::named_outline::{read_file, read_outline};
use super::output::{check_paths, print, write_all};
use super::picture::{encode, failed};
use super::picture_arguments::{LinkArguments, RenderArguments, SessionArguments, SideArgument, ThemeArgument};
use super::progress::Progress;
use super::values::TilingArgument;
use crate::conformal::{PerSide, Side};
use crate::export::FileFormat;
use crate::model::export::FileRequest;
use crate::model::scene::{Doing, Offscreen, Shot, SurfaceFiles};
use crate::outline::Reading;
use crate::render::Studio;
use crate::session::file::Attachment;
use crate::session::link::{Decoded, MissingOutline, decode, encode as link_of, is_link};
use crate::session::{Command, Session, SurfaceShape, SurfaceSpec, TextureKind, file};
use crate::surface::{MAX_BYTES, names_format};
use image::RgbaImage;
use std::path::Path;

/// Renders a session and writes the file.
pub fn run(arguments: &RenderArguments) -> Result<(), CliError> {
    check_paths(std::slice::from_ref(&arguments.out))?;
    let format = Format::of(&arguments.out)?;
    if format != Format::Picture && arguments.no_dots {
        return Err(CliError::Usage(String::from("--no-dots: only a .png is drawn without them")));
    }
    if format != Format::Picture && arguments.transparent {
        return Err(CliError::Usage(String::from("--transparent: only a .png has a ground")));
    }
    let shot = shot(arguments);
    let progress = Progress::new("reading");
    let Loaded { offscreen, image } = load(&arguments.session, &shot, &progress)?;
    progress.enter(arguments.out.display().to_string());
    let bytes = match format {
        Format::Picture => picture(&offscreen, image.as_ref(), &shot)?,
        Format::File(format) => {
            let request = FileRequest { format, side: shot.side, unit: true, corners: true };
            let file = offscreen.file(request, image.as_ref()).map_err(|error| CliError::Input(error.to_string()))?;
            file.note.iter().for_each(|note| eprintln!("riemap: {}", note.english()));
            file.bytes
        }
    };
    write_all(&[(arguments.out.clone(), bytes)])
}

/// The format, by the file's extension.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Picture,
    File(FileFormat),
}

impl Format {
    fn of(path: &Path) -> Result<Self, CliError> {
        let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
        let picture = extension.eq_ignore_ascii_case("png").then_some(Self::Picture);
        picture.or(FileFormat::from_extension(extension).map(Self::File)).ok_or_else(|| {
            let message = "the extension must be png, svg, csv or obj, or, of a surface, ply or glb";
            CliError::Usage(format!("--out {}: {message}", path.display()))
        })
    }
}

fn shot(arguments: &RenderArguments) -> Shot {
    Shot {
        size: arguments.size.0,
        dark: arguments.theme == ThemeArgument::Dark,
        transparent: arguments.transparent,
        dots: !arguments.no_dots,
        side: arguments.side.and_then(SideArgument::side),
    }
}

/// A session with its map.
pub struct Loaded {
    /// The session and its map.
    pub offscreen: Offscreen,
    /// The own picture that its file holds.
    pub image: Option<RgbaImage>,
}

/// Loads the session that the arguments name and computes its map.
pub fn load(arguments: &SessionArguments, shot: &Shot, progress: &Progress) -> Result<Loaded, CliError> {
    let Opened { decoded, files, picture } = open(&arguments.link)?;
    let mut session = with_files(decoded, arguments)?;
    if let Some(TilingArgument(tiling)) = arguments.tiling {
        session.apply(Command::SetTexture(TextureKind::Tiling));
        session.apply(Command::SetTiling(tiling));
    }
    let surfaces = surface_files(&mut session, arguments, &files)?;
    let offscreen = Offscreen::telling(&session, surfaces, shot.pixels_per_point(), &mut |doing| match doing {
        Doing::PreparingOutline(side, stage) => progress.preparing(&format!("the {side}"))(stage),
        Doing::PreparingSurface(side, stage) => progress.preparing(&format!("the {side}'s surface"))(stage),
        Doing::Mapping => progress.enter("the map"),
    });
    let offscreen = offscreen.map_err(|error| CliError::Input(error.to_string()))?;
    say_moved(&session, &offscreen);
    let image = picture.filter(|_| offscreen.session().shows_picture()).map(|file| decoded_image(&file));
    let image = image.transpose()?;
    if offscreen.session().shows_picture() && image.is_none() {
        let stands_in = if offscreen.session().texture() == TextureKind::Image {
            "a checkerboard stands"
        } else {
            "plain tiles stand"
        };
        eprintln!("riemap: there is no image in the session: {stands_in} in");
    }
    Ok(Loaded { offscreen, image })
}

/// The picture of a session's file.
fn decoded_image(file: &Attachment) -> Result<RgbaImage, CliError> {
    let decoded = image::load_from_memory(&file.bytes);
    decoded.map(image::DynamicImage::into_rgba8).map_err(|error| CliError::Input(format!("{}: {error}", file.name)))
}

fn picture(offscreen: &Offscreen, image: Option<&RgbaImage>, shot: &Shot) -> Result<Vec<u8>, CliError> {
    let mut studio = Studio::new().map_err(|error| failed(&error))?;
    let picture = studio
        .shoot(|renderer, device, queue| offscreen.draw(renderer, (device, queue), shot, image, PerSide::default()));
    encode(&picture.map_err(|error| failed(&error))?)
}

/// Prints the link of a session's file.
pub fn link(arguments: &LinkArguments) -> Result<(), CliError> {
    let Decoded { session, missing, .. } = open(&arguments.session)?.decoded;
    refuse_missing(&missing)?;
    let encoded = link_of(&session).map_err(|error| CliError::Input(error.to_string()))?;
    for outline in &encoded.left_out {
        eprintln!("riemap: {outline}");
    }
    for outline in &encoded.shortened {
        eprintln!("riemap: {outline}");
    }
    print(&encoded.fragment)
}

/// What a link or a session's file holds.
struct Opened {
    decoded: Decoded,
    /// The files of surfaces.
    files: Vec<Attachment>,
    picture: Option<Attachment>,
}

/// Opens a link or a session's file.
fn open(link: &str) -> Result<Opened, CliError> {
    if is_link(link) {
        let decoded = decode(link).map_err(|error| CliError::Input(error.to_string()))?;
        return Ok(Opened { decoded, files: Vec::new(), picture: None });
    }
    let bytes = read_file(link, file::MAX_ARCHIVE_BYTES)?;
    let archive = file::read_archive(&bytes).map_err(|error| CliError::Input(format!("{link}: {error}")))?;
    let decoded = Decoded::complete(archive.session().clone());
    Ok(Opened { decoded, files: archive.surfaces, picture: archive.picture })
}

/// Loads the outlines that the link only names.
fn with_files(decoded: Decoded, arguments: &SessionArguments) -> Result<Session, CliError> {
    let Decoded { mut session, mut missing } = decoded;
    for (side, name) in Side::BOTH.into_iter().zip([&arguments.source, &arguments.target]) {
        let Some(name) = name else { continue };
        let Some(place) = missing.iter().position(|outline| outline.side == side) else {
            return Err(CliError::Usage(format!("--{side}: the session has its outline of the {side}")));
        };
        let MissingOutline { interior, anchor, pins, region, .. } = missing.remove(place);
        let outline = read_outline(name, &Reading::default())?.outline;
        // not SetOutline: a surface that hides the outline must stay
        session.apply(Command::ReshapeOutline { side, outline: outline.into(), interior, anchor });
        if !region.is_empty() {
            session.apply(Command::SetRegion(region));
        }
        if missing.is_empty() && pins.is_some() {
            session.apply(Command::SetPins(pins));
        }
    }
    refuse_missing(&missing)?;
    Ok(session)
}

/// The files of the surfaces: those that are given, else those `within` the session's file. A file's name determines its format and appears in errors; if it
/// has no known extension, the file name stored in the session is used instead.
fn surface_files(
    session: &mut Session,
    arguments: &SessionArguments,
    within: &[Attachment],
) -> Result<SurfaceFiles, CliError> {
    let mut files = PerSide::from_fn(|side| {
        let is_of =
            |file: &&Attachment| session.surface(side).is_some_and(|state| state.spec.shape.is_file(&file.name));
        within.iter().find(is_of).map(|file| file.bytes.to_vec())
    });
    if arguments.surface.len() > Side::BOTH.len() {
        return Err(CliError::Usage(String::from("--surface: a session has at most two surfaces")));
    }
    for (side, name) in sides_of_files(session, &arguments.surface) {
        if names_format(name) && is_from_file(session, side) {
            rename_surface(session, side, name);
        }
        files[side] = Some(with_neighbors(name, read_file(name, MAX_BYTES)?));
    }
    Ok(files)
}

/// The side of each file: the one whose surface comes from a file of that name; the other files follow in the order of
/// the sides. A file that is left goes to a side without a surface from a file, which is refused with the reason.
fn sides_of_files<'a>(session: &Session, names: &'a [String]) -> Vec<(Side, &'a String)> {
    let mut sides = Side::BOTH.to_vec();
    sides.sort_by_key(|&side| !is_from_file(session, side));
    let is_of = |side: &Side, file: &str| session.surface(*side).is_some_and(|state| state.spec.shape.is_file(file));
    let mut side_of = |name: &String| {
        let file = Path::new(name).file_name()?.to_str()?;
        Some(sides.remove(sides.iter().position(|side| is_of(side, file))?))
    };
    let named: Vec<_> = names.iter().map(|name| (side_of(name), name)).collect();
    let mut rest = sides.into_iter();
    named.into_iter().filter_map(|(side, name)| Some((side.or_else(|| rest.next())?, name))).collect()
}

fn is_from_file(session: &Session, side: Side) -> bool {
    session.surface(side).is_some_and(|state| matches!(state.spec.shape, SurfaceShape::File { .. }))
}

/// The surface of a side with its points, under another file's name.
fn rename_surface(session: &mut Session, side: Side, name: &str) {
    let Some(state) = session.surface(side) else { return };
    let (points, shape) = (state.points(), SurfaceShape::File { name: name.into() });
    let surface = SurfaceSpec { shape, ..state.spec.clone() };
    session.apply(Command::SetSurface { side, surface });
    session.apply(Command::PlacePoints { side, points });
}

fn refuse_missing(missing: &[MissingOutline]) -> Result<(), CliError> {
    let Some(MissingOutline { side, name, .. }) = missing.first() else { return Ok(()) };
    Err(CliError::Input(format!("the {side}'s outline \"{name}\" is not in the link: it travels as a file (--{side})")))
}
