//! Exported files: `riemap render` in every format, checked by reading the files back.

#![cfg(feature = "app")]
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use riemap::conformal::{PrepareSettings, Side};
use riemap::outline::{self, Preset, Sampling};
use riemap::render::FilmFormat;
use riemap::session::{Command as Change, OutlineSpec, Session, SurfaceShape, SurfaceSpec, TextureKind, file, link};
use riemap::surface::{SurfacePreset, read_surface};
use std::path::Path;
use support::program::{fails, folder, succeeds};

fn link(session: &Session) -> String {
    link::encode(session).unwrap().fragment
}

fn surface_session() -> Session {
    let mut session = Session::default();
    let shape = SurfaceShape::Preset { preset: SurfacePreset::Hemisphere, boundary: 60 };
    session.apply(Change::SetSurface { side: Side::Target, surface: SurfaceSpec::new(shape) });
    session
}

/// Runs a command that writes `name`, and reads the file.
fn written(folder: &Path, name: &str, arguments: &[&str]) -> Vec<u8> {
    let out = folder.join(name).display().to_string();
    succeeds(&[arguments, &["--out", &out]].concat());
    std::fs::read(out).unwrap()
}

#[test]
fn a_planar_session_is_written_in_every_format() {
    let folder = folder("planar");
    let mut session = Session::default();
    session.apply(Change::SetTexture(TextureKind::Conformal));
    session.apply(Change::SetWireframe(true));
    let link = link(&session);
    let svg = written(&folder, "map.svg", &["render", &link]);
    let text = String::from_utf8(svg.clone()).unwrap();
    for class in ["outline", "mesh", "lines", "interior", "boundary"] {
        assert!(text.matches(&format!("class=\"{class}\"")).count() >= 2, "{class}");
    }
    assert_eq!(outline::parse("map.svg", &svg).unwrap().name(), "source");
    let one = written(&folder, "one.svg", &["render", &link, "--side", "target"]);
    assert_eq!(outline::parse("one.svg", &one).unwrap().name(), "target");
    let csv = String::from_utf8(written(&folder, "map.csv", &["render", &link])).unwrap();
    assert!(csv.starts_with("s1 (share of arc length),s2"), "{}", csv.lines().next().unwrap());
    assert!(csv.lines().count() > 500);
    let obj = read_surface("map.obj", &written(&folder, "map.obj", &["render", &link])).unwrap();
    assert!(obj.triangles().len() > 1000);
    fails(&["render", &link, "--out", "map.glb"], 1, &[".glb", ".svg"]);
}

#[test]
fn a_surface_session_is_written_with_its_texture_coordinates() {
    let folder = folder("surface");
    let link = link(&surface_session());
    let shown = SurfacePreset::Hemisphere.surface(60).unwrap();
    for format in ["obj", "ply", "glb"] {
        let name = format!("map.{format}");
        let surface = read_surface(&name, &written(&folder, &name, &["render", &link])).unwrap();
        assert_eq!(surface.triangles().len(), shown.triangles().len(), "{name}");
    }
    let csv = String::from_utf8(written(&folder, "map.csv", &["render", &link])).unwrap();
    assert!(csv.starts_with("x,y,z,u,v\n"));
    assert!(written(&folder, "map.svg", &["render", &link]).starts_with(b"<svg"));
}

#[test]
fn a_transparent_picture_has_no_ground() {
    let folder = folder("transparent");
    for (session, name) in [(Session::default(), "plane"), (surface_session(), "surface")] {
        let link = link(&session);
        let arguments = ["render", &link, "--size", "320x200"];
        let opaque = written(&folder, &format!("{name}-opaque.png"), &arguments);
        let opaque = image::load_from_memory(&opaque).unwrap().into_rgba8();
        let transparent = [&arguments[..], &["--transparent"]].concat();
        let transparent = written(&folder, &format!("{name}-transparent.png"), &transparent);
        let transparent = image::load_from_memory(&transparent).unwrap().into_rgba8();
        for [x, y] in [[0, 0], [319, 0], [0, 199], [319, 199]] {
            assert_eq!(transparent.get_pixel(x, y).0[3], 0, "{name}: the corner {x}, {y}");
            assert_eq!(opaque.get_pixel(x, y).0[3], 255, "{name}");
        }
        let inside = transparent.pixels().zip(opaque.pixels()).filter(|(pixel, _)| pixel.0[3] == 255);
        let differences = inside.filter(|(a, b)| a.0.iter().zip(b.0).any(|(a, b)| a.abs_diff(b) > 2)).count();
        assert!(differences < 20, "{name}: {differences} opaque pixels differ");
        assert!(transparent.pixels().filter(|pixel| pixel.0[3] == 255).count() > 5000, "{name}");
    }
}

