//! GLB files of flattened surfaces: the container, the buffer and what the accessors promise, checked byte by byte as
//! the glTF 2.0 specification demands.

#![cfg(feature = "app")]
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

mod support;

use riemap::conformal::{
    ConformalMap, Constraints, MapSettings, PrepareSettings, SurfaceSettings, prepare, prepare_surface,
};
use riemap::export::{Base, Flattened};
use riemap::geometry::DVec2;
use riemap::outline::Preset;
use riemap::surface::{SurfaceMesh, SurfacePreset};
use serde_json::Value;
use std::sync::Arc;
use support::program::{folder, succeeds};

/// The JSON and the buffer of a GLB; asserts what every file must have.
fn parsed(bytes: &[u8]) -> (Value, Vec<u8>) {
    let number = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!((&bytes[..4], number(4), number(8)), (&b"glTF"[..], 2, bytes.len()));
    let json = number(12);
    assert_eq!((&bytes[16..20], json % 4), (&b"JSON"[..], 0));
    let document: Value = serde_json::from_slice(&bytes[20..20 + json]).unwrap();
    let binary = number(20 + json);
    assert_eq!((&bytes[24 + json..28 + json], binary % 4), (&b"BIN\0"[..], 0));
    let buffer = bytes[28 + json..].to_vec();
    assert_eq!((buffer.len(), size(&document["buffers"][0]["byteLength"])), (binary, binary));
    check_views(&document, binary);
    for accessor in document["accessors"].as_array().unwrap() {
        check_accessor(&document, accessor, &buffer);
    }
    (document, buffer)
}

fn size(value: &Value) -> usize {
    value.as_u64().unwrap() as usize
}

/// Views follow each other without overlap, aligned, within the buffer.
fn check_views(document: &Value, binary: usize) {
    let mut end = 0;
    for view in document["bufferViews"].as_array().unwrap() {
        let offset = size(&view["byteOffset"]);
        assert!(offset >= end && offset.is_multiple_of(4), "{view}");
        end = offset + size(&view["byteLength"]);
        assert!(end <= binary, "{view}");
    }
}

/// The numbers of an accessor fill its view; all are finite; bounds are exact.
fn check_accessor(document: &Value, accessor: &Value, buffer: &[u8]) {
    let width = match accessor["type"].as_str().unwrap() {
        "SCALAR" => 1,
        "VEC2" => 2,
        "VEC3" => 3,
        other => panic!("{other}"),
    };
    let view = &document["bufferViews"][size(&accessor["bufferView"])];
    assert_eq!(size(&view["byteLength"]), 4 * width * size(&accessor["count"]), "{accessor}");
    if size(&accessor["componentType"]) == 5125 {
        return;
    }
    let values = floats(document, accessor, buffer);
    assert!(values.iter().all(|value| value.is_finite()), "{accessor}");
    if !accessor["min"].is_null() {
        for axis in 0..width {
            let along = values.iter().skip(axis).step_by(width);
            let (low, high) = along.fold((f32::MAX, f32::MIN), |(low, high), &x| (low.min(x), high.max(x)));
            let said = ["min", "max"].map(|key| accessor[key][axis].as_f64().unwrap());
            assert_eq!(said, [f64::from(low), f64::from(high)], "{accessor}");
        }
    }
}

fn bytes_of<'a>(document: &Value, view: usize, buffer: &'a [u8]) -> &'a [u8] {
    let view = &document["bufferViews"][view];
    &buffer[size(&view["byteOffset"])..][..size(&view["byteLength"])]
}

fn floats(document: &Value, accessor: &Value, buffer: &[u8]) -> Vec<f32> {
    let bytes = bytes_of(document, size(&accessor["bufferView"]), buffer);
    bytes.chunks(4).map(|four| f32::from_le_bytes(four.try_into().unwrap())).collect()
}

fn attribute(document: &Value, buffer: &[u8], name: &str) -> Vec<f32> {
    let primitive = &document["meshes"][0]["primitives"][0];
    let accessor = size(&primitive["attributes"][name]);
    floats(document, &document["accessors"][accessor], buffer)
}

fn indices(document: &Value, buffer: &[u8]) -> Vec<usize> {
    let accessor = &document["accessors"][size(&document["meshes"][0]["primitives"][0]["indices"])];
    let bytes = bytes_of(document, size(&accessor["bufferView"]), buffer);
    bytes.chunks(4).map(|four| u32::from_le_bytes(four.try_into().unwrap()) as usize).collect()
}

