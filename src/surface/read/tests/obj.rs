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
