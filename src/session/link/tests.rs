//! Golden links, sizes, sections, links that are refused.

use super::*;
use crate::conformal::{Direction, Extension, KernelMode, PrepareSettings};
use crate::geometry::{DVec3, PicturePlacement, SimplePolygon};
use crate::laplace::SolverKind;
use crate::mesh::{BarycentricPoint, Sizing, TriangleId};
use crate::outline::{Preset, Sampling};
use crate::session::{Colouring, Command, Comparison, SurfaceShape, SurfaceSpec, TextureKind};
use crate::surface::SurfacePreset;

fn round_trip(session: &Session) -> Decoded {
    decode(&encode(session).unwrap().fragment).unwrap()
}

/// A session that differs from the default in every field.
pub fn everything() -> Session {
    let settings = [
        PrepareSettings {
            sampling: Sampling::Uniform { count: 1000, keep_corners: true },
            sizing: Sizing::Uniform,
            kernel: KernelMode::Table,
            solver: SolverKind::Pcg,
        },
        PrepareSettings { sampling: Sampling::default(), sizing: Sizing::Graded(0.25), ..PrepareSettings::default() },
    ];
    let mut session = Session::default();
    for ((side, preset), settings) in Side::BOTH.into_iter().zip([Preset::VShape, Preset::MapleLeaf]).zip(settings) {
        let x = if side == Side::Source { 0.125 } else { 0.25 };
        session.apply(Command::SetOutline { side, outline: OutlineSpec::Preset(preset) });
        session.apply(Command::SetSettings { side, settings });
        session.apply(Command::MoveInterior { side, point: DVec2::new(x, -1.0 / 3.0).into() });
        session.apply(Command::MoveAnchor { side, fraction: 0.1 + x });
    }
    let shape = SurfaceShape::Preset { preset: SurfacePreset::AnimalHead, boundary: 123 };
    for command in [
        Command::SetDirection(Direction::Forward),
        Command::SetExtension(Extension::CauchyGreen),
        Command::SetTexture(TextureKind::Conformal),
        Command::SetTextureScale(12.0),
        Command::SetTextureSide(Side::Target),
        Command::SetColouring(Colouring::Area),
        Command::SetWireframe(true),
        Command::SetPlots(true),
        Command::SetComparison(Comparison::Precomputed),
        Command::SetSurface {
            side: Side::Target,
            surface: SurfaceSpec { shape, repair: true, ..SurfaceSpec::default() },
        },
        Command::MoveInterior {
            side: Side::Target,
            point: BarycentricPoint::new(TriangleId::new(77), [0.25, 0.5, 0.25]).into(),
        },
        Command::MoveAnchor { side: Side::Target, fraction: 0.625 },
    ] {
        session.apply(command);
    }
    session
}

/// A house with corners on the 16-bit grid of its box: quantizing does not change it.
fn house() -> Session {
    let corners = [(0.0, 0.0), (65535.0, 0.0), (65535.0, 40000.0), (32768.0, 65535.0), (0.0, 40000.0)];
    let outline = OutlineSpec::points("Häuschen".into(), polygon(corners.map(DVec2::from).to_vec()));
    Session::with([
        Command::SetOutline { side: Side::Target, outline },
        // the golden link is older than upright beginnings
        Command::MoveAnchor { side: Side::Target, fraction: 0.0 },
        Command::SetSurface { side: Side::Target, surface: cow() },
        Command::SetTextureScale(OLD_CELLS),
    ])
}

/// The cells of a default session when the links were sent.
const OLD_CELLS: f64 = 8.0;

fn old_default() -> Session {
    Session::with([Command::SetTextureScale(OLD_CELLS)])
}

pub fn polygon(points: Vec<DVec2>) -> SimplePolygon {
    SimplePolygon::try_from(points).unwrap()
}

fn cow() -> SurfaceSpec {
    SurfaceSpec { shape: SurfaceShape::File { name: "cow.obj".into() }, ..SurfaceSpec::default() }
}

/// A session with surfaces on both sides.
pub fn solids() -> Session {
    everything().and([
        Command::SetSurface { side: Side::Source, surface: cow() },
        Command::MoveInterior {
            side: Side::Source,
            point: BarycentricPoint::new(TriangleId::new(5), [0.5, 0.125, 0.375]).into(),
        },
        Command::MoveAnchor { side: Side::Source, fraction: 0.375 },
    ])
}

