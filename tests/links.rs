//! Links carry sessions: every setting is restored, and no text that can be written into an address
//! bar causes a panic, a hang, or large memory use.

#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use proptest::prelude::*;
use riemap::conformal::{Direction, Extension, KernelMode, PrepareSettings, Side, SurfaceSettings};
use riemap::geometry::{Bounds, DVec2, SimplePolygon};
use riemap::laplace::SolverKind;
use riemap::mesh::{BarycentricPoint, Sizing, TriangleId};
use riemap::outline::{CurveForm, Preset, Sampling};
use riemap::session::lesson::{self, Lesson, LessonError, Step};
use riemap::session::link::{Decoded, MAX_LENGTH, MissingOutline, decode, encode};
use riemap::session::{
    CELLS, Colouring, Command, Comparison, DomainSpec, GROWTH, Holes, OutlineSpec, SAMPLES, SURFACE_BOUNDARY, Session,
    SidePoints, SurfaceShape, SurfaceSpec, SurfaceState, TextureKind, file,
};
use riemap::surface::SurfacePreset;
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};
use std::alloc::System;
use std::sync::{Mutex, MutexGuard};
use support::random::runner;

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// Lets one test run at a time, since the allocator counts for all threads.
fn alone() -> MutexGuard<'static, ()> {
    static LOCK: Mutex<()> = Mutex::new(());
    LOCK.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
}

fn one_of<T: Clone + std::fmt::Debug + 'static>(all: &[T]) -> impl Strategy<Value = T> + use<T> {
    prop::sample::select(all.to_vec())
}

/// Star-shaped, anywhere, of any size; sometimes too fine for 16 bits, sometimes too long for a link.
fn drawn() -> impl Strategy<Value = OutlineSpec> {
    let corners = prop_oneof![
        9 => prop::collection::vec((-2.5_f64..0.0, 0.05_f64..0.95), 5..300),
        1 => prop::collection::vec((-2.5_f64..0.0, 0.05_f64..0.95), 2000..6000),
    ];
    let name = "[a-zA-Z äöü\u{1}\u{1F600}]{0,60}";
    (corners, name, -9_i32..9, -100.0..100.0, -1.0..1.0).prop_map(|(corners, name, exponent, x, y)| {
        let step = std::f64::consts::TAU / corners.len() as f64;
        let corner = |(k, (exponent, turn)): (usize, &(f64, f64))| {
            10_f64.powf(*exponent) * DVec2::from_angle(step * (k as f64 + turn))
        };
        let scale = 10_f64.powi(exponent);
        let points = corners.iter().enumerate().map(corner).map(|p| scale * (p + DVec2::new(x, y)));
        // as from a file or link older than curves
        let polygon: SimplePolygon = points.collect::<Vec<_>>().try_into().unwrap();
        let form = CurveForm::of_polygon(&polygon);
        OutlineSpec::Points { name, polygon, form }
    })
}

fn domain() -> impl Strategy<Value = DomainSpec> {
    let outline = prop_oneof![one_of(&Preset::ALL).prop_map(OutlineSpec::Preset), drawn()];
    let sampling = prop_oneof![
        prop::option::of(SAMPLES).prop_map(|target| Sampling::Adaptive { target }),
        (SAMPLES, any::<bool>()).prop_map(|(count, keep_corners)| Sampling::Uniform { count, keep_corners }),
    ];
    let sizing = prop_oneof![Just(Sizing::Uniform), GROWTH.prop_map(Sizing::Graded)];
    (outline, sampling, sizing, kernel(), solver()).prop_map(|(outline, sampling, sizing, kernel, solver)| {
        DomainSpec::new(outline, PrepareSettings::new(sampling, sizing).with_kernel(kernel).with_solver(solver))
    })
}

fn kernel() -> impl Strategy<Value = KernelMode> {
    one_of(&[KernelMode::Adjoint, KernelMode::Table, KernelMode::Integral])
}

fn solver() -> impl Strategy<Value = SolverKind> {
    one_of(&[SolverKind::Direct, SolverKind::Pcg])
}