#[test]
fn one_side_alone_fills_the_picture() {
    let folder = folder("side");
    let path = folder.join("session.riemap");
    std::fs::write(&path, file::write(&Session::default()).unwrap()).unwrap();
    let path = path.display().to_string();
    let arguments = ["render", &path, "--size", "200x200", "--transparent", "--side"];
    let [source, target] = ["source", "target"].map(|side| {
        let bytes = written(&folder, &format!("{side}.png"), &[&arguments[..], &[side]].concat());
        image::load_from_memory(&bytes).unwrap().into_rgba8()
    });
    assert_ne!(source, target);
    for picture in [source, target] {
        let rows = |y: u32| (0..200).any(|x| picture.get_pixel(x, y).0[3] == 255);
        assert!(rows(30) && rows(170), "it is as high as the picture");
    }
}

#[test]
fn a_picture_without_dots_has_none_and_is_the_same_elsewhere() {
    let folder = folder("dots");
    for (session, name) in [(Session::default(), "plane"), (surface_session(), "surface")] {
        let link = link(&session);
        let arguments = ["render", &link, "--size", "1200x600"];
        let with = written(&folder, &format!("{name}-with.png"), &arguments);
        let without = written(&folder, &format!("{name}-without.png"), &[&arguments[..], &["--no-dots"]].concat());
        let [with, without] = [with, without].map(|bytes| image::load_from_memory(&bytes).unwrap().into_rgba8());
        let is_dot = |pixel: &image::Rgba<u8>| {
            let near = |ink: [u8; 3]| pixel.0.iter().zip(ink).all(|(a, b)| a.abs_diff(b) < 6);
            near([0, 158, 115]) || near([214, 60, 166])
        };
        let dots = |picture: &image::RgbaImage| picture.pixels().filter(|pixel| is_dot(pixel)).count();
        assert!(dots(&with) > 30 && dots(&without) == 0, "{name}: {} {}", dots(&with), dots(&without));
        let differing = with.pixels().zip(without.pixels()).filter(|(a, b)| a != b).count();
        assert!(differing < 3000, "{name}: {differing} pixels differ");
    }
}

#[test]
fn requests_that_make_no_sense_are_refused() {
    let link = link(&Session::default());
    fails(&["render", &link, "--out", "map.svg", "--no-dots"], 2, &["--no-dots"]);
    fails(&["render", &link, "--out", "map.svg", "--transparent"], 2, &["--transparent"]);
    fails(&["render", &link, "--out", "map.docx"], 2, &["extension", "svg"]);
    fails(&["render", &link, "--out", "map.png", "--side", "left"], 2, &["left"]);
}

/// The frames of an animation, decoded.
fn frames(format: FilmFormat, bytes: &[u8]) -> Vec<image::Frame> {
    use image::AnimationDecoder;
    let bytes = std::io::Cursor::new(bytes);
    if format == FilmFormat::Gif {
        return image::codecs::gif::GifDecoder::new(bytes).unwrap().into_frames().collect_frames().unwrap();
    }
    let decoder = image::codecs::png::PngDecoder::new(bytes).unwrap();
    decoder.apng().unwrap().into_frames().collect_frames().unwrap()
}

