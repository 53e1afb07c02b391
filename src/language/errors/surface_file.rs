//! Messages for files that are not surfaces, with the place of the error, and for changes made while reading one.

use crate::language::{Message, key};
use crate::surface::{Fault, Item, MAX_BYTES, Place, SurfaceError, SurfaceNote, Unsupported};

impl From<&SurfaceError> for Message {
    fn from(error: &SurfaceError) -> Self {
        match error {
            SurfaceError::TooLarge { bytes } => key::surface_file_too_large(*bytes, MAX_BYTES >> 20),
            SurfaceError::TooMuchMemory { triangles, vertices, needed_mb, available_mb } => {
                key::surface_file_too_much_memory(*triangles, *vertices, *needed_mb, *available_mb)
            }
            SurfaceError::UnknownFormat { extension } => key::surface_file_unknown_format(extension.as_str()),
            SurfaceError::NotANumber { place, found } => {
                key::surface_file_not_a_number(Message::from(place), found.as_str())
            }
            SurfaceError::Missing { place, what } => {
                key::surface_file_missing(Message::from(place), Message::from(*what))
            }
            SurfaceError::IndexOutOfRange { place, index, vertices } => {
                key::surface_file_index_out_of_range(*vertices, Message::from(place), *index)
            }
            SurfaceError::Malformed { place, fault } => {
                key::surface_file_malformed(Message::from(place), Message::from(fault))
            }
            SurfaceError::Unsupported { place, what } => {
                key::surface_file_unsupported(Message::from(place), Message::from(what))
            }
            SurfaceError::NoTriangles => key::surface_file_no_triangles().into(),
        }
    }
}

impl From<&SurfaceNote> for Message {
    fn from(note: &SurfaceNote) -> Self {
        match note {
            SurfaceNote::Triangulated { polygons, .. } => key::surface_note_triangulated(*polygons),
            SurfaceNote::Welded { before, after } => key::surface_note_welded(*before, *after),
            SurfaceNote::LeftApart { vertices } => key::surface_note_left_apart(*vertices),
            SurfaceNote::DroppedFaces { count } => key::surface_note_dropped_faces(*count),
            SurfaceNote::Unended => key::surface_note_unended().into(),
            SurfaceNote::Surplus { place } => key::surface_note_surplus(Message::from(place)),
        }
    }
}

impl From<&Place> for Message {
    fn from(place: &Place) -> Self {
        match place {
            Place::Line(line) => key::place_line(*line),
            Place::Byte(offset) => key::place_byte(*offset),
            Place::Part(part) => part.as_str().into(),
        }
    }
}

impl From<Item> for Message {
    fn from(item: Item) -> Self {
        let label = match item {
            Item::Chunk { length } => return key::item_chunk(length),
            Item::Mesh(_) | Item::Keyword(_) => return item.to_string().into(), // a name that the file format defines
            Item::Element { index, count } => return key::item_element(index, count),
            Item::Corner { index, count } => return key::item_corner(index, count),
            Item::VertexProperty(name) => return key::item_vertex_property(name),
            Item::TriangleCorner { triangle, count } => return key::item_triangle_corner(triangle, count),
            Item::Coordinate(name) => return key::item_named_coordinate(name),
            Item::Version => key::item_glb_version(),
            Item::FileLength => key::item_file_length(),
            Item::ChunkLength => key::item_chunk_length(),
            Item::ChunkType => key::item_chunk_type(),
            Item::JsonChunk => key::item_json_chunk(),
            Item::DefaultScene => key::item_default_scene(),
            Item::Node => key::item_node(),
            Item::Position => key::item_position(),
            Item::Data => key::item_data(),
            Item::Accessor => key::item_accessor(),
            Item::BufferView => key::item_buffer_view(),
            Item::Buffer => key::item_buffer(),
            Item::ViewedData => key::item_viewed_data(),
            Item::Vertex => key::item_vertex(),
            Item::Face => key::item_face(),
            Item::CornerCount => key::item_corner_count(),
            Item::OffKeyword => key::item_off_keyword(),
            Item::OffNumber => key::item_off_number(),
            Item::VertexCount => key::item_vertex_count(),
            Item::FaceCount => key::item_face_count(),
            Item::ListLength => key::item_list_length(),
            Item::Property => key::item_property(),
            Item::List => key::item_list(),
            Item::VertexCoordinate => key::item_vertex_coordinate(),
            Item::FaceProperty => key::item_face_property(),
            Item::FaceCorner => key::item_face_corner(),
            Item::ElementCount => key::item_element_count(),
            Item::PropertyElement => key::item_property_element(),
            Item::FormatLine => key::item_format_line(),
            Item::HeaderEnd => key::item_header_end(),
            Item::PropertyName => key::item_property_name(),
            Item::TriangleCount => key::item_triangle_count(),
            Item::TriangleNormal => key::item_triangle_normal(),
            Item::TriangleEnd => key::item_triangle_end(),
        };
        label.into()
    }
}

impl From<&Unsupported> for Message {
    fn from(what: &Unsupported) -> Self {
        match what {
            Unsupported::Version(version) => key::unsupported_version(*version),
            Unsupported::Extension(name) => key::unsupported_extension(name),
            Unsupported::Morphing => key::unsupported_morphing().into(),
            Unsupported::SeparateFile(name) => key::unsupported_separate_file(name),
            Unsupported::Encoding => key::unsupported_encoding().into(),
            Unsupported::Dimensions(keyword) => key::unsupported_dimensions(keyword),
        }
    }
}

impl From<&Fault> for Message {
    fn from(fault: &Fault) -> Self {
        match fault {
            Fault::NotGlb => key::fault_no_glb().into(),
            Fault::NotGltf(message) => key::fault_no_gltf(message),
            Fault::NodeTwice => key::fault_node_twice().into(),
            Fault::CornerCount { count } => key::fault_corner_count(*count),
            Fault::Mode(mode) => key::fault_mode(*mode),
            Fault::AccessorType { found, component, needed } => key::fault_accessor_type(found, *component, *needed),
            Fault::Base64 { position } => key::fault_base64(*position),
            Fault::ListLength(length) => key::fault_list_length(*length),
            Fault::NotPly => key::fault_no_ply().into(),
            Fault::UnknownWord(word) => key::fault_unknown_word(word),
            Fault::UnknownFormat(format) => key::fault_unknown_format(format),
            Fault::NoType(word) => key::fault_no_type(word),
            Fault::ListLengthType => key::fault_list_length_type().into(),
            Fault::Count { what, found } => key::fault_count(Message::from(*what), found),
        }
    }
}