/// A surface and its points.
fn surface() -> impl Strategy<Value = (SurfaceSpec, SidePoints)> {
    let shape = prop_oneof![
        (one_of(&SurfacePreset::ALL), SURFACE_BOUNDARY)
            .prop_map(|(preset, boundary)| SurfaceShape::Preset { preset, boundary }),
        "[a-z]{1,20}\\.obj".prop_map(|name| SurfaceShape::File { name }),
    ];
    let settings = (any::<bool>(), kernel(), solver()).prop_map(|(flips, kernel, solver)| {
        SurfaceSettings::default().with_intrinsic_delaunay(flips).with_kernel(kernel).with_solver(solver)
    });
    let point = (any::<u32>(), 0.0..1.0, 0.0..1.0).prop_map(|(triangle, a, b): (u32, f64, f64)| {
        let weights = [a * b, a * (1.0 - b), 1.0 - a];
        BarycentricPoint::new(TriangleId::new(triangle), weights)
    });
    (shape, (any::<bool>(), prop_oneof![Just(0), any::<u16>()]), settings, prop::option::of(point), 0.0..1.0).prop_map(
        |(shape, (repair, outline_loop), settings, interior, anchor)| {
            (
                SurfaceSpec::new(shape).with_repair(repair).with_outline_loop(outline_loop).with_settings(settings),
                SidePoints::Surface { interior, anchor },
            )
        },
    )
}

/// The commands that set up a side: an outline with its points, and optionally a surface.
fn side(side: Side) -> impl Strategy<Value = Vec<Command>> {
    let point = prop::option::of((-1e9..1e9, -1.0..1.0).prop_map(DVec2::from));
    let holes = one_of(&[Holes::Filled, Holes::Open]);
    let parts = (domain(), point, 0.0..1.0, prop::option::of((surface(), holes)));
    parts.prop_map(move |(domain, interior, anchor, surface)| {
        let DomainSpec { outline, settings, .. } = domain;
        let mut commands = vec![
            Command::SetOutline { side, outline },
            Command::SetSettings { side, settings },
            Command::PlacePoints { side, points: SidePoints::Outline { interior, anchor } },
        ];
        if let Some(((surface, points), holes)) = surface {
            let points = Command::PlacePoints { side, points };
            commands.extend([Command::SetSurface { side, surface }, Command::SetHoles { side, holes }, points]);
        }
        commands
    })
}

fn session() -> impl Strategy<Value = Session> {
    let textures =
        [TextureKind::Checker, TextureKind::Grid, TextureKind::Polar, TextureKind::Conformal, TextureKind::Image];
    let comparisons = [Comparison::Off, Comparison::Fresh, Comparison::Precomputed, Comparison::Both];
    let drawn = (
        one_of(&[Direction::Forward, Direction::Backward]).prop_map(Command::SetDirection),
        one_of(&[Extension::Harmonic, Extension::CauchyGreen, Extension::Exact]).prop_map(Command::SetExtension),
        one_of(&textures).prop_map(Command::SetTexture),
        CELLS.prop_map(Command::SetTextureScale),
        one_of(&Side::BOTH).prop_map(Command::SetTextureSide),
        one_of(&[Colouring::Texture, Colouring::Angle, Colouring::Area]).prop_map(Command::SetColouring),
        any::<bool>().prop_map(Command::SetWireframe),
        any::<bool>().prop_map(Command::SetPlots),
        one_of(&comparisons).prop_map(Command::SetComparison),
    );
    (side(Side::Source), side(Side::Target), drawn).prop_map(|(source, target, drawn)| {
        let (direction, extension, texture, scale, home, colouring, wireframe, plots, comparison) = drawn;
        let drawn = [direction, extension, texture, scale, home, colouring, wireframe, plots, comparison];
        Session::with(source.into_iter().chain(target).chain(drawn))
    })
}