/// A session with a surface on the source's side only.
fn on_source() -> Session {
    solids().and([Command::CloseSurface(Side::Target)])
}

pub fn set_outline(session: &mut Session, side: Side, outline: OutlineSpec) {
    session.sides[side].domain.outline = outline;
}

/// Links of version 1 that have been sent. These strings must never change.
const GOLDEN_DEFAULT: &str =
    "s=1.eNplyLENQBEURuH_Fqq3xNuEVYgbNIoby7CJxHAioeFUXw6-kHJgccLWg4aiVlddA1CRrZT7PtHBbzYmH3YRpA";
const GOLDEN_EVERYTHING: &str = "s=1.eNpVzT0Kg0AQBeD3kkJILpJmzzC5QMocYCArBlYRBBsPpwdQsNHawsJjqCsqfkwxf_AQ5CaLNLWcAoLEI9bUWeOshgDhtXK0lXy9rjxu-6KpPQm9XsD79vJ688al8NTkH6szkdVfsWSBnzNgNch1HgUzi8Uk-Q";
const GOLDEN_HOUSE: &str = "s=1.eNptjE0KQFAcxP9DklzCCVyBpWv4ePlYUCRrZW3P2iWUnYvIBZxAD-ml8NvMTDMN6WGchiz3cuYGhElB312MFhE0Zx7Kwo9YSj8sfLOFQjnnJPFW3rlcr0Cz4vX2BcIY9p2h-lllZl7yVBcH7nIjBg";
const GOLDEN_MISSING: &str =
    "s=1.eNpdissJwCAUBPeF2Ec6eWklh5AcQgLBZrQTQfBsFx4tQ8QP6F5mGHZZn--9QFaQVnmGAYj7PH451a6FngnDgiuM3Eo_bHuVBIedGss";

fn with_missing() -> Decoded {
    let mut session = old_default();
    set_outline(&mut session, Side::Source, OutlineSpec::Preset(Preset::Disk));
    session.apply(Command::MoveInterior { side: Side::Target, point: DVec2::new(0.0, -0.5).into() });
    let interior = Some(DVec2::new(0.1, 0.2));
    Decoded {
        session,
        missing: vec![MissingOutline {
            side: Side::Source,
            name: "long".into(),
            interior,
            anchor: 0.75,
            pins: None,
            region: Vec::new(),
        }],
    }
}

#[test]
fn golden_links_of_version_1_open_for_ever() {
    let known = |session| Decoded { session, missing: Vec::new() };
    for (link, expected) in [
        (GOLDEN_DEFAULT, known(old_default())),
        (GOLDEN_EVERYTHING, known(everything())),
        (GOLDEN_HOUSE, known(house())),
        (GOLDEN_MISSING, with_missing()),
    ] {
        // with finite elements, as they were
        let expected = Decoded { session: crate::session::by_finite_elements(expected.session), ..expected };
        assert_eq!(decode(link), Ok(expected), "{link}");
    }
}

/// Links of version 2 that have been sent. These strings must never change.
const GOLDEN_SOLIDS: &str = "s=2.eNpVjk0OAUEUhKuIdMJFbJojPBewdICHngzpMZNIWDicOQCJDbG0sHAM042W-fKS91dJFczObnOtHF-GINEvtPLOeqcZQEQuksZaZpHrMf1-h_MpIlnkJmD3IxlO2GFTGOhmVai3udPlofECp3-DwEPa-1NCpDHNotyPyvk6pGCvra2__Z76G6HXLDc";
const GOLDEN_ON_SOURCE: &str = "s=2.eNo9jFEKQEAURd8lTVmJHyzh2YQFDI0kohTLYwGUH_Lp0zJkppnzc1_v3g6JKR5rOSi8AgRQ2MmhVXGrZEUE0hzszpVzzbm4zj72TcOV5mKCbyZRBg_w6NenEGU_J33R_EYEZvGwtZu8XX4GriLP";

