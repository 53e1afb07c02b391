//! `riemap render` and `riemap link`: from a session to a picture, and from a file to a link.

#![cfg(feature = "app")]
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use image::RgbImage;
use riemap::conformal::{Extension, Side};
use riemap::geometry::DVec2;
use riemap::mesh::{BarycentricPoint, Sizing, TriangleId};
use riemap::outline::{Preset, Sampling};
use riemap::session::{
    Colouring, Command as Change, OutlineSpec, Session, SurfaceShape, SurfaceSpec, TextureKind, file, link,
};
use riemap::surface::SurfacePreset;
use std::path::Path;
use support::program::{self, fails, file as written, folder, succeeds};

/// The picture of a link or file.
fn rendered(folder: &Path, link: &str, more: &[&str]) -> RgbImage {
    let out = folder.join("picture.png").display().to_string();
    let arguments = [&["render", link, "--size", "320x160", "--out", &out], more].concat();
    succeeds(&arguments);
    let picture = image::open(&out).unwrap().to_rgb8();
    std::fs::remove_file(&out).unwrap();
    assert_eq!(picture.dimensions(), (320, 160));
    picture
}

/// The default session with fewer samples: these tests do not check accuracy.
fn coarse() -> Session {
    let mut session = Session::default();
    for side in Side::BOTH {
        let mut settings = session.domain(side).settings;
        (settings.sampling, settings.sizing) = (Sampling::Adaptive { target: Some(200) }, Sizing::Graded(0.25));
        session.apply(Change::SetSettings { side, settings });
    }
    session
}

fn link_of(session: &Session) -> String {
    link::encode(session).unwrap().fragment
}

/// The number of pixels that differ visibly between two pictures.
fn differences(a: &RgbImage, b: &RgbImage) -> usize {
    let differs = |(p, q): (&image::Rgb<u8>, &image::Rgb<u8>)| p.0.iter().zip(q.0).any(|(&c, d)| c.abs_diff(d) > 8);
    a.pixels().zip(b.pixels()).filter(|&pair| differs(pair)).count()
}

/// The number of pixels of a half, left or right, that differ from the background.
fn drawn(picture: &RgbImage, half: u32) -> usize {
    let ground = *picture.get_pixel(0, 0);
    picture.enumerate_pixels().filter(|(x, _, pixel)| x / 160 == half && **pixel != ground).count()
}

#[test]
fn a_link_an_address_and_a_file_are_the_same_picture() {
    let folder = folder("same");
    let session = coarse();
    let fragment = link_of(&session);
    let picture = rendered(&folder, &fragment, &[]);
    assert_eq!(picture.get_pixel(0, 0).0, [13, 17, 23], "the app's dark ground");
    for half in 0..2 {
        let share = drawn(&picture, half) as f64 / (160.0 * 160.0);
        assert!((0.2..0.8).contains(&share), "half {half}: {share}");
    }
    let address = format!("https://example.org/riemap/#{fragment}");
    assert_eq!(rendered(&folder, &address, &[]), picture);
    let saved = written(&folder, "a.riemap", &file::write(&session).unwrap());
    assert_eq!(rendered(&folder, &saved, &[]), picture);
    let light = rendered(&folder, &fragment, &["--theme", "light"]);
    assert_eq!(light.get_pixel(0, 0).0, [255; 3]);
}