#[test]
fn an_animation_has_its_frames_and_begins_at_the_session() {
    let folder = folder("animation");
    let link = link(&Session::default());
    let picture = written(&folder, "picture.png", &["render", &link, "--size", "240x120"]);
    let picture = image::load_from_memory(&picture).unwrap().into_rgba8();
    let (png, gif) = (FilmFormat::Png, FilmFormat::Gif);
    for (format, path) in [(png, "interior"), (gif, "boundary"), (png, "target-interior"), (gif, "both")] {
        let name = &format!("{path}.{}", format.extension());
        let arguments = ["animate", &link, "--size", "240x120", "--frames", "4", "--seconds", "1", "--path", path];
        let frames = frames(format, &written(&folder, name, &arguments));
        assert_eq!(frames.len(), 4, "{name}");
        if format == png {
            let first = frames[0].buffer().pixels().zip(picture.pixels());
            let differing = first.filter(|(a, b)| a.0.iter().zip(b.0).any(|(a, b)| a.abs_diff(b) > 2)).count();
            assert!(differing < 30, "{name}: {differing} pixels of the first frame are not the session's");
        }
        for (k, pair) in frames.windows(2).enumerate() {
            let moved = pair[0].buffer().pixels().zip(pair[1].buffer().pixels()).filter(|(a, b)| a != b).count();
            assert!(moved > 300, "{name}: only {moved} pixels change after frame {k}");
        }
    }
}

#[test]
fn a_surface_is_animated_too_on_a_transparent_background() {
    let folder = folder("surface animation");
    let link = link(&surface_session());
    let arguments = ["animate", &link, "--size", "160x80", "--frames", "3", "--transparent", "--side", "target"];
    let frames = frames(FilmFormat::Png, &written(&folder, "a.png", &arguments));
    assert_eq!(frames.len(), 3);
    assert!(frames.iter().all(|frame| frame.buffer().get_pixel(0, 0).0[3] == 0));
    assert_ne!(frames[0].buffer(), frames[1].buffer());
    fails(&["animate", &link, "--out", "a.png", "--path", "target-interior"], 2, &["surface"]);
}

#[test]
fn animations_that_cannot_be_are_refused() {
    let link = link(&Session::default());
    fails(&["animate", &link, "--out", "a.webm"], 2, &["png", "gif"]);
    fails(&["animate", &link, "--out", "a.gif", "--frames", "1"], 2, &["1 frame:"]);
    fails(&["animate", &link, "--out", "a.gif", "--frames", "100", "--seconds", "1"], 2, &["at most 50"]);
    fails(&["animate", &link, "--out", "a.png", "--path", "sideways"], 2, &["sideways", "boundary"]);
}

/// As the session's own pattern and by the option: tiles as closed paths on both sides, mirrors as open ones; pictures.
#[test]
fn a_tiling_is_written_as_paths_and_pictures() {
    let folder = folder("tiling");
    let disks = |side| Change::SetOutline { side, outline: OutlineSpec::Preset(Preset::Disk) };
    let few = PrepareSettings::default().with_sampling(Sampling::Adaptive { target: Some(250) });
    let settings = |side| Change::SetSettings { side, settings: few };
    let plain = Session::with(Side::BOTH.map(disks)).and(Side::BOTH.map(settings));
    let tiled = link(&plain.clone().and([Change::SetTexture(TextureKind::Tiling)]));
    let text = |name: &str, arguments: &[&str]| String::from_utf8(written(&folder, name, arguments)).unwrap();
    let own = text("own.svg", &["render", &tiled]);
    let plain = link(&plain);
    assert_eq!(own, text("option.svg", &["render", &plain, "--tiling", "7,3"]));
    let closed = |text: &str| text.matches("Z\"/>").count();
    assert!(closed(&own) > 600 && own.matches("class=\"lines\"").count() == 4, "{} closed paths", closed(&own));
    let mirrors = text("mirrors.svg", &["render", &plain, "--tiling", "7,3,triangles"]);
    assert_eq!(closed(&mirrors), closed(&own));
    assert!(mirrors.matches("<path").count() > 14 * (closed(&own) - 2), "fourteen mirrors a tile");
    let picture = |name, tiling| written(&folder, name, &["render", &plain, "--size", "240x120", "--tiling", tiling]);
    assert_ne!(picture("tiles.png", "4,6"), picture("edges.png", "4,6,edges"));
    for (tiling, words) in [("4,4", "lives in the plane"), ("3,5", "icosahedron"), ("7", "P,Q"), ("7,3,big", "style")] {
        fails(&["render", &plain, "--tiling", tiling, "--out", "x.png"], 2, &[words]);
    }
}