/// Whether every point of `points` has one of `found` within half a step of the 16-bit grid, plus rounding.
fn is_quantised(points: &[DVec2], found: &[DVec2]) -> bool {
    let bounds = Bounds::of(points.iter().copied());
    let step = bounds.size() / 65535.0;
    // the coordinates' own rounding matters far from the origin
    let half = 0.5 * step + 4.0 * f64::EPSILON * bounds.min().abs().max(bounds.max().abs());
    points.iter().all(|p| found.iter().any(|q| (*p - *q).abs().cmple(half).all()))
}

#[test]
fn a_session_comes_back_and_the_second_time_exactly() {
    let _alone = alone();
    let [carried, missed, shortened, second] = std::array::from_fn(|_| std::cell::Cell::new(0));
    runner(300)
        .run(&session(), |session| {
            let encoded = encode(&session).unwrap();
            prop_assert!(encoded.fragment.len() <= MAX_LENGTH);
            let Decoded { session: found, missing, .. } = decode(&encoded.fragment).unwrap();
            let left_out: Vec<Side> = encoded.left_out.iter().map(|outline| outline.side).collect();
            prop_assert_eq!(missing.iter().map(|outline| outline.side).collect::<Vec<_>>(), left_out.clone());
            let mut expected = session.clone();
            for outline in &missing {
                let &MissingOutline { side, interior, anchor, .. } = outline;
                prop_assert_eq!(SidePoints::Outline { interior, anchor }, session.side(side).outline_points());
                let points = SidePoints::Outline { interior: None, anchor: 0.0 };
                expected.apply(Command::PlacePoints { side, points });
            }
            for side in Side::BOTH {
                let (given, got) = (&session.domain(side).outline, &found.domain(side).outline);
                if let OutlineSpec::Points { polygon, .. } = given {
                    let short = encoded.shortened.iter().find(|outline| outline.side == side);
                    if let (OutlineSpec::Points { polygon: on_grid, .. }, Some(short)) = (got, short) {
                        let counts = (polygon.vertices().len(), on_grid.vertices().len());
                        prop_assert_eq!(counts, (short.from, short.to));
                        prop_assert!(short.to < short.from && (0.0..1.0).contains(&short.deviation));
                        shortened.set(shortened.get() + 1);
                    } else if let OutlineSpec::Points { polygon: on_grid, .. } = got {
                        prop_assert!(is_quantised(polygon.vertices(), on_grid.vertices()));
                        carried.set(carried.get() + 1);
                    } else {
                        prop_assert!(left_out.contains(&side));
                        missed.set(missed.get() + 1);
                    }
                    let (interior, mut anchor) = (expected.side(side).interior(), expected.side(side).anchor());
                    if short.is_some() {
                        // the same place among fewer points
                        anchor = found.side(side).anchor();
                    }
                    expected.apply(Command::ReshapeOutline { side, outline: got.clone(), interior, anchor });
                }
            }
            let chooses_loops =
                |surface: &SurfaceState| surface.spec().outline_loop > 0 || surface.holes() == Holes::Open;
            if session.surface(Side::Source).is_some() || session.surface(Side::Target).is_some_and(chooses_loops) {
                prop_assert!(encoded.fragment.starts_with("s=2."));
                second.set(second.get() + 1);
            } else {
                prop_assert!(encoded.fragment.starts_with("s=1."));
            }
            prop_assert_eq!(&found, &expected);
            let again = encode(&found).unwrap();
            prop_assert_eq!(again.left_out, vec![]);
            prop_assert_eq!(decode(&again.fragment).unwrap(), Decoded::complete(found));
            Ok(())
        })
        .unwrap();
    let counts = [&carried, &shortened, &missed].map(std::cell::Cell::get);
    println!("{counts:?} drawn outlines came back, came back with fewer points, travel as files");
    assert!(counts[0] > 100 && counts[1] > 10, "{counts:?}");
    assert!((50..250).contains(&second.get()), "{} of 300 links are of version 2", second.get());
}

#[test]
fn a_file_holds_a_session_bit_for_bit() {
    let _alone = alone();
    runner(50)
        .run(&session(), |session| {
            let text = file::write(&session).unwrap();
            prop_assert_eq!(file::read(text.as_bytes()).unwrap(), session);
            Ok(())
        })
        .unwrap();
}