#[test]
fn every_setting_changes_the_picture() {
    let folder = folder("seen");
    let before = rendered(&folder, &link_of(&coarse()), &[]);
    for (name, change) in [
        ("point", Change::MoveInterior { side: Side::Source, point: DVec2::new(0.0, -0.3).into() }),
        ("anchor", Change::MoveAnchor { side: Side::Target, fraction: 0.4 }),
        ("grid", Change::SetTexture(TextureKind::Grid)),
        ("conformal", Change::SetTexture(TextureKind::Conformal)),
        ("scale", Change::SetTextureScale(12.0)),
        ("side", Change::SetTextureSide(Side::Target)),
        ("angle", Change::SetColouring(Colouring::Angle)),
        ("area", Change::SetColouring(Colouring::Area)),
        ("mesh", Change::SetWireframe(true)),
    ] {
        let mut session = coarse();
        session.apply(change);
        let changed = differences(&before, &rendered(&folder, &link_of(&session), &[]));
        println!("{name}: {changed} pixels");
        assert!(changed > 1000, "{name}: only {changed} pixels differ");
    }
    // the other extension differs little, but must be complete
    let mut session = coarse();
    session.apply(Change::SetExtension(Extension::CauchyGreen));
    let changed = differences(&before, &rendered(&folder, &link_of(&session), &[]));
    assert!(changed < 8000, "Cauchy–Green: {changed} pixels differ");
}

#[test]
fn a_surface_stands_on_the_right() {
    let folder = folder("surface");
    let shape = SurfaceShape::Preset { preset: SurfacePreset::Hemisphere, boundary: 60 };
    let mut session = coarse();
    session.apply(Change::SetSurface { side: Side::Target, surface: SurfaceSpec::new(shape) });
    let picture = rendered(&folder, &link_of(&session), &[]);
    let plane = rendered(&folder, &link_of(&coarse()), &[]);
    let half = |picture: &RgbImage, half: u32| image::imageops::crop_imm(picture, 160 * half, 0, 160, 160).to_image();
    // between outlines the mapped mesh is refined, which moves the pattern by less than what is seen
    let moved = differences(&half(&picture, 0), &half(&plane, 0));
    assert!(moved < 1000 && drawn(&picture, 0) > 5000, "{moved} pixels of the source differ");
    let changed = differences(&half(&picture, 1), &half(&plane, 1));
    assert!(changed > 3000 && drawn(&picture, 1) > 5000, "{changed} pixels differ");
    // the pattern of the disk has its own coordinates on both sides
    session.apply(Change::SetTexture(TextureKind::Conformal));
    let polar = rendered(&folder, &link_of(&session), &[]);
    for k in 0..2 {
        assert!(differences(&half(&polar, k), &half(&picture, k)) > 1000, "half {k}");
    }
    let mut planar = coarse();
    planar.apply(Change::SetTexture(TextureKind::Conformal));
    let planar = rendered(&folder, &link_of(&planar), &[]);
    let moved = differences(&half(&polar, 0), &half(&planar, 0));
    assert!(moved < 1000, "{moved} pixels of the source differ: it has the same disk coordinates with a surface");
}

#[test]
fn surfaces_stand_on_the_left_or_on_both_sides() {
    let folder = folder("surfaces");
    let surface = |side, preset| {
        let shape = SurfaceShape::Preset { preset, boundary: 60 };
        Change::SetSurface { side, surface: SurfaceSpec::new(shape) }
    };
    let left = coarse().and([surface(Side::Source, SurfacePreset::Hemisphere)]);
    let both = left.clone().and([surface(Side::Target, SurfacePreset::Hemisphere)]);
    let half = |picture: &RgbImage, half: u32| image::imageops::crop_imm(picture, 160 * half, 0, 160, 160).to_image();
    let [one, two] = [&left, &both].map(|session| rendered(&folder, &link_of(session), &[]));
    assert!(drawn(&one, 0) > 5000 && drawn(&one, 1) > 5000 && drawn(&two, 1) > 5000);
    assert!(differences(&half(&one, 0), &half(&two, 0)) > 1000, "the pattern lies in the heart, or in the disk");
    assert_eq!(half(&two, 0), half(&two, 1), "equal surfaces with equal points wear the same pattern");
    // the mapped one alone has the colours of the distortion
    let coloured = both.and([Change::SetColouring(Colouring::Angle)]);
    let coloured = rendered(&folder, &link_of(&coloured), &[]);
    assert_eq!(half(&coloured, 0), half(&two, 0));
    assert!(differences(&half(&coloured, 1), &half(&two, 1)) > 3000);
}

