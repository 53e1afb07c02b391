//! Messages for files that are not outlines, and for changes made while reading one.

use crate::language::{Label, Message, Value, key};
use crate::outline::{
    GeoJsonFault, JsonFault, JsonKind, MAX_BYTES, OutlineError, OutlineNote, PointFault, StaysPolygon, SvgFault,
};

impl From<&StaysPolygon> for Message {
    fn from(reason: &StaysPolygon) -> Self {
        match reason {
            StaysPolygon::FewPoints { count } => key::stays_few_points(*count),
            StaysPolygon::ManyCorners { corners, count } => key::stays_many_corners(*corners, *count),
            StaysPolygon::LeavesEdge { at } => key::stays_leaves_edge(at.x, at.y),
            StaysPolygon::CrossesItself { at } => key::stays_crosses_itself(at.x, at.y),
            StaysPolygon::PathCrossesItself { at } => key::stays_path_crosses(at.x, at.y),
            StaysPolygon::NoCurve(_) => key::stays_no_curve().into(),
        }
    }
}

impl From<&OutlineError> for Message {
    fn from(error: &OutlineError) -> Self {
        match error {
            OutlineError::TooLarge { bytes } => key::outline_file_too_large(*bytes, MAX_BYTES >> 20),
            OutlineError::NotUtf8 { offset } => key::outline_file_not_utf8(*offset),
            OutlineError::Empty => key::outline_file_empty().into(),
            OutlineError::Json { line, column, message } => key::outline_file_json(message.as_str(), *line, *column),
            OutlineError::NumberOutOfRange { line, column } => key::outline_file_number_out_of_range(*line, *column),
            OutlineError::NotANumber { line, column, found } => {
                key::outline_file_not_a_number(found.as_str(), *line, *column)
            }
            OutlineError::MissingNumber { line, column } => key::outline_file_missing_number(*line, *column),
            OutlineError::NumbersOnLine { line, count } => key::outline_file_numbers_on_line(*count, *line),
            OutlineError::NotUnderstood { line, text } => key::outline_file_not_understood(text.as_str(), *line),
            OutlineError::ReferenceSystem { name } => key::outline_file_reference_system(name.as_str()),
            OutlineError::NoSuchPart { wanted, count, names } => no_such_part(wanted, *count, names),
            OutlineError::OddNumbers { count } => key::outline_file_odd_numbers(*count),
            OutlineError::NotAPoint { point, found } => key::outline_file_not_a_point(*point, Message::from(*found)),
            OutlineError::NotAnOutline { found } => key::outline_file_not_an_outline(Message::from(*found)),
            OutlineError::NoPolygon { kind } => {
                key::outline_file_no_polygon(kind.as_ref().map_or(key::type_not_given().into(), Value::from))
            }
            OutlineError::GeoJson { fault } => key::outline_file_geo_json(Message::from(fault)),
            OutlineError::RingNotClosed { ring, first, last } => {
                key::outline_file_ring_not_closed(*ring, first.x, first.y, last.x, last.y)
            }
            OutlineError::Svg { fault } => key::outline_file_svg(Message::from(fault)),
            OutlineError::NoPath => key::outline_file_no_path().into(),
            OutlineError::NoClosedPath { paths } => key::outline_file_no_closed_path(*paths),
            OutlineError::Polygon(error) => error.into(),
        }
    }
}

fn no_such_part(wanted: &str, count: usize, names: &str) -> Message {
    match (count, names) {
        (0, _) => key::outline_file_no_parts(wanted),
        (_, "") => key::outline_file_no_such_number(wanted, count),
        (_, names) => key::outline_file_no_such_part(wanted, count, names),
    }
}

impl From<JsonKind> for Label {
    fn from(kind: JsonKind) -> Self {
        match kind {
            JsonKind::Null => key::json_null(),
            JsonKind::TruthValue => key::json_truth_value(),
            JsonKind::Number => key::json_number(),
            JsonKind::Text => key::json_text(),
            JsonKind::List => key::json_list(),
            JsonKind::Object => key::json_object(),
        }
    }
}

impl From<PointFault> for Message {
    fn from(fault: PointFault) -> Self {
        match fault {
            PointFault::NoList(kind) => key::point_is(Label::from(kind)),
            PointFault::NoNumber(kind) => key::point_has_no_number(Label::from(kind)),
            PointFault::Numbers { count } => key::point_has_numbers(count),
        }
    }
}

impl From<JsonFault> for Message {
    fn from(fault: JsonFault) -> Self {
        match fault {
            JsonFault::Points(kind) => key::points_are(Label::from(kind)),
            JsonFault::NoPoints => key::object_without_points().into(),
            JsonFault::Lengths { x, y } => key::lists_of_different_length(x, y),
            JsonFault::Value(kind) => Label::from(kind).into(),
        }
    }
}

impl From<&GeoJsonFault> for Message {
    fn from(fault: &GeoJsonFault) -> Self {
        match fault {
            GeoJsonFault::NoList { key: name, kind } => key::geojson_no_list(*name, Label::from(*kind)),
            GeoJsonFault::Missing(name) => key::geojson_missing(*name),
            GeoJsonFault::Polygon(kind) => key::geojson_polygon(Label::from(*kind)),
            GeoJsonFault::Ring(kind) => key::geojson_ring(Label::from(*kind)),
            GeoJsonFault::UnknownType(name) => key::geojson_unknown_type(name),
            GeoJsonFault::NoType => key::geojson_no_type().into(),
            GeoJsonFault::EmptyRing(ring) => key::geojson_empty_ring(*ring),
        }
    }
}

impl From<&SvgFault> for Message {
    fn from(fault: &SvgFault) -> Self {
        match fault {
            SvgFault::Reader(message) => message.as_str().into(),
            SvgFault::Elements => key::svg_elements_nested().into(),
            SvgFault::Uses => key::svg_uses_nested().into(),
        }
    }
}

impl From<&OutlineNote> for Message {
    fn from(note: &OutlineNote) -> Self {
        match note {
            OutlineNote::Reversed => key::outline_reversed().into(),
            OutlineNote::ShapeTaken { number, count, name: None } => key::outline_shape_taken(*number, *count),
            OutlineNote::ShapeTaken { number, count, name: Some(name) } => {
                key::outline_named_shape_taken(*number, *count, name.as_str())
            }
            OutlineNote::RepeatedPointsDropped { count } => key::outline_repeated_points_dropped(*count),
            OutlineNote::ColumnsDropped { columns } => key::outline_columns_dropped(*columns),
            OutlineNote::LargestOf { rings } => key::outline_largest_of(*rings),
            OutlineNote::ClosingPointDropped => key::outline_closing_point_dropped().into(),
            OutlineNote::Upwards => key::outline_upwards().into(),
            OutlineNote::HolesIgnored { holes } => key::outline_holes_ignored(*holes),
            OutlineNote::Repaired { dropped } => key::outline_repaired(*dropped),
            OutlineNote::Geographic => key::outline_geographic().into(),
        }
    }
}