#[test]
fn golden_links_of_version_2_open_for_ever() {
    for (link, session) in [(GOLDEN_SOLIDS, solids()), (GOLDEN_ON_SOURCE, on_source())] {
        assert_eq!(decode(link), Ok(Decoded { session, missing: Vec::new() }), "{link}");
    }
}

/// So that older programs open every link that they can.
#[test]
fn the_oldest_version_that_holds_a_session_is_written() {
    for (session, version) in [
        (Session::default(), "s=1."),
        (everything(), "s=1."),
        (house(), "s=1."),
        (solids(), "s=2."),
        (on_source(), "s=2."),
    ] {
        let fragment = encode(&session).unwrap().fragment;
        assert!(fragment.starts_with(version), "{fragment}");
    }
}

#[test]
fn the_placement_of_the_image_travels_and_old_links_have_the_whole_image() {
    assert!(decode(&encode(&everything()).unwrap().fragment).unwrap().session.picture().is_default());
    let placed = PicturePlacement { middle: DVec2::new(0.25, -1.5), size: 3.75, turn: -2.0 };
    let session = everything().and([Command::PlacePicture(placed)]);
    assert_eq!(session.picture(), placed);
    let fragment = encode(&session).unwrap().fragment;
    assert!(fragment.starts_with("s=2."), "{fragment}");
    assert_eq!(decode(&fragment).unwrap(), Decoded { session, missing: Vec::new() });
    let wild = PicturePlacement { size: 0.0, ..placed };
    let content = postcard::to_allocvec(&wild).unwrap();
    let found = with_section(version2::Section { number: 4, may_be_skipped: true, content });
    assert!(matches!(found, Err(LinkError::OutOfRange(_))), "{found:?}");
}

/// Decodes the link of [`solids`] with one more section.
fn with_section(section: version2::Section) -> Result<Decoded, LinkError> {
    let session = solids();
    let wired = PerSide::from_fn(|side| prepared(&session.domain(side).outline).wired());
    let wired = Version2::new(&session, wired, &PerSide::new(None, None)).unwrap().and(section);
    decode(&framed(NEWEST, &postcard::to_allocvec(&wired).unwrap()).unwrap())
}

#[test]
fn a_section_from_a_newer_program_is_skipped_where_it_says_so_and_else_named() {
    let section = |number, may_be_skipped| version2::Section { number, may_be_skipped, content: vec![1, 2, 3] };
    assert_eq!(with_section(section(999, true)), Ok(Decoded { session: solids(), missing: Vec::new() }));
    assert_eq!(
        with_section(section(999, false)),
        Err(LinkError::Unknown { what: Choice::Setting, name: "999".into() })
    );
    // a second section with a known number was never written by any version
    assert_eq!(with_section(section(1, true)), Err(LinkError::Damaged));
}

#[test]
fn the_usual_links_are_short() {
    let mut dragged = Session::default();
    for side in Side::BOTH {
        dragged.apply(Command::MoveInterior { side, point: DVec2::new(0.123_456_789, -1.0 / 3.0).into() });
        dragged.apply(Command::MoveAnchor { side, fraction: 0.7_f64.sqrt() });
    }
    let mut drawn = Session::default();
    let leaf = OutlineSpec::points("leaf".into(), Preset::MapleLeaf.outline().into_polygon());
    drawn.apply(Command::SetOutline { side: Side::Source, outline: leaf });
    for (name, session, most) in [
        ("default", Session::default(), 110),
        ("both dots dragged on both sides", dragged, 180),
        ("everything", everything(), 250),
        ("house and a surface", house(), 180),
        ("everything and a surface on either side", solids(), 330),
        ("a surface on the source's side", on_source(), 300),
        ("a leaf of many points", drawn, MAX_LENGTH),
    ] {
        let Encoded { fragment, left_out, .. } = encode(&session).unwrap();
        println!("{name}: {} characters\n{fragment:.300}", fragment.len());
        assert!(fragment.len() <= most && left_out.is_empty(), "{name}: {} characters", fragment.len());
        let allowed = |c: char| c.is_ascii_alphanumeric() || "-_.=".contains(c);
        assert!(fragment.chars().all(allowed), "{fragment}");
    }
}

