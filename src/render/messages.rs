//! The messages of the errors of `render`.

use super::film::MOST_BYTES;
use super::{FilmError, ImageError, MOST_FRAMES, MeshFault, ReadbackFault, RenderError, SECONDS};
use crate::language::{Message, key};

impl From<&ImageError> for Message {
    fn from(error: &ImageError) -> Self {
        match error {
            ImageError::Empty { width, height } => key::image_data_empty(*width, *height),
            ImageError::ByteCount { width, height, expected, actual } => {
                key::image_data_byte_count(*width, *height, *expected, *actual)
            }
        }
    }
}

impl From<&RenderError> for Message {
    fn from(error: &RenderError) -> Self {
        match error {
            RenderError::NoAdapter { cause } => key::render_no_adapter(cause.as_str()),
            RenderError::NoDevice { adapter, cause } => key::render_no_device(adapter.as_str(), cause.as_str()),
            RenderError::Size { width, height, limit } => key::render_size(*width, *height, *limit),
            RenderError::ViewportCount { count, limit } => key::render_viewport_count(*limit, *count),
            RenderError::Geometry { viewport, fault } => key::render_geometry(*viewport, Message::from(*fault)),
            RenderError::Surface { fault } => key::render_surface(Message::from(*fault)),
            RenderError::Image(reason) => key::render_image(Message::from(reason)),
            RenderError::Device(reason) => key::render_device(reason.as_str()),
            RenderError::Readback(fault) => key::render_readback(Message::from(fault)),
        }
    }
}

impl From<MeshFault> for Message {
    fn from(fault: MeshFault) -> Self {
        match fault {
            MeshFault::Coordinates { positions, coordinates } => key::coordinates_differ(positions, coordinates),
            MeshFault::Codes { triangles, codes } => key::codes_differ(triangles, codes),
            MeshFault::Boundary { boundary, vertices } => key::boundary_too_long(boundary, vertices),
            MeshFault::Vertex { triangle, corners, vertices } => {
                key::vertex_beyond(triangle, format!("{corners:?}"), vertices)
            }
            MeshFault::TooLarge { triangles } => key::too_many_triangles(triangles),
        }
    }
}

impl From<&ReadbackFault> for Message {
    fn from(fault: &ReadbackFault) -> Self {
        match fault {
            ReadbackFault::Library(cause) => cause.as_str().into(),
            ReadbackFault::DeviceGone => key::device_gone().into(),
            ReadbackFault::TooShort { width, height } => key::too_few_bytes(*width, *height),
        }
    }
}

impl From<&FilmError> for Message {
    fn from(error: &FilmError) -> Self {
        match error {
            FilmError::Frames { frames } => key::film_frames(*frames, MOST_FRAMES),
            FilmError::Seconds { seconds } => key::film_seconds(*seconds, *SECONDS.start(), *SECONDS.end()),
            FilmError::Rate { rate } => key::film_rate(format!("{rate:.0}")),
            FilmError::Size { width, height } => key::film_size(*width, *height),
            FilmError::Long { pictures } => key::film_long(*pictures, MOST_BYTES >> 20),
            FilmError::Picture { width, height } => key::film_picture(*width, *height),
            FilmError::Encoder(reason) => key::film_encoder(reason.as_str()),
        }
    }
}
