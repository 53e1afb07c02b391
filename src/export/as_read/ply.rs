//! A PLY file with other texture coordinates: its elements with all properties, in its encoding, and `s` and `t` of each
//! vertex.
//!
//! Texture coordinates that it had, of vertices or of corners, are dropped. An added vertex has the other properties of what
//! it divides, in proportion, or of the vertex of which it is a copy.

use super::{Faces, Numbers, SurfaceSource, added::Added, faces::Written};
use crate::export::Flattened;
use crate::geometry::DVec2;
use crate::surface::{Element, Encoding, PlyFile, PlyValue, Property, Scalar, Shape, decoded};
use std::fmt::Write as _;

/// The names of texture coordinates of vertices, which are so in pairs.
const OF_VERTICES: [[&str; 2]; 3] = [["s", "t"], ["u", "v"], ["texture_u", "texture_v"]];
/// The names of texture coordinates of the corners of faces, and of their images.
const OF_CORNERS: [&str; 2] = ["texcoord", "texnumber"];
/// What is said in the header.
const REMARK: &str = "comment riemap: s t are texture coordinates; vertices that are not of the file follow its own";

type Row = Vec<PlyValue>;

/// The file; `None` if it has triangle strips, or is not that of the surface.
pub(super) fn written(flattened: &Flattened, source: SurfaceSource<'_>) -> Option<Vec<u8>> {
    let bytes = decoded(source.bytes);
    let mut file = PlyFile::new(&bytes).ok()?;
    let elements = file.elements.clone();
    let count = |name: &str| elements.iter().filter(|element| element.name == name).count();
    if (count("vertex"), count("face"), count("tristrips")) != (1, 1, 0) {
        return None;
    }
    let numbers = Numbers::new(source.surface);
    let faces = Faces::new(source.surface, flattened, &numbers);
    let mut writer = Writer { flattened, source, numbers: &numbers, faces, encoding: file.encoding, body: Vec::new() };
    let mut out = Vec::with_capacity(elements.len());
    for element in elements {
        out.push(match element.name.as_str() {
            "vertex" => writer.vertices(element, &mut file)?,
            "face" => writer.faces(element, &mut file)?,
            _ => writer.same(element, &mut file)?,
        });
    }
    let Writer { faces, body, .. } = writer;
    let text = [header(&file, flattened, &numbers, &out).into_bytes(), body].concat();
    faces.is_complete().then_some(text)
}

/// The header of a file with these elements.
fn header(file: &PlyFile<'_>, flattened: &Flattened, numbers: &Numbers<'_>, elements: &[Element]) -> String {
    let encoding = match file.encoding {
        Encoding::Text => "ascii",
        Encoding::LittleEndian => "binary_little_endian",
        Encoding::BigEndian => "binary_big_endian",
    };
    let mut text = format!("ply\nformat {encoding} 1.0\n");
    let remarks = file.remarks.iter().map(|remark| String::from_utf8_lossy(remark));
    for remark in remarks.filter(|remark| remark != REMARK) {
        let _ = writeln!(text, "{remark}");
    }
    let _ = writeln!(text, "{REMARK}");
    flattened.told(&mut text, "comment", 0, &|vertex| numbers.of(vertex));
    for Element { name, count, properties } in elements {
        let _ = writeln!(text, "element {name} {count}");
        for Property { name, shape } in properties {
            let _ = match shape {
                Shape::One(scalar) => writeln!(text, "property {} {name}", scalar.name()),
                Shape::List { length, item } => {
                    writeln!(text, "property list {} {} {name}", length.name(), item.name())
                }
            };
        }
    }
    text + "end_header\n"
}

/// The names of an element's texture coordinates. Beside w, u and v are a velocity.
fn coordinates_of(element: &Element) -> Vec<&'static str> {
    let is_there = |name: &str| element.properties.iter().any(|property| property.name == name);
    let are_coordinates =
        |pair: &&[&str; 2]| pair.iter().all(|name| is_there(name)) && !(pair[0] == "u" && is_there("w"));
    OF_VERTICES.iter().filter(are_coordinates).flatten().copied().collect()
}

/// The rows so far.
struct Writer<'a> {
    flattened: &'a Flattened,
    source: SurfaceSource<'a>,
    numbers: &'a Numbers<'a>,
    faces: Faces<'a>,
    encoding: Encoding,
    body: Vec<u8>,
}