/// Unit normals that point to the side from which the triangles are counter-clockwise.
fn check_normals(document: &Value, buffer: &[u8]) {
    let (places, normals) = (attribute(document, buffer, "POSITION"), attribute(document, buffer, "NORMAL"));
    assert_eq!(places.len(), normals.len());
    let vector = |values: &[f32], v: usize| glam(&values[3 * v..3 * v + 3]);
    for v in 0..normals.len() / 3 {
        assert!((vector(&normals, v).length() - 1.0).abs() < 1e-5);
    }
    let mut against = 0;
    for corners in indices(document, buffer).chunks(3) {
        let [a, b, c] = [0, 1, 2].map(|i| vector(&places, corners[i]));
        let normal = (b - a).cross(c - a);
        against += corners.iter().filter(|&&v| normal.dot(vector(&normals, v)) <= 0.0).count();
    }
    assert_eq!(against, 0);
}

fn glam(values: &[f32]) -> riemap::geometry::DVec3 {
    riemap::geometry::DVec3::new(f64::from(values[0]), f64::from(values[1]), f64::from(values[2]))
}

#[test]
fn a_surface_over_a_square_has_normals_a_material_and_its_new_vertices() {
    let folder = folder("plain");
    let out = folder.join("uv.glb").display().to_string();
    let arguments = ["flatten", "preset:saddle:40", "preset:square", "--samples", "200", "--out", &out, "--json"];
    let summary: Value = serde_json::from_slice(&succeeds(&arguments).stdout).unwrap();
    let (document, buffer) = parsed(&std::fs::read(&out).unwrap());
    check_normals(&document, &buffer);
    let material = &document["materials"][0];
    assert_eq!(material["doubleSided"], true);
    assert!(material["pbrMetallicRoughness"]["baseColorFactor"].is_array());
    assert!(document["images"].is_null());
    let coordinates = attribute(&document, &buffer, "TEXCOORD_0");
    for corner in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
        assert!(coordinates.chunks(2).any(|uv| uv == corner), "{corner:?} is not hit");
    }
    let divisions = &document["meshes"][0]["extras"]["divisions"];
    assert_eq!((divisions, &summary["corners"]["hit"]), (&summary["corners"]["divisions"], &4.into()));
    assert!(!divisions.as_array().unwrap().is_empty());
    let count = attribute(&document, &buffer, "POSITION").len() / 3;
    assert!(indices(&document, &buffer).iter().all(|&v| v < count));
}

#[test]
fn a_picture_is_inside_and_looked_up_where_it_lies() {
    let settings = PrepareSettings::default();
    let source = Arc::new(prepare(Preset::Disk.outline().polygon(), &settings, &mut |_| ()).unwrap());
    let mesh = SurfaceMesh::new(&SurfacePreset::Hemisphere.surface(40).unwrap()).unwrap();
    let target = Arc::new(prepare_surface(mesh, SurfaceSettings::default(), &mut |_| ()).unwrap());
    let constraints = Constraints::new((source.default_point(), 0.0), (target.default_point(), 0.0));
    let map = ConformalMap::new(source, target, &constraints, MapSettings::default()).unwrap();
    // any bytes: the length is no multiple of 4
    let png = b"\x89PNG\r\n\x1a\n and so on";
    let lookup = |place: DVec2| DVec2::new(2.0 * place.x, 3.0 - place.y);
    for unit in [true, false] {
        let flattened = Flattened::new(&map, unit).unwrap();
        let (document, buffer) = parsed(&flattened.glb(Some(&Base { png, lookup: &lookup })));
        check_normals(&document, &buffer);
        let view = size(&document["images"][0]["bufferView"]);
        assert_eq!(
            (bytes_of(&document, view, &buffer), &document["images"][0]["mimeType"]),
            (&png[..], &"image/png".into())
        );
        assert_eq!(document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"], 0);
        assert_eq!((&document["textures"][0]["source"], &document["textures"][0]["sampler"]), (&0.into(), &0.into()));
        let looked_up = attribute(&document, &buffer, "TEXCOORD_0");
        for (image, uv) in map.texture_coordinates().iter().zip(looked_up.chunks(2)) {
            let expected = lookup(image.unwrap());
            let off = (expected.x - f64::from(uv[0])).abs().max((expected.y - f64::from(uv[1])).abs());
            assert!(off < 1e-6, "{expected} and {uv:?}");
        }
        assert_eq!(attribute(&document, &buffer, "TEXCOORD_1").len(), looked_up.len());
    }
}
