//! PLY: the order of elements, strips, and lines that are not rows.

use super::*;

#[test]
fn the_faces_of_a_ply_may_come_before_its_vertices() {
    let [head, faces] = ["element face 2\nproperty list uchar int vertex_indices\n", "3 0 1 2\n3 0 2 3\n"];
    let vertices = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
    let body = "0 0 2\n1 0 2.5\n1 1 2\n0 1 2\n";
    let text = |faces: &str| format!("ply\nformat ascii 1.0\n{head}{vertices}end_header\n{faces}{body}");
    let plain = read_surface("a.ply", PLY.as_bytes()).unwrap();
    assert_eq!(read_surface("a.ply", text(faces).as_bytes()).unwrap(), plain);
    let error = SurfaceError::IndexOutOfRange { place: Place::Line(11), index: 4, vertices: 4 };
    assert_eq!(read_surface("a.ply", text("3 0 1 2\n3 0 2 4\n").as_bytes()).unwrap_err(), error);
}

const STRIPS: &str = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
                      element tristrips 1\nproperty list int int vertex_indices\nend_header\n\
                      0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

#[test]
fn strips_of_ply_are_turned_alternately_and_end_at_minus_1() {
    for (strips, expected) in [
        ("4 0 1 3 2\n", vec![[0, 1, 3], [3, 1, 2]]),
        ("7 0 1 3 -1 1 2 3\n", vec![[0, 1, 3], [1, 2, 3]]),
        // a corner that is repeated turns the triangles after it
        ("6 0 1 3 3 1 2\n", vec![[0, 1, 3], [1, 3, 2]]),
    ] {
        let surface = read_surface("a.ply", [STRIPS, strips].concat().as_bytes()).unwrap();
        assert_eq!(surface.triangles, expected, "{strips}");
    }
    let error = read_surface("a.ply", [STRIPS, "3 0 1 4\n"].concat().as_bytes()).unwrap_err();
    assert_eq!(error, SurfaceError::IndexOutOfRange { place: Place::Line(14), index: 4, vertices: 4 });
}

/// The header's list, then numbers that it does not name.
#[test]
fn rows_of_ply_may_be_longer_than_their_properties_and_stand_on_several_lines_or_on_one() {
    let plain = read_surface("a.ply", PLY.as_bytes()).unwrap();
    let longer = PLY.replace("3 0 1 2", "3 0 1 2 9 9 9").replace("3 0 2 3", "3 0 2 3 1 1 1");
    assert_ne!(longer, PLY);
    let surface = read_surface("a.ply", longer.as_bytes()).unwrap();
    assert_eq!((surface.vertices, surface.triangles), (plain.vertices.clone(), plain.triangles.clone()));
    let (head, body) = PLY.split_at(PLY.find("end_header\n").unwrap() + "end_header\n".len());
    for between in [" ", "\n"] {
        let body = body.split_ascii_whitespace().collect::<Vec<_>>().join(between);
        let surface = read_surface("a.ply", [head, &*body, "\n"].concat().as_bytes()).unwrap();
        assert_eq!((surface.vertices, surface.triangles), (plain.vertices.clone(), plain.triangles.clone()));
    }
}

/// Quadrilaterals, after another list; the header's lines end as on Windows.
#[test]
fn polygons_of_binary_files_may_follow_other_lists() {
    let plain = read_surface("a.obj", OBJ.replace("f 1/1 2/1 3/1\nf -4// -2 -1", "f 1 2 3 4").as_bytes()).unwrap();
    let head = "ply\r\nformat binary_big_endian 1.0\r\ncomment end_header follows\r\nelement vertex 4\r\n\
                property double x\r\nproperty double y\r\nproperty double z\r\nelement face 1\r\n\
                property list uchar float texcoord\r\nproperty list int ushort vertex_index\r\n\
                property uchar flags\r\nend_header\r\n";
    let mut bytes = head.as_bytes().to_vec();
    bytes.extend(corners().as_flattened().iter().flat_map(|&x| f64::from(x).to_be_bytes()));
    bytes.push(1);
    bytes.extend(0.5_f32.to_be_bytes());
    bytes.extend(4_i32.to_be_bytes());
    bytes.extend([0_u16, 1, 2, 3].iter().flat_map(|v| v.to_be_bytes()));
    bytes.push(7);
    assert_eq!(read_surface("a.ply", &bytes).unwrap(), plain);
}
