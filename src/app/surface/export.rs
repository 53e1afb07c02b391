//! The surface with its texture coordinates as a file.

use crate::app::model::Model;
use crate::export::{Flattened, SurfaceFormat};
use crate::session::SurfaceShape;

/// A file that is ready to be saved.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadyFile {
    /// Its name.
    pub name: String,
    /// Its content.
    pub bytes: Vec<u8>,
}

/// The surface as it was given, every vertex with its place in the outline: moved and scaled into the
/// unit box if `unit`, or the outline's own. `None` while there is no map. Errors: in words.
pub fn surface_file(model: &Model, format: SurfaceFormat, unit: bool) -> Option<Result<ReadyFile, String>> {
    let (side, state) = model.surface()?;
    let (map, source) = (side.map()?, side.preparation.source()?);
    Some(source.surface().map_err(|failure| failure.text).map(|surface| {
        let bytes = Flattened::new(&surface, map, unit).encode(format);
        ReadyFile { name: format!("{}-mapped.{}", stem(&state.spec.shape), format.extension()), bytes }
    }))
}

fn stem(shape: &SurfaceShape) -> &str {
    match shape {
        SurfaceShape::Preset { preset, .. } => preset.name(),
        SurfaceShape::File { name } => name.rsplit_once('.').map_or(name.as_str(), |(stem, _)| stem),
    }
}
