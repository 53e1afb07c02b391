//! OBJ: polygons, marks and comments, faces of two corners.

use super::*;

#[test]
fn polygons_are_cut_into_triangles() {
    let pentagon = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nf 1 2 3 \\\n 4 5\nf 1 2 3\n";
    let surface = read_surface("p.obj", pentagon.as_bytes()).unwrap();
    assert_eq!(surface.triangles.len(), 4);
    assert_eq!(surface.notes, [SurfaceNote::Triangulated { polygons: 1, faces: 2 }]);
}

#[test]
fn marks_and_comments_before_the_first_vertex_take_nothing_away() {
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    let plain = read_surface("a.obj", square.as_bytes()).unwrap();
    for before in ["\u{feff}", "# exported from C:\\models\\\n", "\u{feff}# C:\\\r\n"] {
        let read = read_surface("a.obj", format!("{before}{square}").as_bytes()).unwrap();
        assert_eq!((read.vertices, read.triangles), (plain.vertices.clone(), plain.triangles.clone()), "{before:?}");
    }
}

#[test]
fn faces_with_two_corners_are_dropped_and_counted() {
    let surface = read_surface("a.obj", [OBJ, "f 1 2\nf 3\n"].concat().as_bytes()).unwrap();
    assert_eq!(surface.triangles.len(), 2);
    assert!(surface.notes.contains(&SurfaceNote::DroppedFaces { count: 2 }), "{:?}", surface.notes);
}

#[test]
fn corners_are_counted_from_the_end_and_may_end_in_slashes() {
    let corners = read_surface("a.obj", OBJ.as_bytes()).unwrap();
    let other = OBJ.replace("f 1/1 2/1 3/1", "  f\t-4/ -3// 3/1/ # a\r").replace("f -4// -2 -1", "f 1 -2/-1/-1 4/ ");
    assert_eq!(read_surface("a.obj", other.as_bytes()).unwrap(), corners);
}

/// Triangles written as quadrilaterals, and polygons that repeat their first corner.
#[test]
fn corners_that_repeat_the_one_before_are_left_out() {
    let vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    for (faces, expected) in [
        ("f 1 2 3 3\nf 1 1 3 4\n", vec![[0, 1, 2], [0, 2, 3]]),
        ("f 1 2 3 1\nf 1 3 3 3 4 4 1 1\n", vec![[0, 1, 2], [0, 2, 3]]),
        ("f 1 2 3\nf 1 2 2 1\n", vec![[0, 1, 2]]),
    ] {
        let surface = read_surface("a.obj", [vertices, faces].concat().as_bytes()).unwrap();
        assert_eq!(surface.triangles, expected, "{faces}");
        assert!(SurfaceMesh::new(&surface).is_ok(), "{faces}");
    }
}

#[test]
fn what_is_no_number_may_be_written_as_on_windows() {
    let unused = ["v -nan(ind) 1.#QNAN -1.#INF # no place\n", OBJ].concat().replace("f 1/1 2/1 3/1", "f 2/1 3/1 4/1");
    let surface = read_surface("a.obj", unused.as_bytes()).unwrap();
    assert!(surface.vertices[0].is_nan());
    assert_eq!(SurfaceMesh::new(&surface).unwrap().repairs(), [RepairNote::DroppedVertices { count: 1 }]);
    for word in ["nanometer", "1#", "inf(", "1,5"] {
        let error = read_surface("a.obj", format!("v 0 {word} 0\n").as_bytes()).unwrap_err();
        assert!(error.to_string().starts_with("line 1: "), "{error}");
    }
}