/// The maximal total allocation of `decode`: 64 KiB unpacked, up to a mebibyte reserved for the steps of either outline
/// because of the number that it claims to have, and the points with the memory of their check.
const MOST_BYTES: usize = 8 << 20;

fn opens_or_says_why(link: &str) -> Result<bool, TestCaseError> {
    let region = Region::new(ALLOCATOR);
    let found = decode(link);
    let bytes = region.change().bytes_allocated;
    prop_assert!(bytes < MOST_BYTES, "{} bytes for {} characters", bytes, link.len());
    if let Err(error) = &found {
        prop_assert!(error.to_string().len() < 500, "{}", error);
    }
    prop_assert!(found.iter().all(|decoded| decoded.session.check().is_ok()));
    Ok(found.is_ok())
}

fn base64url(bytes: &[u8]) -> String {
    const ALPHABET: &[u8] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
    let mut text = String::new();
    for chunk in bytes.chunks(3) {
        let bits = chunk.iter().fold(0_u32, |bits, &byte| bits << 8 | u32::from(byte)) << (8 * (3 - chunk.len()));
        text.extend((0..=chunk.len()).map(|k| char::from(ALPHABET[(bits >> (18 - 6 * k)) as usize & 63])));
    }
    text
}

/// A link of a version with any bytes as its payload, deflated.
fn link_of(version: u8, bytes: &[u8]) -> String {
    format!("s={version}.{}", base64url(&miniz_oxide::deflate::compress_to_vec_zlib(bytes, 9)))
}

#[test]
fn arbitrary_text_opens_or_says_why() {
    let _alone = alone();
    let text = prop_oneof!["\\PC{0,200}", "s=[12]\\.[A-Za-z0-9_-]{0,400}", "[#&s=1.AB]{0,40}"];
    runner(2000).run(&text, |text| opens_or_says_why(&text).map(|_| ())).unwrap();
}

#[test]
fn arbitrary_bytes_open_or_say_why() {
    let _alone = alone();
    let bytes = prop::collection::vec(any::<u8>(), 0..400);
    let version = 1_u8..=2;
    runner(2000)
        .run(&(version, bytes), |(version, bytes)| opens_or_says_why(&link_of(version, &bytes)).map(|_| ()))
        .unwrap();
}

/// Bytes that differ from a session's own in a few places pass the first checks.
#[test]
fn changed_bytes_open_or_say_why() {
    let _alone = alone();
    let opened = std::cell::Cell::new(0);
    let changes = prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6);
    runner(600)
        .run(&(session(), changes), |(session, changes)| {
            let fragment = encode(&session).unwrap().fragment;
            let mut bytes = unpacked(&fragment);
            for (at, value) in changes {
                let at = at.index(bytes.len());
                bytes[at] = value;
            }
            let version = if fragment.starts_with("s=1.") { 1 } else { 2 };
            opened.set(opened.get() + u32::from(opens_or_says_why(&link_of(version, &bytes))?));
            Ok(())
        })
        .unwrap();
    println!("{} of 600 changed sessions opened", opened.get());
    assert!(opened.get() > 10, "nothing got past the checks: is the checksum right?");
}

fn unpacked(fragment: &str) -> Vec<u8> {
    let alphabet = |c: u8| match c {
        b'A'..=b'Z' => c - b'A',
        b'a'..=b'z' => c - b'a' + 26,
        b'0'..=b'9' => c - b'0' + 52,
        b'-' => 62,
        _ => 63,
    };
    let mut bytes = Vec::new();
    for chunk in fragment.as_bytes()["s=1.".len()..].chunks(4) {
        let bits = chunk.iter().fold(0_u32, |bits, &c| bits << 6 | u32::from(alphabet(c))) << (6 * (4 - chunk.len()));
        bytes.extend((0..chunk.len() - 1).map(|k| (bits >> (16 - 8 * k)) as u8));
    }
    miniz_oxide::inflate::decompress_to_vec_zlib(&bytes).unwrap()
}

