//! Text STL with and without its last line, and the numbers of vertices that are merged.

use super::*;

#[test]
fn a_text_stl_is_told_by_its_first_word_and_may_lack_its_last() {
    let facet = "FACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 0\nENDLOOP\nENDFACET\n";
    let whole = format!("SOLID a\n{facet}ENDSOLID a\n");
    assert_eq!(read_surface("a.stl", whole.as_bytes()).unwrap().triangles.len(), 1);
    assert_eq!(read_surface("a", whole.as_bytes()).unwrap().triangles.len(), 1);
    assert!(read_surface("a.stl", whole.as_bytes()).unwrap().notes.is_empty());
    for head in ["SOLID\n", "solid\n", "  Solid # 1\r\n", "solid solid endsolid\n"] {
        for end in ["", "endsol", "\n\n"] {
            let surface = read_surface("a.stl", [head, facet, end].concat().as_bytes()).unwrap();
            assert_eq!((surface.triangles.len(), &*surface.notes), (1, &[SurfaceNote::Unended][..]), "{head}, {end}");
        }
    }
    let second = facet.replace("VERTEX 0 0 0", "VERTEX 1 1 0").replace("1 0 0\nVERTEX 0 1 0", "0 1 0\nVERTEX 1 0 0");
    let several = format!("solid a\n{facet}endsolid a\n\nsolid\n{second}ENDSOLID\n");
    let surface = read_surface("a.stl", several.as_bytes()).unwrap();
    assert_eq!((surface.vertices.len(), surface.triangles.len()), (4, 2));
    assert!(SurfaceMesh::new(&surface).is_ok());
    let cut = ["solid\n", &facet.replace("ENDLOOP\nENDFACET\n", "")].concat();
    assert!(read_surface("a.stl", cut.as_bytes()).unwrap_err().to_string().contains("endloop"));
}

/// Every triangle of STL has corners of its own, which are merged: faults name them as the file counts them.
#[test]
fn faults_have_the_vertices_of_the_file() {
    let corners = [[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1], [0, 0], [0, 1], [0, 2]];
    let facet = |corners: &[[i32; 2]]| {
        let vertices = corners.iter().map(|[x, y]| format!("vertex {x} {y} 0\n")).collect::<Vec<_>>().concat();
        format!("facet normal 0 0 1\nouter loop\n{vertices}endloop\nendfacet\n")
    };
    let text = format!("solid\n{}endsolid\n", corners.chunks(3).map(facet).collect::<Vec<_>>().concat());
    let surface = read_surface("a.stl", text.as_bytes()).unwrap();
    assert_eq!(surface.vertices.len(), 5);
    let corners = [0, 5, 8].map(VertexId::new);
    let flat = TopologyError::Degenerate { triangle: TriangleId::new(2), corners, count: 1 };
    assert_eq!(SurfaceMesh::new(&surface).unwrap_err(), flat);
}

/// The corners of the faces of a cube without its top, two triangles for each.
fn open_cube() -> Vec<[[u8; 3]; 3]> {
    let corner = |k: u8| [k & 1, k >> 1 & 1, k >> 2];
    let faces = [[0, 2, 3, 1], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]];
    faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).map(|t: [u8; 3]| t.map(corner)).collect()
}

#[test]
fn a_cube_without_its_top_is_a_disk() {
    let facet = |corners: [[u8; 3]; 3]| {
        let vertex = |[x, y, z]: [u8; 3]| format!("      vertex {x}.000000e+00 {y}.0E-00 +{z}.\n");
        format!("  facet normal 0 0 0\n    outer loop\n{}    endloop\n  endfacet\n", corners.map(vertex).concat())
    };
    let text = format!("solid \n{}endsolid \n", open_cube().into_iter().map(facet).collect::<Vec<_>>().concat());
    for text in [text.clone(), text.to_uppercase()] {
        let surface = read_surface("cube.stl", text.as_bytes()).unwrap();
        let disk = SurfaceMesh::new(&surface).unwrap();
        assert_eq!((disk.mesh().vertices().len(), disk.mesh().triangles().len()), (8, 10));
    }
}

#[test]
fn the_number_of_triangles_of_a_binary_file_may_be_a_placeholder() {
    let plain = read_surface("a.stl", &binary_stl()).unwrap();
    for placeholder in [0, u32::MAX] {
        let mut other = binary_stl();
        other[80..84].copy_from_slice(&placeholder.to_le_bytes());
        assert_eq!(read_surface("a.stl", &other).unwrap(), plain, "{placeholder}");
    }
    let mut more = binary_stl();
    more[80] = 3;
    let expected = SurfaceError::missing(Place::Byte(184), Item::TriangleNormal);
    assert_eq!(read_surface("a.stl", &more).unwrap_err(), expected);
}
