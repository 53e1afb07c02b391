//! A picture or an animation in the making, a frame's share at a time.
//!
//! It has a model of its own over the same prepared domains: what is on the screen goes on as it is. Nobody waits:
//! the map comes to rest over several frames, pixels are asked for and come when they come.

use crate::conformal::PerSide;
use crate::family::Loop;
use crate::language::{Message, key};
use crate::model::Model;
use crate::model::export::ReadyFile;
use crate::model::export::request::{ExportRequest, Kind};
use crate::model::scene::{Offscreen, Shot};
use crate::render::{Film, Graphics, OrbitCamera, PngFile, Readback, SceneRenderer, guarded};
use image::RgbaImage;
use std::sync::Arc;
use web_time::Instant;

/// What a frame spends on it; one step (a picture drawn, or encoded) may take longer.
const FRAME_MS: f64 = 12.0;

/// What is drawn besides the model.
pub struct Scenery {
    /// The texture of a session that has one.
    pub image: Option<Arc<RgbaImage>>,
    /// From where surfaces are seen.
    pub cameras: PerSide<Option<OrbitCamera>>,
    /// For a dark ground.
    pub dark: bool,
}

/// Work under way.
pub struct Job {
    offscreen: Offscreen,
    shot: Shot,
    scenery: Scenery,
    way: Option<Loop>,
    frames: u32,
    done: u32,
    renderer: SceneRenderer,
    stage: Stage,
    film: Option<Film>,
}

/// What comes next.
enum Stage {
    /// The map of this picture.
    Map,
    /// The picture.
    Draw,
    /// Its pixels, which are on their way.
    Pixels(Readback),
    /// Its file.
    File(Box<PngFile>),
}

/// What a frame's work has come to.
pub enum Progress {
    /// There is more to do: at once, or when pixels are there.
    GoesOn,
    /// It is there.
    Done(ReadyFile),
}

impl Job {
    /// Begins. Errors: in words.
    pub fn begin(
        model: &Model,
        request: &ExportRequest,
        scenery: Scenery,
        (device, queue): Graphics<'_>,
    ) -> Result<Self, Message> {
        let shot = request.shot(scenery.dark);
        let (film, way, frames) = match request.kind {
            Kind::Film(format) => {
                let film = Film::new(request.film(format)).map_err(|error| Message::from(&error))?;
                let way = crate::model::motion::looping::begin(model, request.path);
                (Some(film), Some(way.ok_or(key::nothing_would_move())?), request.frames)
            }
            _ => (None, None, 1),
        };
        let copy = if film.is_some() { Offscreen::moving } else { Offscreen::of };
        let offscreen = copy(model, shot.pixels_per_point());
        let renderer = SceneRenderer::new(device, queue);
        Ok(Self { offscreen, shot, scenery, way, frames, done: 0, renderer, stage: Stage::Map, film })
    }

    /// How far it is, from 0 to 1.
    pub fn progress(&self) -> f32 {
        let within = if let Stage::File(file) = &self.stage { file.progress() } else { 0.0 };
        (self.done as f32 + within) / self.frames as f32
    }

    /// How many pictures of how many there are.
    pub fn count(&self) -> [u32; 2] {
        [self.done, self.frames]
    }

    /// Spends a frame's share. Errors: in words.
    pub fn work(&mut self, gpu: Graphics<'_>) -> Result<Progress, Message> {
        let start = Instant::now();
        while start.elapsed().as_secs_f64() * 1e3 < FRAME_MS {
            if let Some(progress) = self.step(gpu)? {
                return Ok(progress);
            }
        }
        Ok(Progress::GoesOn)
    }

    /// One step; `None`: another one can follow at once.
    fn step(&mut self, gpu: Graphics<'_>) -> Result<Option<Progress>, Message> {
        match &mut self.stage {
            Stage::Map => {
                if !self.offscreen.advance().map_err(|error| Message::from(&error))? {
                    return Ok(Some(Progress::GoesOn));
                }
                self.stage = Stage::Draw;
                Ok(None)
            }
            Stage::Draw => {
                let Scenery { image, cameras, .. } = &self.scenery;
                let (offscreen, renderer) = (&self.offscreen, &mut self.renderer);
                let pixels = guarded(gpu.0, || {
                    let target = offscreen.draw(renderer, gpu, &self.shot, image.as_deref(), *cameras)?;
                    Ok(Readback::begin(gpu.0, gpu.1, &target))
                });
                self.stage = Stage::Pixels(pixels.map_err(|error| Message::from(&error))?);
                Ok(Some(Progress::GoesOn))
            }
            Stage::Pixels(readback) => {
                let Some(picture) = readback.poll(gpu.0) else { return Ok(Some(Progress::GoesOn)) };
                self.take(picture.map_err(|error| Message::from(&error))?)
            }
            Stage::File(file) => Ok(file.advance().map_err(|error| Message::from(&error))?.map(ready)),
        }
    }

    /// Goes on with a picture that has come.
    fn take(&mut self, picture: RgbaImage) -> Result<Option<Progress>, Message> {
        let (Some(film), Some(way)) = (&mut self.film, &self.way) else {
            self.stage = Stage::File(Box::new(PngFile::begin(picture).map_err(|error| Message::from(&error))?));
            return Ok(None);
        };
        film.push(&picture).map_err(|error| Message::from(&error))?;
        self.done += 1;
        if self.done < self.frames {
            self.offscreen.head_for(way.at(f64::from(self.done) / f64::from(self.frames)));
            self.stage = Stage::Map;
            return Ok(None);
        }
        let format = film.format();
        let bytes = self.film.take().map(Film::finish).transpose().map_err(|error| Message::from(&error))?;
        let name = format!("riemap-animation.{}", format.extension());
        Ok(bytes.map(|bytes| Progress::Done(ReadyFile::new(name, bytes))))
    }
}

fn ready(bytes: Vec<u8>) -> Progress {
    Progress::Done(ReadyFile::new("riemap.png", bytes))
}