/// Lengths that exceed the data, and payloads that unpack to a thousand times their size.
#[test]
fn false_lengths_and_zip_bombs_take_little_memory() {
    let _alone = alone();
    for version in [1, 2] {
        for zeros in [64 << 10, (64 << 10) + 1, 1 << 20, 6 << 20] {
            assert!(!opens_or_says_why(&link_of(version, &vec![0; zeros])).unwrap(), "{zeros} zeros");
        }
        let name = b"\x01\x00"; // points, with an empty name
        let mut promise = [&name[..], &[0; 32], &[0]].concat();
        promise.extend([0xff, 0xff, 0xff, 0xff, 0x0f]); // 2³² − 1 steps
        assert!(!opens_or_says_why(&link_of(version, &promise)).unwrap());
        promise.resize(64 << 10, 1);
        assert!(!opens_or_says_why(&link_of(version, &promise)).unwrap());
    }
    // a section that claims 2³² − 1 bytes, after the content of version 1
    let mut promise = unpacked(&encode(&Session::default()).unwrap().fragment);
    promise.extend([1, 1, 0, 0xff, 0xff, 0xff, 0xff, 0x0f]);
    assert!(!opens_or_says_why(&link_of(2, &promise)).unwrap());
}

/// A title and sessions with captions; those that no link holds are left out.
fn a_lesson() -> impl Strategy<Value = Lesson> {
    let caption = "(\\PC|\n| |#|s=1\\.|<){0,60}";
    (caption, prop::collection::vec((session(), caption), 1..5)).prop_map(|(title, steps)| {
        let steps = steps.into_iter().filter_map(|(session, caption)| Some(Step::of(&session, caption).ok()?.0));
        Lesson { title, steps: steps.collect() }
    })
}

#[test]
fn a_lesson_comes_back_from_its_file_and_from_its_link() {
    let _alone = alone();
    let (links, long) = (std::cell::Cell::new(0), std::cell::Cell::new(0));
    let address = |fragment: &str| format!("https://example.org/#{fragment}");
    runner(150)
        .run(&a_lesson(), |lesson| {
            let tidied = lesson.tidied();
            prop_assert_eq!(&tidied.tidied(), &tidied);
            let text = lesson::write(&lesson, address).unwrap();
            prop_assert_eq!(lesson::read_draft(text.as_bytes()), Ok(tidied.clone()), "{}", text);
            match lesson::encode(&lesson) {
                Ok(fragment) => {
                    prop_assert!(fragment.len() <= MAX_LENGTH);
                    prop_assert_eq!(lesson::decode(&address(&fragment)), Ok(tidied));
                    links.set(links.get() + 1);
                }
                Err(LessonError::NoSteps) => prop_assert!(lesson.steps.is_empty()),
                Err(error) => {
                    prop_assert_eq!(error, LessonError::TooLongForLink);
                    long.set(long.get() + 1);
                }
            }
            Ok(())
        })
        .unwrap();
    println!("{} links, {} lessons too long for one", links.get(), long.get());
    assert!(links.get() > 30 && long.get() > 0);
}

/// Any text after the first line, and any bytes in a link, give a lesson or an error.
#[test]
fn arbitrary_lessons_open_or_say_why() {
    let _alone = alone();
    let line = prop_oneof!["\\PC{0,40}", "#s=[12]\\.[A-Za-z0-9_-]{0,40}", "(Title|x): \\PC{0,20}", Just(String::new())];
    let bytes = prop::collection::vec(any::<u8>(), 0..200);
    runner(1000)
        .run(&(prop::collection::vec(line, 0..9), bytes), |(lines, bytes)| {
            let text = format!("riemap lesson 1\n{}", lines.join("\n"));
            let payload = base64url(&miniz_oxide::deflate::compress_to_vec_zlib(&bytes, 9));
            for found in [lesson::read(text.as_bytes()), lesson::decode(&format!("lesson=1.{payload}"))] {
                match found {
                    Ok(lesson) => prop_assert!(!lesson.steps.is_empty()),
                    Err(error) => prop_assert!(error.to_string().len() < 500, "{}", error),
                }
            }
            Ok(())
        })
        .unwrap();
}
