//! The unit square at height 2 in every format.

/// The unit square at height 2 as two triangles; the corner (1, 0) is lifted to 2.5.
pub(super) fn corners() -> [[f32; 3]; 4] {
    [[0.0, 0.0, 2.0], [1.0, 0.0, 2.5], [1.0, 1.0, 2.0], [0.0, 1.0, 2.0]]
}

pub(super) const OBJ: &str =
    "# \u{e9}\nv 0 0 2\nv 1 0 2.5 1 0 0\nv 1 1 2\nv 0 1 2\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\nf -4// -2 -1\n";
pub(super) const OFF: &str = "COFF # kind\n4 2 5\n0 0 2 255 0 0\n1 0 2.5\n\n1 1 2\n0 1 2\n3 0 1 2\n3 0 2 3 255\n";
pub(super) const PLY: &str = "ply\nformat ascii 1.0\ncomment none\nelement vertex 4\nproperty uchar red\nproperty float x\n\
    property double y\nproperty float z\nelement face 2\nproperty list uchar int vertex_indices\n\
    property float quality\nelement edge 1\nproperty int a\nend_header\n9 0 0 2\n9 1 0 2.5\n9 1 1 2\n9 0 1 2\n\
    3 0 1 2 0.5\n3 0 2 3 0.5\n7\n";

pub(super) fn binary_ply(big_endian: bool) -> Vec<u8> {
    let kind = if big_endian { "big" } else { "little" };
    let mut bytes = format!(
        "ply\nformat binary_{kind}_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\n\
         property float z\nproperty list uchar short extra\nelement face 2\n\
         property list uchar uint vertex_index\nend_header\n"
    )
    .into_bytes();
    let order = |mut value: Vec<u8>| {
        if big_endian {
            value.reverse();
        }
        value
    };
    for corner in corners() {
        for value in corner {
            bytes.extend(order(value.to_le_bytes().to_vec()));
        }
        bytes.extend([2, 1, 2, 3, 4]);
    }
    for face in [[0_u32, 1, 2], [0, 2, 3]] {
        bytes.push(3);
        for v in face {
            bytes.extend(order(v.to_le_bytes().to_vec()));
        }
    }
    bytes
}

pub(super) fn stl_text() -> String {
    let p = corners();
    let loops = [[0, 1, 2], [0, 2, 3]].map(|t| {
        let vertices = t.map(|v: usize| format!("vertex {} {} {}\n", p[v][0], p[v][1], p[v][2])).concat();
        format!("facet normal 0 0 1\nouter loop\n{vertices}endloop\nendfacet\n")
    });
    format!("solid square\n{}endsolid\n", loops.concat())
}

pub(super) fn binary_stl() -> Vec<u8> {
    let mut bytes = vec![0; 80];
    bytes[..5].copy_from_slice(b"solid");
    bytes.extend(2_u32.to_le_bytes());
    for triangle in [[0, 1, 2], [0, 2, 3]] {
        bytes.extend([0; 12]);
        for value in triangle.map(|v: usize| corners()[v]).as_flattened() {
            bytes.extend(value.to_le_bytes());
        }
        bytes.extend([0; 2]);
    }
    bytes
}

/// Two nodes with one triangle each: the first mesh is moved by (0, 0, 2) in a child, the second is mirrored.
pub(super) fn gltf_parts() -> (String, Vec<u8>) {
    let mut buffer = Vec::new();
    let [a, mut b, c, d] = corners();
    b[2] -= 2.0;
    let down = |p: [f32; 3]| [p[0], p[1], 0.0];
    let mirrored = |p: [f32; 3]| [-p[0], p[1], p[2]];
    for point in [down(a), b, down(c), mirrored(a), mirrored(c), mirrored(d)] {
        for value in point {
            buffer.extend(value.to_le_bytes());
        }
    }
    for index in [0_u16, 1, 2, 0, 2, 1] {
        buffer.extend(index.to_le_bytes());
    }
    let document = r#"{"asset": {"version": "2.0"}, "scenes": [{"nodes": [0, 2]}],
        "nodes": [{"children": [1], "translation": [0, 0, 1]}, {"mesh": 0, "translation": [0, 0, 1]},
                  {"mesh": 1, "scale": [-1, 1, 1]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 2}]},
                   {"primitives": [{"attributes": {"POSITION": 1}, "indices": 3}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 0, "byteOffset": 36, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"},
            {"bufferView": 1, "byteOffset": 6, "componentType": 5123, "count": 3, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 72}, {"buffer": 0, "byteOffset": 72, "byteLength": 12}],
        "buffers": [{"byteLength": 84 URI}]}"#;
    (document.to_owned(), buffer)
}

pub(super) fn glb() -> Vec<u8> {
    let (document, buffer) = gltf_parts();
    let mut document = document.replace("URI", "").into_bytes();
    document.resize(document.len().next_multiple_of(4), b' ');
    let mut bytes = b"glTF\x02\0\0\0".to_vec();
    bytes.extend((28 + document.len() as u32 + buffer.len() as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", &document), (b"BIN\0", &buffer)] {
        bytes.extend((chunk.len() as u32).to_le_bytes());
        bytes.extend(kind);
        bytes.extend(chunk);
    }
    bytes
}

pub(super) fn gltf() -> String {
    let (document, buffer) = gltf_parts();
    let digits = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for three in buffer.chunks(3) {
        let bits = u32::from_be_bytes([0, three[0], three[1], three[2]]);
        (0..4).rev().for_each(|k| text.push(char::from(digits[(bits >> (6 * k)) as usize & 63])));
    }
    document.replace("URI", &format!(r#", "uri": "data:application/octet-stream;base64,{text}""#))
}

/// With colors at the vertices and at one face.
pub(super) fn binary_off() -> Vec<u8> {
    let mut bytes = b"COFF BINARY\n".to_vec();
    let whole = |bytes: &mut Vec<u8>, numbers: &[i32]| bytes.extend(numbers.iter().flat_map(|n| n.to_be_bytes()));
    whole(&mut bytes, &[4, 2, 5]);
    for [x, y, z] in corners() {
        bytes.extend([x, y, z, 0.5, 0.5, 0.5, 1.0].iter().flat_map(|n: &f32| n.to_be_bytes()));
    }
    whole(&mut bytes, &[3, 0, 1, 2, 0, 3, 0, 2, 3, 1]);
    bytes.extend(0.25_f32.to_be_bytes());
    bytes
}

/// Every format with the same square in it.
pub(super) fn files() -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("a.obj", OBJ.into()),
        ("a.off", OFF.into()),
        ("b.off", binary_off()),
        ("a.ply", PLY.into()),
        ("b.ply", binary_ply(false)),
        ("c.PLY", binary_ply(true)),
        ("a.stl", stl_text().into()),
        ("b.stl", binary_stl()),
        ("a.glb", glb()),
        ("a.gltf", gltf().into()),
    ]
}

/// The square in three formats whose lines may end in any way.
pub(super) fn texts() -> [(&'static str, String); 4] {
    [("a.obj", OBJ.into()), ("a.off", OFF.into()), ("a.ply", PLY.into()), ("a.stl", stl_text())]
}
