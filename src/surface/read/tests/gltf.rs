//! glTF: buffers beside the file, quantized and sparse accessors.

use super::*;

#[test]
fn the_buffer_of_a_gltf_file_may_lie_beside_it_and_nowhere_else() {
    let (document, buffer) = gltf_parts();
    let with = |uri: &str| document.replace("URI", &format!(r#", "uri": "{uri}""#));
    let plain = read_surface("a.gltf", gltf().as_bytes()).unwrap();
    let mut asked = Vec::new();
    let mut beside = |name: &str| {
        asked.push(name.to_owned());
        (name == "the square.bin").then(|| buffer.clone())
    };
    assert_eq!(read_surface_beside("a.gltf", with("the%20square.bin").as_bytes(), &mut beside).unwrap(), plain);
    for away in ["../the square.bin", "/the square.bin", "http://a.b/the square.bin", "c:the square.bin"] {
        assert!(read_surface_beside("a.gltf", with(away).as_bytes(), &mut beside).is_err(), "{away}");
    }
    assert_eq!(asked, ["the square.bin"]);
}

#[test]
fn other_versions_and_changed_shapes_are_named() {
    let refusal = |text: &str| read_surface("a.gltf", text.as_bytes()).unwrap_err().to_string();
    let old = refusal(r#"{"asset": {"version": "1.0"}, "meshes": {"a": {}}, "nodes": {}}"#);
    assert!(old.contains("version 1 of glTF"), "{old}");
    let weighted = gltf().replacen(r#""primitives""#, r#""weights": [0, 0.5], "primitives""#, 1);
    let plain = read_surface("a.gltf", gltf().as_bytes());
    assert_eq!(read_surface("a.gltf", weighted.as_bytes()), plain, "nothing to weigh");
    let weighted = weighted.replacen(r#""attributes""#, r#""targets": [{}, {}], "attributes""#, 1);
    assert!(refusal(&weighted).contains("morph targets with weights"), "{}", refusal(&weighted));
    assert_eq!(read_surface("a.gltf", weighted.replace("0.5", "0").as_bytes()), plain);
}

#[test]
fn quantized_and_sparse_positions_are_read() {
    // a triangle in 8 and in 16 bits, and one of which two corners differ from 0
    let bytes: [i8; 12] = [0, 0, 0, 0, 127, 0, 0, 0, 0, -127, 0, 0];
    let shorts: [i16; 9] = [0, 0, 0, 32_767, 0, 0, 0, -32_768, 0];
    let floats: [f32; 6] = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    let mut buffer: Vec<u8> = bytes.iter().map(|&b| b as u8).collect();
    buffer.extend(shorts.iter().flat_map(|s| s.to_le_bytes()));
    buffer.extend([1, 0, 2, 0]);
    buffer.extend(floats.iter().flat_map(|x| x.to_le_bytes()));
    let data = {
        use base64::Engine as _;
        base64::engine::general_purpose::STANDARD.encode(&buffer)
    };
    let document = |accessor: &str| {
        format!(
            r#"{{"asset": {{"version": "2.0"}}, "extensionsRequired": ["KHR_mesh_quantization"], "nodes": [{{"mesh": 0}}],
            "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}}}]}}], "accessors": [{accessor}],
            "bufferViews": [{{"buffer": 0, "byteLength": 12, "byteStride": 4}}, {{"buffer": 0, "byteOffset": 12, "byteLength": 18}},
                {{"buffer": 0, "byteOffset": 30, "byteLength": 4}}, {{"buffer": 0, "byteOffset": 34, "byteLength": 24}}],
            "buffers": [{{"byteLength": 58, "uri": "data:;base64,{data}"}}]}}"#
        )
    };
    let corners = |accessor: &str| read_surface("a.gltf", document(accessor).as_bytes()).unwrap().vertices;
    let normalized = [DVec3::ZERO, DVec3::X, DVec3::NEG_Y];
    let bytes = r#"{"bufferView": 0, "componentType": 5120, "normalized": true, "count": 3, "type": "VEC3"}"#;
    assert_eq!(corners(bytes), normalized);
    assert_eq!(corners(&bytes.replace("true", "false")), normalized.map(|p| 127.0 * p));
    assert_eq!(corners(&bytes.replace("5120", "5122").replace("\"bufferView\": 0", "\"bufferView\": 1")), normalized);
    let sparse = r#"{"componentType": 5126, "count": 3, "type": "VEC3", "sparse": {"count": 2,
        "indices": {"bufferView": 2, "componentType": 5123}, "values": {"bufferView": 3}}}"#;
    assert_eq!(corners(sparse), [DVec3::ZERO, DVec3::X, DVec3::Y]);
    let beyond = document(&sparse.replace("\"count\": 3", "\"count\": 2"));
    assert!(read_surface("a.gltf", beyond.as_bytes()).unwrap_err().to_string().contains("accessors[0]"));
}

/// A grid of 4 × 3 vertices with normals between their positions, in a buffer with these indices at its end.
fn grid(primitive: &str, indices: &[u8]) -> Surface {
    use base64::Engine as _;
    let vertices = (0..12_u8).flat_map(|k| [k % 4, k / 4, k % 4 * (k / 4), 0, 0, 1]).map(f32::from);
    let buffer: Vec<u8> = vertices.flat_map(f32::to_le_bytes).chain(indices.iter().copied()).collect();
    let data = base64::engine::general_purpose::STANDARD.encode(&buffer);
    let count = indices.len();
    let document = format!(
        r#"{{"asset": {{"version": "2.0"}}, "nodes": [{{"mesh": 0}}], "meshes": [{{"primitives": [{{
            "attributes": {{"POSITION": 0, "NORMAL": 1}}, "indices": 2 {primitive}}}]}}], "accessors": [
            {{"bufferView": 0, "componentType": 5126, "count": 12, "type": "VEC3"}},
            {{"bufferView": 0, "byteOffset": 12, "componentType": 5126, "count": 12, "type": "VEC3"}},
            {{"bufferView": 1, "componentType": 5121, "count": {count}, "type": "SCALAR"}}],
            "bufferViews": [{{"buffer": 0, "byteLength": 288, "byteStride": 24}},
                            {{"buffer": 0, "byteOffset": 288, "byteLength": {count}}}],
            "buffers": [{{"byteLength": {}, "uri": "data:application/gltf-buffer;base64,{data}"}}]}}"#,
        buffer.len()
    );
    read_surface("a.gltf", document.as_bytes()).unwrap()
}

