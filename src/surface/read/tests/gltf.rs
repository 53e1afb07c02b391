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
