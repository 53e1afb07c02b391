//! An OBJ file with other texture coordinates: its lines, with a `vt` for each `v` before the first face.
//!
//! Faces have absolute numbers and keep their normals; an added vertex has that of the nearest corner of its face, and a color
//! in between those of the vertices that it divides. A triangle
//! in the place of a face has none if one of its corners is not of the face. The old `vt` are dropped. If vertices were
//! added, those of the file that are behind its first face are moved before it, so that no face names a vertex that comes
//! later.

use super::added::Added;
use super::{Faces, Numbers, SurfaceSource, faces::Written};
use crate::export::Flattened;
use crate::surface::{ObjCorner, ObjFile, ObjLine, Surface, vertex_color};
use std::io::Write as _;

/// What is said before the first face.
const REMARK: &str = "# riemap: a vt for each v; vertices that are not of the file follow its own";

/// The file; `None` if it has lines that are not understood, or is not that of the surface.
pub(super) fn written(flattened: &Flattened, source: SurfaceSource<'_>) -> Option<Vec<u8>> {
    let numbers = Numbers::new(source.surface);
    let faces = Faces::new(source.surface, flattened, &numbers);
    let file = ObjFile::new(source.bytes);
    let added = Added::new(flattened, source.surface, &numbers);
    let normals = Normals { surface: source.surface, added: &added };
    let text = Vec::with_capacity(2 * source.bytes.len());
    let mut out = Writer { flattened, numbers: &numbers, added: &added, faces, normals, text };
    let (mut passed, mut is_begun, mut is_moved) = (0, false, false);
    for line in file.lines() {
        match line.ok()? {
            ObjLine::Vertex(_) if is_moved => {}
            ObjLine::Vertex(line) => {
                passed += 1;
                out.line(line);
            }
            ObjLine::Face(corners, comment) => {
                if !is_begun {
                    is_moved = out.begin_faces(&file, passed)?;
                    is_begun = true;
                }
                out.face(&corners, comment)?;
            }
            ObjLine::Points(keyword, vertices) => out.points(keyword, &vertices),
            ObjLine::Other(line) if line == REMARK.as_bytes() => {}
            ObjLine::Other(line) => out.line(line),
            ObjLine::Coordinates => {}
            ObjLine::FreeForm => return None,
        }
    }
    out.faces.is_complete().then_some(out.text)
}

/// The text so far.
struct Writer<'a> {
    flattened: &'a Flattened,
    numbers: &'a Numbers<'a>,
    added: &'a Added,
    faces: Faces<'a>,
    normals: Normals<'a>,
    text: Vec<u8>,
}

impl Writer<'_> {
    fn line(&mut self, line: &[u8]) {
        self.text.extend_from_slice(line);
        self.text.push(b'\n');
    }

    /// Writes what comes before the first face, after `passed` vertices: the added vertices and all coordinates. Says
    /// whether the rest of the vertices was moved here.
    fn begin_faces(&mut self, file: &ObjFile<'_>, passed: usize) -> Option<bool> {
        let mut vertices = Vec::new();
        if !self.added.is_empty() {
            vertices.extend(file.lines().filter_map(|line| match line {
                Ok(ObjLine::Vertex(line)) => Some(line),
                _ => None,
            }));
            vertices.iter().skip(passed).for_each(|line| self.line(line));
        }
        let mut told = format!("{REMARK}\n");
        self.flattened.told(&mut told, "#", 1, &|vertex| self.numbers.of(vertex));
        self.text.extend_from_slice(told.as_bytes());
        for vertex in self.added.iter() {
            let p = vertex.place();
            write!(self.text, "v {} {} {}", p.x, p.y, p.z).ok()?;
            match vertex.weighted(&vertices).and_then(|lines| color(&lines)) {
                Some([red, green, blue]) => writeln!(self.text, " {red} {green} {blue}").ok()?,
                None => self.line(b""),
            }
        }
        for uv in self.faces.coordinates().into_iter().map(Option::unwrap_or_default) {
            writeln!(self.text, "vt {} {}", uv.x, uv.y).ok()?;
        }
        Some(!self.added.is_empty())
    }

    /// Writes what stands in the place of a face.
    fn face(&mut self, given: &[ObjCorner<'_>], comment: &[u8]) -> Option<()> {
        let vertices: Vec<u32> = given.iter().map(|corner| corner.vertex).collect();
        match self.faces.next(&vertices)? {
            Written::LeftOut => self.corners(given, false, comment),
            Written::Whole { corners, is_turned } => {
                let corners = corners.into_iter().zip(given).map(|(vertex, corner)| ObjCorner { vertex, ..*corner });
                let mut corners: Vec<ObjCorner> = corners.collect();
                if is_turned {
                    corners.reverse();
                }
                self.corners(&corners, true, comment);
            }
            Written::Parts(triangles) => {
                for triangle in triangles {
                    self.corners(&self.normals.of(triangle, given), true, comment);
                }
            }
        }
        Some(())
    }

    /// Writes a face with these corners, with the coordinates of its vertices if it is flattened.
    fn corners(&mut self, corners: &[ObjCorner<'_>], is_flattened: bool, comment: &[u8]) {
        self.text.push(b'f');
        for &ObjCorner { vertex, normal } in corners {
            let number = vertex + 1;
            self.text.extend_from_slice(format!(" {number}").as_bytes());
            if is_flattened {
                self.text.extend_from_slice(format!("/{number}").as_bytes());
            }
            if !normal.is_empty() {
                self.text.extend_from_slice(if is_flattened { b"/" } else { b"//" });
                self.text.extend_from_slice(normal);
            }
        }
        if !comment.is_empty() {
            self.text.push(b' ');
        }
        self.line(comment);
    }

    fn points(&mut self, keyword: &[u8], vertices: &[u32]) {
        self.text.extend_from_slice(keyword);
        for vertex in vertices {
            self.text.extend_from_slice(format!(" {}", vertex + 1).as_bytes());
        }
        self.line(b"");
    }
}

/// The weighted mean of the colors in the lines of vertices; `None` if one has none.
fn color(lines: &[(&&[u8], f64)]) -> Option<[f64; 3]> {
    let mut sum = [0.0; 3];
    for (line, weight) in lines {
        sum.iter_mut().zip(vertex_color(line)?).for_each(|(sum, value)| *sum += weight * value);
    }
    Some(sum)
}

/// The normals of triangles in the place of faces.
struct Normals<'a> {
    surface: &'a Surface,
    added: &'a Added,
}

impl Normals<'_> {
    /// The corners of a triangle in the place of a face, with normals if all have one.
    fn of<'b>(&self, triangle: [u32; 3], given: &[ObjCorner<'b>]) -> [ObjCorner<'b>; 3] {
        let normals = triangle.map(|vertex| self.at(vertex, given).unwrap_or_default());
        let has_all = normals.iter().all(|normal| !normal.is_empty());
        std::array::from_fn(|k| ObjCorner { vertex: triangle[k], normal: if has_all { normals[k] } else { b"" } })
    }

    /// The normal at a vertex, or at the nearest one of those that it divides.
    fn at<'b>(&self, vertex: u32, given: &[ObjCorner<'b>]) -> Option<&'b [u8]> {
        let beyond = vertex.checked_sub(self.surface.count_in_file() as u32);
        let vertex = match beyond {
            Some(k) => self.added.get(k as usize)?.nearest()?,
            None => vertex,
        };
        let became = |vertex: u32| self.surface.vertex_in_file(vertex);
        given.iter().find(|corner| became(corner.vertex) == became(vertex)).map(|corner| corner.normal)
    }
}