#[test]
fn every_setting_survives_a_link() {
    for session in [Session::default(), everything(), house(), solids(), on_source()] {
        assert_eq!(round_trip(&session), Decoded { session, missing: Vec::new() });
    }
}

/// An outline that a link only names.
pub fn spike() -> OutlineSpec {
    let spike = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.31 + 1e-9, 1.0), (0.31, 0.2), (0.31 - 1e-9, 1.0), (0.0, 1.0)];
    OutlineSpec::points("spike".into(), polygon(spike.map(DVec2::from).to_vec()))
}

#[test]
fn long_names_lose_their_ends_and_controls() {
    let mut session = house();
    let name = format!("\u{1b}[31m{}", "ü".repeat(100));
    for side in Side::BOTH {
        let surface = SurfaceSpec { shape: SurfaceShape::File { name: name.clone() }, ..SurfaceSpec::default() };
        session.apply(Command::SetSurface { side, surface });
    }
    let found = round_trip(&session).session;
    let name = format!("[31m{}", "ü".repeat(44));
    for side in Side::BOTH {
        assert_eq!(found.surface(side).unwrap().spec.shape, SurfaceShape::File { name: name.clone() });
    }
    assert_eq!(round_trip(&found).session, found);
}

#[test]
fn a_link_is_found_in_an_address_among_other_parts() {
    let fragment = encode(&house()).unwrap().fragment;
    for link in [
        format!("https://example.org/riemap/?embed#{fragment}"),
        format!("  #{fragment}\n"),
        format!("#lock=texture&{fragment}&x=1"),
    ] {
        assert!(is_link(&link));
        assert_eq!(decode(&link).unwrap().session, house(), "{link}");
    }
    for link in ["", "#", "https://example.org/?s=1.AwA#x", "heart.riemap", "xs=1.AwA"] {
        assert!(!is_link(link) && decode(link) == Err(LinkError::NoSession), "{link}");
    }
}

/// The link of a session after changes to its encoded form.
fn tampered(
    change: impl FnOnce(&mut Session),
    outlines: impl FnOnce(&mut PerSide<Prepared>),
) -> Result<Decoded, LinkError> {
    let mut session = solids();
    change(&mut session);
    let mut prepared = PerSide::from_fn(|side| prepared(&session.domain(side).outline));
    outlines(&mut prepared);
    decode(&fragment(&session, &prepared).unwrap())
}

#[test]
fn numbers_out_of_their_ranges_are_refused() {
    let samples = |count| Sampling::Adaptive { target: Some(count) };
    assert!(tampered(|_| (), |_| ()).is_ok());
    let refused = |change: fn(&mut Session)| {
        let found = tampered(change, |_| ());
        assert!(matches!(found, Err(LinkError::OutOfRange(_))), "{found:?}");
    };
    refused(|s| s.display.texture_scale = f64::NAN);
    refused(|s| s.sides[Side::Source].interior = Some(DVec2::new(f64::INFINITY, 0.0)));
    refused(|s| s.sides[Side::Target].anchor = -1e300);
    refused(|s| s.sides[Side::Source].domain.settings.sizing = Sizing::Graded(0.0));
    refused(|s| s.sides[Side::Source].surface.as_mut().unwrap().anchor = 1.5);
    refused(|s| s.sides[Side::Target].surface.as_mut().unwrap().anchor = -0.5);
    let many = |s: &mut Session| s.sides[Side::Source].domain.settings.sampling = samples(u32::MAX);
    assert!(tampered(many, |_| ()).unwrap_err().to_string().contains("4294967295"));
    assert!(encode(&Session::with([Command::SetTextureScale(f64::NAN)])).is_err());
}

#[test]
fn unknown_choices_and_versions_are_named() {
    let found = tampered(|_| (), |outlines| outlines.source = Prepared::Preset("giraffe".into()));
    assert_eq!(found, Err(LinkError::Unknown { what: Choice::Outline, name: "giraffe".into() }));
    assert_eq!(decode("s=3.AAAA"), Err(LinkError::Version { found: "3".into() }));
    assert_eq!(decode("s=123456789012345678.AAAA"), Err(LinkError::Version { found: "123456789".into() }));
    for link in
        ["s=", "s=1", "s=1.", "s=.", "s=x.AwA", "s=1.eJwDAAAAAAE", "s=2.eJwDAAAAAAE", "s=1.A", "s=2.A", "s=01.AwA"]
    {
        assert!(decode(link).is_err(), "{link}");
    }
}