#[test]
fn positions_between_normals_and_indices_of_one_byte_are_read() {
    let surface = grid("", &[0, 1, 5, 0, 5, 4]);
    assert_eq!(surface.triangles, [[0, 1, 5], [0, 5, 4]]);
    assert_eq!(surface.vertices[6], DVec3::new(2.0, 1.0, 2.0));
}

#[test]
fn strips_go_on_elsewhere_by_repeated_corners_and_fans_turn_about_their_first() {
    let strips = grid(r#", "mode": 5"#, &[0, 4, 1, 5, 2, 6, 3, 7, 7, 4, 4, 8, 5, 9, 6, 10, 7, 11]);
    let disk = SurfaceMesh::new(&strips).unwrap();
    assert_eq!((disk.mesh().triangles().len(), disk.mesh().vertices().len()), (12, 12));
    let fan = grid(r#", "mode": 6"#, &[5, 0, 1, 2, 6, 10, 9, 8, 4, 0]);
    let disk = SurfaceMesh::new(&fan).unwrap();
    assert_eq!((disk.mesh().triangles().len(), disk.mesh().boundary_count()), (8, 8));
    assert_eq!(disk.repairs(), [RepairNote::DroppedVertices { count: 3 }]);
}

#[test]
fn binary_files_may_be_filled_up_with_zeros() {
    let plain = read_surface("a.glb", &samples::glb()).unwrap();
    let longer = [samples::glb(), vec![0, 0]].concat();
    assert_eq!(read_surface("a.glb", &longer).unwrap(), plain);
    let mut filled = samples::glb();
    let blank = filled.windows(8).position(|end| end.ends_with(b"BIN\0")).unwrap() - 1;
    assert_eq!(filled[blank], b' ');
    filled[blank] = 0;
    assert_eq!(read_surface("a.glb", &filled).unwrap(), plain);
}
