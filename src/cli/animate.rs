//! `riemap animate`: a loop through the maps between two domains, starting at a session, as an animated PNG or GIF.

use super::CliError;
use super::output::{check_paths, write_all};
use super::picture::failed;
use super::picture_arguments::{AnimateArguments, PathArgument, SideArgument, ThemeArgument};
use super::progress::Progress;
use super::render::{Loaded, load};
use crate::conformal::{PerSide, Side};
use crate::family::{Loop, Path};
use crate::model::scene::{Offscreen, Shot};
use crate::render::{Film, FilmFormat, FilmSettings, Studio};
use image::RgbaImage;

/// Renders the animation and writes it.
pub fn run(arguments: &AnimateArguments) -> Result<(), CliError> {
    check_paths(std::slice::from_ref(&arguments.out))?;
    let settings = settings(arguments)?;
    let film = Film::new(settings).map_err(|error| CliError::Usage(error.to_string()))?;
    let shot = Shot {
        size: settings.size,
        dark: arguments.theme == ThemeArgument::Dark,
        transparent: arguments.transparent,
        dots: !arguments.no_dots,
        side: arguments.side.and_then(SideArgument::side),
    };
    let progress = Progress::new("reading");
    let Loaded { offscreen, image } = load(&arguments.session, &shot, &progress)?;
    let way = offscreen.way(path(arguments.path)).ok_or_else(|| {
        let (name, side) = if arguments.path == PathArgument::Interior {
            ("interior", Side::Source)
        } else {
            ("target-interior", Side::Target)
        };
        CliError::Usage(format!("--path {name}: the {side} is a surface, whose point is not moved along a loop"))
    })?;
    progress.enter("the animation");
    let image = image.as_ref();
    let bytes =
        Making { film, frames: settings.frames, shot: &shot, image, progress: &progress }.make(offscreen, &way)?;
    write_all(&[(arguments.out.clone(), bytes)])
}

fn settings(arguments: &AnimateArguments) -> Result<FilmSettings, CliError> {
    let extension = arguments.out.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
    let format = FilmFormat::from_extension(extension).ok_or_else(|| {
        CliError::Usage(format!("--out {}: the extension must be png (animated) or gif", arguments.out.display()))
    })?;
    let AnimateArguments { size, frames, seconds, .. } = *arguments;
    Ok(FilmSettings { format, size: size.0, frames, seconds })
}

fn path(argument: PathArgument) -> Path {
    match argument {
        PathArgument::Interior => Path::SourcePoint,
        PathArgument::TargetInterior => Path::TargetPoint,
        PathArgument::Boundary => Path::Boundary,
        PathArgument::All => Path::All,
    }
}

/// An animation being rendered.
struct Making<'a> {
    film: Film,
    frames: u32,
    shot: &'a Shot,
    image: Option<&'a RgbaImage>,
    progress: &'a Progress,
}

impl Making<'_> {
    fn make(mut self, mut offscreen: Offscreen, way: &Loop) -> Result<Vec<u8>, CliError> {
        let input = |error: &dyn std::error::Error| CliError::Input(error.to_string());
        let mut studio = Studio::new().map_err(|error| failed(&error))?;
        self.progress.report(0.0);
        for k in 0..self.frames {
            offscreen.go(way.at(f64::from(k) / f64::from(self.frames))).map_err(|error| input(&error))?;
            let picture = studio
                .shoot(|renderer, device, queue| {
                    offscreen.draw(renderer, (device, queue), self.shot, self.image, PerSide::default())
                })
                .map_err(|error| failed(&error))?;
            self.film.push(&picture).map_err(|error| input(&error))?;
            self.progress.report(f64::from(k + 1) / f64::from(self.frames));
        }
        self.progress.enter("writing");
        self.film.finish().map_err(|error| input(&error))
    }
}