#[test]
fn crossing_outlines_and_bad_names_are_refused() {
    let crossed = |outlines: &mut PerSide<Prepared>| {
        // the points (0, 0), (1, 1), (1, 0), (0, 1) as steps modulo 2¹⁶
        let steps = [[0, 0], [-1, -1], [0, 1], [1, -1]];
        let bow_tie = serde_json::json!({ "low": [0.0, 0.0], "high": [1.0, 1.0], "smooth": false, "steps": steps });
        let points = serde_json::from_value(bow_tie).unwrap();
        outlines.target = Prepared::Points { name: "x".into(), points };
    };
    let found = tampered(|_| (), crossed);
    assert!(matches!(found, Err(LinkError::Outline { side: Side::Target, .. })), "{found:?}");
    let name = "x".repeat(49);
    let reason = NotCarried::TooLong { points: 0 };
    let found = tampered(|_| (), |outlines| outlines.source = Prepared::LeftOut { name, reason });
    assert_eq!(found, Err(LinkError::Damaged));
}

#[test]
fn a_damaged_link_says_that_it_is() {
    for fragment in [house(), on_source()].map(|session| encode(&session).unwrap().fragment) {
        for at in "s=1.".len()..fragment.len() {
            assert!(decode(&fragment[..at]).is_err(), "cut at {at}");
            for other in ["A", "_", "7", "=", "ü", ""]
                .into_iter()
                .filter(|other| !fragment[at..].starts_with(other) || other.is_empty())
            {
                let damaged = format!("{}{other}{}", &fragment[..at], &fragment[at + 1..]);
                let found = decode(&damaged);
                assert!(matches!(found, Err(LinkError::Damaged | LinkError::TooMuch)), "{other:?} at {at}: {found:?}");
            }
        }
    }
    // the versions are not interchangeable
    let fragment = encode(&on_source()).unwrap().fragment;
    assert_eq!(decode(&fragment.replace("s=2.", "s=1.")), Err(LinkError::Damaged));
    let fragment = encode(&house()).unwrap().fragment;
    assert_eq!(decode(&fragment.replace("s=1.", "s=2.")), Err(LinkError::Damaged));
}

/// An older program shows the same map by its points.
#[test]
fn pins_travel_in_a_section_that_may_be_skipped() {
    let pins = crate::conformal::Pins::new([[0.1, 0.25], [1.0 / 3.0, 0.5], [0.8, 0.75]].map(PerSide::from)).unwrap();
    let session = Session::default().and([Command::SetPins(Some(pins))]);
    let link = encode(&session).unwrap().fragment;
    assert!(link.starts_with("s=2."), "{link}");
    assert_eq!(decode(&link).unwrap().session, session);
    let bytes = postcard::to_allocvec(&vec![[0.1, 0.2], [0.1, 0.3], [0.5, 0.6]]).unwrap();
    let damaged = version2::Section { number: 7, may_be_skipped: true, content: bytes };
    let refused = with_section(damaged);
    assert!(matches!(refused, Err(LinkError::Pins(_))), "{refused:?}");
}