#[test]
fn surfaces_from_two_files_are_given_by_name_or_in_the_order_of_their_sides() {
    let folder = folder("surface-files");
    let pyramid = |height: f64| {
        format!("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 {height}\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n")
    };
    let low = written(&folder, "low.obj", &pyramid(0.25));
    let high = written(&folder, "high.obj", &pyramid(1.5));
    let surface = |side, name: &str| {
        let shape = SurfaceShape::File { name: name.into() };
        Change::SetSurface { side, surface: SurfaceSpec::new(shape) }
    };
    let link = link_of(&coarse().and([surface(Side::Source, "low.obj"), surface(Side::Target, "high.obj")]));
    let out = folder.join("x.csv").display().to_string();
    fails(&["render", &link, "--out", &out, "--surface", &low], 1, &["high.obj", "file"]);
    succeeds(&["render", &link, "--out", &out, "--surface", &low, "--surface", &high]);
    let table = std::fs::read_to_string(&out).unwrap();
    assert!(table.starts_with("s1 (share of arc length)") && table.contains("z2 (target units)"), "{table}");
    let out = folder.join("x.obj").display().to_string();
    succeeds(&["render", &link, "--out", &out, "--surface", &low, "--surface", &high]);
    let mesh = std::fs::read_to_string(&out).unwrap();
    assert!(mesh.contains("v 0.5 0.5 1.5\n") && mesh.matches("\nvt ").count() == 5, "{mesh}");
    let high_first = folder.join("y.obj").display().to_string();
    succeeds(&["render", &link, "--out", &high_first, "--surface", &high, "--surface", &low]);
    assert_eq!(std::fs::read_to_string(&high_first).unwrap(), mesh, "by name");
    let renamed = written(&folder, "renamed.obj", &pyramid(1.5));
    succeeds(&["render", &link, "--out", &high_first, "--surface", &renamed, "--surface", &low]);
    let renamed_mesh = std::fs::read_to_string(&high_first).unwrap();
    assert!(renamed_mesh.contains("v 0.5 0.5 1.5\n"), "the other one is left: {renamed_mesh}");
    let broken = written(&folder, "broken.obj", "v 0 0 nan");
    let files = ["--surface", low.as_str(), "--surface", &broken];
    fails(&[&["render", &link, "--out", &out][..], &files].concat(), 1, &["target: ", "broken.obj"]);
    let three = [&low, &high, &low].map(|name| ["--surface", name]).concat();
    fails(&[&["render", &link, "--out", &out][..], &three].concat(), 2, &["at most two"]);
}

#[test]
fn a_surface_from_a_file_is_asked_for() {
    let folder = folder("surface-file");
    let pyramid = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 0.7\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
    let path = written(&folder, "pyramid.obj", pyramid);
    let mut session = coarse();
    let shape = SurfaceShape::File { name: "pyramid.obj".into() };
    session.apply(Change::SetSurface { side: Side::Target, surface: SurfaceSpec::new(shape) });
    let link = link_of(&session);
    let out = folder.join("x.png").display().to_string();
    fails(&["render", &link, "--out", &out], 1, &["pyramid.obj", "file"]);
    assert!(drawn(&rendered(&folder, &link, &["--surface", &path]), 1) > 2000);
    // the given file's name appears in errors and determines the format
    let broken = written(&folder, "broken.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");
    fails(&["render", &link, "--out", &out, "--surface", &broken], 1, &["broken.off: line 6: a face names vertex 7"]);
    fails(&["render", &link_of(&coarse()), "--out", &out, "--surface", &path], 1, &["no surface"]);
    // a file name without a known extension has the format of the session's file name
    let upload = folder.join("upload.tmp");
    std::fs::copy(&path, &upload).unwrap();
    assert!(drawn(&rendered(&folder, &link, &["--surface", &upload.display().to_string()]), 1) > 2000);
}