impl Writer<'_> {
    /// Writes the rows of an element as they are.
    fn same(&mut self, element: Element, file: &mut PlyFile<'_>) -> Option<Element> {
        for _ in 0..element.count {
            if element.properties.is_empty() {
                break;
            }
            let row = file.row(&element.properties).ok()?;
            self.row(&element.properties, &row);
        }
        Some(element)
    }

    /// Writes the vertices, with those that were added, and their texture coordinates.
    fn vertices(&mut self, element: Element, file: &mut PlyFile<'_>) -> Option<Element> {
        let coordinate = |name: &str| Property { name: name.to_owned(), shape: Shape::One(Scalar::F64) };
        let dropped = coordinates_of(&element);
        let is_kept = |property: &Property| !dropped.contains(&property.name.as_str());
        if element.properties.iter().any(|property| is_kept(property) && ["s", "t"].contains(&property.name.as_str())) {
            return None;
        }
        let kept: Vec<bool> = element.properties.iter().map(is_kept).collect();
        let mut properties = element.properties.clone();
        properties.retain(is_kept);
        properties.extend(["s", "t"].map(coordinate));
        let coordinates = self.faces.coordinates();
        let added = Added::new(self.flattened, self.source.surface, self.numbers);
        let mut rows = Vec::new();
        for number in 0..element.count {
            let row = only(file.row(&element.properties).ok()?, &kept);
            self.vertex(&properties, &row, *coordinates.get(number)?);
            if !added.is_empty() {
                rows.push(row);
            }
        }
        for (vertex, uv) in added.iter().zip(coordinates.get(element.count..)?) {
            let mut row = mixture(&vertex.weighted(&rows)?)?;
            for (value, property) in row.iter_mut().zip(&properties) {
                *value = placed(value, property, vertex.place().to_array());
            }
            self.vertex(&properties, &row, *uv);
        }
        Some(Element { count: coordinates.len(), properties, ..element })
    }

    /// Writes a vertex with its texture coordinates, which are the last properties.
    fn vertex(&mut self, properties: &[Property], row: &[PlyValue], uv: Option<DVec2>) {
        let uv = uv.unwrap_or_default();
        self.row(properties, &[row, &[PlyValue::One(uv.x), PlyValue::One(uv.y)]].concat());
    }

    /// Writes the faces, or the triangles in their place.
    fn faces(&mut self, element: Element, file: &mut PlyFile<'_>) -> Option<Element> {
        let is_kept = |property: &Property| !OF_CORNERS.contains(&property.name.as_str());
        let kept: Vec<bool> = element.properties.iter().map(is_kept).collect();
        let mut properties = element.properties.clone();
        properties.retain(is_kept);
        let mut lists = (0..properties.len()).filter(|&k| properties[k].is_corners());
        let (Some(list), None) = (lists.next(), lists.next()) else { return None };
        if let Shape::List { item, .. } = &mut properties[list].shape {
            *item = wide_enough(*item, self.source.surface.count_in_file() + self.numbers.added_count(self.flattened));
        }
        let mut count = 0;
        for _ in 0..element.count {
            let mut row = only(file.row(&element.properties).ok()?, &kept);
            for corners in self.written(&row[list])? {
                row[list] = corners;
                self.row(&properties, &row);
                count += 1;
            }
        }
        Some(Element { count, properties, ..element })
    }

    /// The lists of corners that stand in the place of one.
    fn written(&mut self, corners: &PlyValue) -> Option<Vec<PlyValue>> {
        let PlyValue::List(given) = corners else { return None };
        let list = |corners: &[u32]| PlyValue::List(corners.iter().copied().map(f64::from).collect());
        let vertices: Vec<u32> = given.iter().map(|&vertex| vertex as u32).collect();
        Some(match self.faces.next(&vertices)? {
            Written::LeftOut => vec![corners.clone()],
            Written::Whole { mut corners, is_turned } => {
                if is_turned {
                    corners.reverse();
                }
                vec![list(&corners)]
            }
            Written::Parts(triangles) => triangles.iter().map(|triangle| list(triangle)).collect(),
        })
    }

    fn row(&mut self, properties: &[Property], row: &[PlyValue]) {
        match self.encoding {
            Encoding::Text => self.text_row(row),
            Encoding::LittleEndian => self.binary_row(properties, row, false),
            Encoding::BigEndian => self.binary_row(properties, row, true),
        }
    }

    fn text_row(&mut self, row: &[PlyValue]) {
        let word = |value: &PlyValue| match value {
            PlyValue::One(value) => value.to_string(),
            PlyValue::List(values) => {
                let words = std::iter::once(values.len().to_string()).chain(values.iter().map(f64::to_string));
                words.collect::<Vec<_>>().join(" ")
            }
        };
        let words: Vec<String> = row.iter().map(word).collect();
        self.body.extend_from_slice(words.join(" ").as_bytes());
        self.body.push(b'\n');
    }

    fn binary_row(&mut self, properties: &[Property], row: &[PlyValue], big_endian: bool) {
        for (value, property) in row.iter().zip(properties) {
            match (value, property.shape) {
                (PlyValue::List(values), Shape::List { length, item }) => {
                    length.encode(values.len() as f64, big_endian, &mut self.body);
                    for &value in values {
                        item.encode(value, big_endian, &mut self.body);
                    }
                }
                (PlyValue::One(value), Shape::One(scalar)) => scalar.encode(*value, big_endian, &mut self.body),
                _ => {}
            }
        }
    }
}

/// The values that are kept.
fn only(row: Row, kept: &[bool]) -> Row {
    row.into_iter().zip(kept).filter(|(_, kept)| **kept).map(|(value, _)| value).collect()
}

/// The type of the numbers of `count` vertices: that of the file, if it reaches.
fn wide_enough(item: Scalar, count: usize) -> Scalar {
    let largest = count as f64 - 1.0;
    if item.nearest(largest) == largest { item } else { Scalar::U32 }
}

/// The weighted mean of rows; lists are those of the first.
fn mixture(rows: &[(&Row, f64)]) -> Option<Row> {
    let (first, _) = rows.first()?;
    let mean = |(k, value): (usize, &PlyValue)| {
        let term = |(row, weight): &(&Row, f64)| match row.get(k) {
            Some(PlyValue::One(value)) => weight * value,
            _ => 0.0,
        };
        match value {
            PlyValue::One(_) => PlyValue::One(rows.iter().map(term).sum()),
            list @ PlyValue::List(_) => list.clone(),
        }
    };
    Some(first.iter().enumerate().map(mean).collect())
}

/// The value of an added vertex at `place`, as its type has it.
fn placed(value: &PlyValue, property: &Property, place: [f64; 3]) -> PlyValue {
    let axis = ["x", "y", "z"].iter().position(|name| *name == property.name);
    match (value, property.shape) {
        (PlyValue::One(value), Shape::One(scalar)) => {
            PlyValue::One(axis.map_or_else(|| scalar.nearest(*value), |axis| place[axis]))
        }
        _ => value.clone(),
    }
}