/// A stroke takes eight bytes a dab in the plane, and an older program shows the same map without it.
#[test]
fn the_painted_region_travels_in_a_section_that_may_be_skipped() {
    let dab = |x: f64, z: f64, radius: f64| crate::optimization::Dab { middle: DVec3::new(x, 0.1, z), radius };
    let stroke = (0..40).map(|k| dab(0.01 * f64::from(k), 0.0, 0.1));
    let dabs = stroke.chain([dab(0.3, 0.0, 0.2), dab(0.4, -0.7, 0.2), dab(0.5, 0.6, 0.2)]).collect();
    let session = Session::default().and([Command::SetRegion(dabs)]);
    let link = encode(&session).unwrap().fragment;
    assert!(link.starts_with("s=2.") && link.len() < 700, "{} bytes", link.len());
    assert_eq!(decode(&link).unwrap().session, session);
    let text = crate::session::file::write(&session).unwrap();
    assert_eq!(crate::session::file::read(text.as_bytes()).unwrap(), session);
    // it waits for an outline that is in a file, and belongs to the source
    let with_file = |side: Side| {
        let mut with_file = session.clone();
        set_outline(&mut with_file, side, spike());
        decode(&encode(&with_file).unwrap().fragment).unwrap()
    };
    let (source, target) = (with_file(Side::Source), with_file(Side::Target));
    assert_eq!((source.missing[0].region.as_slice(), source.session.region()), (session.region(), [].as_slice()));
    assert_eq!((target.missing[0].region.as_slice(), target.session.region()), ([].as_slice(), session.region()));
    let bytes = postcard::to_allocvec(&region::runs(&[dab(0.0, 0.0, -1.0)])).unwrap();
    let refused = with_section(version2::Section { number: 9, may_be_skipped: true, content: bytes });
    assert!(matches!(refused, Err(LinkError::OutOfRange(_))), "{refused:?}");
}

#[test]
fn marks_travel_in_a_section_that_may_be_skipped() {
    let marks = |side, marks| Command::SetMarks { side, marks: Some(marks) };
    let one = Session::default().and([marks(Side::Target, [0.1, 1.0 / 3.0, 0.7, 0.75])]);
    for session in [one.clone(), one.and([marks(Side::Source, [0.9, 0.2, 0.3, 0.5])])] {
        let fragment = encode(&session).unwrap().fragment;
        assert!(fragment.starts_with("s=2."), "{fragment}");
        assert_eq!(decode(&fragment).unwrap(), Decoded { session, missing: Vec::new() });
    }
    let bytes = postcard::to_allocvec(&[Some([0.1, 0.3, 1.7, 0.75]), None]).unwrap();
    let refused = with_section(version2::Section { number: 12, may_be_skipped: true, content: bytes });
    assert!(matches!(refused, Err(LinkError::OutOfRange(_))), "{refused:?}");
}

#[test]
fn a_tiling_travels_in_a_section_that_may_be_skipped() {
    use crate::tiling::{Tiling, TilingPattern, TilingStyle};
    let pattern = TilingPattern { tiling: Tiling::new(4, 5).unwrap(), style: TilingStyle::Triangles };
    let set = Session::default().and([Command::SetTiling(pattern)]);
    for session in [set.clone(), set.and([Command::SetTexture(TextureKind::Tiling)]), shown_by_default()] {
        let fragment = encode(&session).unwrap().fragment;
        assert!(fragment.starts_with("s=2."), "{fragment}");
        assert_eq!(decode(&fragment).unwrap(), Decoded { session, missing: Vec::new() });
    }
    // what programs older than tilings read: section 8 is unknown to them, and is skipped
    let wired = PerSide::from_fn(|side| prepared(&shown_by_default().domain(side).outline).wired());
    let wired = Version2::new(&shown_by_default(), wired, &PerSide::new(None, None)).unwrap().renumbered(8, 999);
    let older = decode(&framed(NEWEST, &postcard::to_allocvec(&wired).unwrap()).unwrap()).unwrap().session;
    assert_eq!(older, Session::with([Command::SetTexture(TextureKind::Conformal)]));
    for damaged in [vec![4, 4, 0, 1], vec![7, 3, 9, 1], vec![7]] {
        let found = with_section(version2::Section { number: 8, may_be_skipped: true, content: damaged });
        assert_eq!(found, Err(LinkError::Damaged));
    }
}

/// The default session with the default tiling as its pattern.
fn shown_by_default() -> Session {
    Session::with([Command::SetTexture(TextureKind::Tiling)])
}

/// An older program shows the same map without them.
#[test]
fn symmetries_travel_in_a_section_that_may_be_skipped() {
    let session = Session::default().and([Command::SetSymmetries(true)]);
    let link = encode(&session).unwrap().fragment;
    assert!(link.starts_with("s=2."), "{link}");
    assert_eq!(decode(&link).unwrap().session, session);
    let section = |content| version2::Section { number: 11, may_be_skipped: true, content };
    assert!(with_section(section(Vec::new())).unwrap().session.symmetries());
    assert_eq!(with_section(section(vec![1])).unwrap_err(), LinkError::Damaged);
}