#[test]
fn points_outside_of_the_domains_are_reported() {
    let folder = folder("moved");
    let out = folder.join("x.csv").display().to_string();
    let notes = |session: &Session| {
        let output = succeeds(&["render", &link_of(session), "--out", &out]);
        program::notes(&String::from_utf8(output.stderr).unwrap()).join("\n")
    };
    let mut session = coarse();
    session.apply(Change::MoveInterior { side: Side::Source, point: DVec2::new(0.1, 0.05).into() });
    assert_eq!(notes(&session), "");
    session.apply(Change::MoveInterior { side: Side::Target, point: DVec2::new(70.0, -3.0).into() });
    let note = notes(&session);
    assert!(note.starts_with("riemap: the target point (70, -3) is outside of the target outline"), "{note}");
    assert_eq!(note.lines().count(), 1, "{note}");
    let shape = SurfaceShape::Preset { preset: SurfacePreset::Hemisphere, boundary: 60 };
    session.apply(Change::SetSurface { side: Side::Target, surface: SurfaceSpec::new(shape) });
    assert_eq!(notes(&session), "", "the target's outline is not mapped");
    let mut with_point = |triangle| {
        let point = BarycentricPoint::new(TriangleId::new(triangle), [0.25, 0.25, 0.5]);
        session.apply(Change::MoveInterior { side: Side::Target, point: point.into() });
        notes(&session)
    };
    assert_eq!(with_point(200), "");
    let note = with_point(123_456);
    assert!(
        note.starts_with("riemap: (0.25, 0.25, 0.5) in triangle 123456 is no inner point of the surface"),
        "{note}"
    );
}

#[test]
fn an_outline_that_a_link_leaves_out_comes_from_a_file() {
    let folder = folder("left-out");
    // a notch within one row of the grid of a link, which has a step of 1.2e-7 and no row at 0
    let notch = [(1.0, 1e-8), (0.99, 1e-8), (0.99, 5e-8), (1.0, 5e-8)].map(DVec2::from);
    let rest = (1..40).map(|k| DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / 40.0));
    let points: Vec<DVec2> = notch.into_iter().chain(rest).collect();
    let outline = written(&folder, "rough.json", &serde_json::to_string(&points).unwrap());
    let mut session = coarse();
    session.apply(Change::SetOutline {
        side: Side::Source,
        outline: OutlineSpec::points("rough".into(), points.try_into().unwrap()),
    });
    session.apply(Change::MoveInterior { side: Side::Source, point: DVec2::new(0.3, 0.1).into() });
    session.apply(Change::MoveAnchor { side: Side::Source, fraction: 0.3 });
    let saved = written(&folder, "rough.riemap", &file::write(&session).unwrap());
    let output = succeeds(&["link", &saved]);
    let notes = String::from_utf8(output.stderr).unwrap();
    assert!(notes.contains("\"rough\"") && notes.contains("file"), "{notes}");
    let link = String::from_utf8(output.stdout).unwrap();
    let out = folder.join("x.png").display().to_string();
    fails(&["render", &link, "--out", &out], 1, &["rough", "--source"]);
    assert_eq!(rendered(&folder, &link, &["--source", &outline]), rendered(&folder, &saved, &[]));
    fails(&["render", &saved, "--out", &out, "--source", &outline], 2, &["--source"]);
}

#[test]
fn an_outline_that_is_too_long_for_a_link_has_fewer_points_there() {
    let folder = folder("shortened");
    let points: Vec<DVec2> = (0..12_000)
        .map(|k: u32| {
            let noise = f64::from(k.wrapping_mul(2_654_435_761) >> 16) / 65536.0;
            DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / 12_000.0) * (1.0 + 0.002 * noise)
        })
        .collect();
    let mut session = coarse();
    let outline = OutlineSpec::points("rough".into(), points.try_into().unwrap());
    session.apply(Change::SetOutline { side: Side::Source, outline });
    let saved = written(&folder, "rough.riemap", &file::write(&session).unwrap());
    let output = succeeds(&["link", &saved]);
    let notes = String::from_utf8(output.stderr).unwrap();
    assert!(notes.contains("\"rough\"") && notes.contains("12000 points") && notes.contains("\u{a0}%"), "{notes}");
    let link = String::from_utf8(output.stdout).unwrap();
    assert!(link.trim().len() <= link::MAX_LENGTH && link::decode(&link).unwrap().missing.is_empty());
}

