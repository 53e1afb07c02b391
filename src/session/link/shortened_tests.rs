//! Outlines that no link holds whole: shortened ones, and those that are left out.

use super::tests::{everything, polygon, set_outline, solids, spike};
use super::*;
use crate::outline::CurveForm;
use crate::session::Command;

/// Points on a circle with radial noise of a hundredth.
fn rough(count: u32) -> OutlineSpec {
    let point = |k: u32| {
        let noise = f64::from(k.wrapping_mul(2_654_435_761) >> 16) / 65536.0;
        DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / f64::from(count)) * (1.0 + 0.01 * noise)
    };
    let polygon = polygon((0..count).map(point).collect());
    let form = CurveForm::of_polygon(&polygon);
    OutlineSpec::Points { name: "rough".into(), polygon, form }
}

#[test]
fn outlines_that_do_not_fit_have_fewer_points_and_everything_else_is_kept() {
    for (mut session, version) in
        [(everything().and([Command::CloseSurface(Side::Target)]), "s=1."), (solids(), "s=2.")]
    {
        set_outline(&mut session, Side::Source, rough(20_000));
        set_outline(&mut session, Side::Target, rough(300));
        let Encoded { fragment, left_out, shortened } = encode(&session).unwrap();
        assert!(fragment.starts_with(version) && fragment.len() <= MAX_LENGTH, "{fragment:.20}");
        assert_eq!(left_out, []);
        let of_source = shortened.iter().find(|outline| outline.side == Side::Source).unwrap();
        println!("{of_source}; {} characters", fragment.len());
        assert!(of_source.from == 20_000 && of_source.to > 800 && of_source.deviation < 0.02, "{of_source}");
        assert!(fragment.len() > MAX_LENGTH * 4 / 5, "as many points as fit: {} characters", fragment.len());
        let Decoded { session: found, missing } = decode(&fragment).unwrap();
        assert_eq!(missing, []);
        let (source, found_source) = (session.side(Side::Source), found.side(Side::Source));
        assert_eq!(found_source.domain.settings, source.domain.settings);
        assert_eq!((&found_source.surface, found_source.interior), (&source.surface, source.interior));
        assert_eq!(found_source.domain.outline.loaded_points(), of_source.to);
        let again = encode(&found).unwrap();
        assert_eq!((again.left_out, again.shortened), (vec![], vec![]), "it fits now");
        assert_eq!(decode(&again.fragment).unwrap().session, found);

        set_outline(&mut session, Side::Target, rough(15_000));
        let Encoded { fragment, left_out, shortened } = encode(&session).unwrap();
        assert_eq!((left_out.len(), shortened.len()), (0, 2));
        assert_eq!(decode(&fragment).unwrap().missing, []);
    }
}

/// The boundary point of a shortened outline lies where it did, and the stated deviation is an upper bound.
#[test]
fn a_shortened_outline_keeps_its_anchor_and_deviates_by_what_is_said() {
    let wavy = |count: u32, ripples: f64| {
        let at = |k: u32| std::f64::consts::TAU * f64::from(k) / f64::from(count);
        let radius = |s: f64| 1.0 + 0.3 * (3.0 * s).sin() + 0.02 * (ripples * s).sin();
        polygon((0..count).map(at).map(|s| radius(s) * DVec2::from_angle(s)).collect())
    };
    for (name, given, form) in
        [("polygon", wavy(9_000, 700.0), CurveForm::polygon()), ("smooth", wavy(9_000, 40.0), CurveForm::default())]
    {
        let outline = OutlineSpec::Points { name: name.into(), polygon: given.clone(), form };
        let is_smooth = outline.curve().unwrap().is_smooth();
        assert_eq!(is_smooth, name == "smooth");
        let mut session = Session::default();
        set_outline(&mut session, Side::Target, outline.clone());
        session.apply(Command::MoveAnchor { side: Side::Target, fraction: 0.377 });
        let Encoded { fragment, left_out, shortened } = encode(&session).unwrap();
        let ([], [told]) = (left_out.as_slice(), shortened.as_slice()) else { unreachable!("{left_out:?}") };
        let found = decode(&fragment).unwrap().session;
        let got = &found.domain(Side::Target).outline;
        let (before, after) = (outline.curve().unwrap(), got.curve().unwrap());
        assert_eq!(after.is_smooth(), is_smooth, "{name}");
        let size = given.bounds().size().max_element();
        let place = |curve: &crate::outline::OutlineCurve, fraction| {
            curve.curve().position(curve.curve().point_at_fraction(fraction))
        };
        let moved = place(&before, 0.377).distance(place(&after, found.side(Side::Target).anchor)) / size;
        let dense: Vec<DVec2> = (0..60_000).map(|k| place(&after, f64::from(k) / 60_000.0)).collect();
        let tree = crate::geometry::EdgeTree::new(dense);
        let farthest = |p: &DVec2| tree.signed_distance(*p).abs() / size;
        let measured = given.vertices().iter().map(farthest).fold(0.0, f64::max);
        println!("{told}: measured {measured:.2e}, the anchor moved by {moved:.2e}");
        // rounding to 16 bits adds 1e-5
        assert!(measured <= told.deviation + 2e-5 && measured > 0.3 * told.deviation, "{name}");
        assert!(moved < told.deviation + 1e-3, "{name}: {moved:e}");
    }
}

#[test]
fn shares_are_told_with_two_digits_rounded_up() {
    let told = [0.0, 0.000_012_3, 0.005, 0.123_4, 1.0].map(percent);
    assert_eq!(told, ["0", "0.0013", "0.50", "13", "100"].map(|number| format!("{number}\u{a0}%")));
}

#[test]
fn an_outline_too_fine_for_16_bits_is_left_out() {
    let mut session = Session::default();
    set_outline(&mut session, Side::Target, spike());
    let Encoded { fragment, left_out, .. } = encode(&session).unwrap();
    assert!(matches!(left_out[0].reason, NotCarried::NotSimple(_)), "{left_out:?}");
    assert_eq!(decode(&fragment).unwrap().missing[0].name, "spike");
}
