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