#[test]
fn a_session_file_with_everything_is_rendered() {
    let folder = folder("archive");
    let surface = "v 0 0 0\nv 1 0 0\nv 2 0 0.3\nv 0 1 0\nv 1 1 0.4\nv 2 1 0\nv 0 2 0\nv 1 2 0\nv 2 2 0.2\n\
                   f 1 2 5 4\nf 2 3 6 5\nf 4 5 8 7\nf 5 6 9 8\n";
    let shape = SurfaceShape::File { name: "tile.obj".into() };
    let session = coarse().and([
        Change::SetSurface { side: Side::Target, surface: SurfaceSpec::new(shape) },
        Change::SetTexture(TextureKind::Image),
    ]);
    let picture = image::RgbaImage::from_fn(8, 8, |x, y| image::Rgba([200, 30 * x as u8, 30 * y as u8, 255]));
    let mut png = std::io::Cursor::new(Vec::new());
    picture.write_to(&mut png, image::ImageFormat::Png).unwrap();
    let attachment = |name: &str, bytes: Vec<u8>| file::Attachment { name: name.into(), bytes: bytes.into() };
    let mut archive = file::Archive::from(session.clone());
    archive.surfaces.push(attachment("tile.obj", surface.into()));
    let checked = folder.join("checked.riemap");
    std::fs::write(&checked, archive.write().unwrap()).unwrap();
    archive.picture = Some(attachment("own.png", png.into_inner()));
    let whole = folder.join("whole.riemap");
    std::fs::write(&whole, archive.write().unwrap()).unwrap();
    let [checked, whole] = [checked, whole].map(|path| path.display().to_string());
    assert_ne!(rendered(&folder, &whole, &[]), rendered(&folder, &checked, &[]), "the own picture is drawn");
    // a part that is missing is named
    let out = folder.join("x.png").display().to_string();
    let alone = written(&folder, "alone.riemap", &file::write(&session).unwrap());
    fails(&["render", &alone, "--out", &out], 1, &["tile.obj"]);
    let cut = std::fs::read(&whole).unwrap();
    let broken = folder.join("broken.riemap");
    std::fs::write(&broken, &cut[..cut.len() / 2]).unwrap();
    fails(&["render", &broken.display().to_string(), "--out", &out], 1, &["broken.riemap", "damaged"]);
}

#[test]
fn a_file_s_link_is_printed() {
    let folder = folder("link");
    let mut session = coarse();
    session.apply(Change::SetOutline { side: Side::Target, outline: OutlineSpec::Preset(Preset::Star) });
    let saved = written(&folder, "star.riemap", &file::write(&session).unwrap());
    let output = succeeds(&["link", &saved]);
    assert!(output.stderr.is_empty());
    let printed = String::from_utf8(output.stdout).unwrap();
    assert_eq!(link::decode(&printed).unwrap().session, session, "{printed}");
}

#[test]
fn sessions_that_cannot_be_opened_are_explained() {
    let folder = folder("refused");
    let out = folder.join("x.png").display().to_string();
    let fragment = link_of(&coarse());
    let at_out = |link: &str, words: &[&str]| fails(&["render", link, "--out", &out], 1, words);
    at_out(&fragment[..fragment.len() - 3], &["damaged"]);
    at_out("https://example.org/#s=3.AAAA", &["format 3"]);
    at_out("nowhere.riemap", &["nowhere.riemap"]);
    at_out(&written(&folder, "other.riemap", "{\"a\": 1}"), &["other.riemap", "no session"]);
    fails(&["render", &fragment, "--out", "x.jpg"], 2, &["png"]);
    fails(&["render", &fragment], 2, &["--out"]);
    assert!(!folder.join("x.png").exists());
}
