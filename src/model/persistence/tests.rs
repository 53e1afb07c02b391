//! Steps that settle in another state, links that are only opened, outlines that are loaded later.

use crate::conformal::{PerSide, Side};
use crate::geometry::DVec2;
use crate::model::persistence::public::{COPY_SECONDS, LARGE_POINTS};
use crate::model::persistence::*;
use crate::session::link::{self, Decoded};
use crate::session::{OutlineSpec, file, scaled};

fn changed(session: &Session, command: Command) -> Session {
    let mut session = session.clone();
    session.apply(command);
    session
}

/// A persistence in which sessions with these texture scales have settled in order.
fn persistence(scales: &[f64]) -> Persistence {
    let mut persistence = Persistence::new(Session::default(), true);
    for &scale in scales {
        persistence.settle(&scaled(scale), 0.0);
    }
    persistence
}

fn address(session: &Session) -> Option<String> {
    link::encode(session).ok().map(|encoded| encoded.fragment)
}

#[test]
fn a_step_that_does_not_settle_bit_for_bit_loses_nothing() {
    let mut persistence = persistence(&[2.0, 3.0, 4.0]);
    assert_eq!(persistence.undo(Some(&scaled(4.0))), Some(scaled(3.0)));
    let settled = persistence.settle(&scaled(3.5), 0.0);
    assert_eq!(settled.address, address(&scaled(3.5)));
    assert_eq!(file::read(settled.copy.unwrap().as_bytes()), Ok(scaled(3.5)));
    assert_eq!(persistence.history().undo_count(), 1);
    assert_eq!(persistence.redo(Some(&scaled(3.5))), Some(scaled(4.0)));
    assert_eq!(persistence.undo(None), Some(scaled(3.5)), "before the redo has settled");
    assert_eq!(persistence.undo(None), Some(scaled(2.0)), "and further back");
    assert_eq!(persistence.undo(None), None);
}

#[test]
fn what_comes_back_after_a_lesson_is_no_step_and_can_be_redone_from() {
    let mut persistence = persistence(&[2.0, 3.0, 4.0]);
    persistence.undo(Some(&scaled(4.0)));
    persistence.settle(&scaled(3.0), 0.0);
    persistence.come_back();
    let settled = persistence.settle(&scaled(3.0), 0.0);
    assert_eq!((settled.address, settled.copy), (address(&scaled(3.0)), None), "nothing has changed");
    assert_eq!(persistence.history().undo_count(), 1);
    persistence.come_back();
    assert_eq!(persistence.undo(None), Some(scaled(2.0)), "while it is being prepared");
    assert_eq!([persistence.redo(None), persistence.redo(None)], [3.0, 4.0].map(scaled).map(Some));
}

#[test]
fn a_session_that_is_left_is_copied_before_its_copy_is_due() {
    let mut persistence = persistence(&[2.0]);
    assert_eq!(persistence.overdue_copy(&scaled(2.0)), None, "nothing is owed");
    persistence.owe_copy();
    let copy = persistence.overdue_copy(&scaled(2.0));
    assert_eq!(file::read(copy.unwrap().as_bytes()), Ok(scaled(2.0)));
    assert_eq!(persistence.overdue_copy(&scaled(2.0)), None);
}

#[test]
fn a_change_after_a_step_is_a_step_of_its_own() {
    let mut persistence = persistence(&[2.0, 3.0]);
    persistence.undo(Some(&scaled(3.0)));
    persistence.touch();
    persistence.settle(&scaled(7.0), 0.0);
    assert!(!persistence.history().can_redo());
    assert_eq!(persistence.undo(Some(&scaled(7.0))), Some(scaled(2.0)));
}

#[test]
fn undo_takes_back_the_last_change_only_whether_it_has_settled_or_not() {
    let mut at_rest = persistence(&[2.0, 3.0]);
    assert_eq!(at_rest.undo(Some(&scaled(4.0))), Some(scaled(3.0)), "not taken in yet");
    assert_eq!(at_rest.redo(Some(&scaled(3.0))), Some(scaled(4.0)));
    let mut under_way = persistence(&[2.0, 3.0]);
    assert_eq!(under_way.redo(None), None);
    assert_eq!(under_way.undo(None), Some(scaled(3.0)), "what is being prepared is left out");
    under_way.settle(&scaled(3.0), 0.0);
    assert_eq!(under_way.undo(Some(&scaled(3.0))), Some(scaled(2.0)));
    assert_eq!(Persistence::new(scaled(2.0), true).undo(None), None, "nothing has come to rest yet");
}

#[test]
fn the_copy_follows_changes_and_not_what_is_merely_opened() {
    let mut persistence = Persistence::new(scaled(2.0), true);
    let first = persistence.settle(&scaled(2.5), 0.0);
    assert_eq!(first, Settled { address: address(&scaled(2.5)), ..Settled::default() });
    assert_eq!(persistence.settle(&scaled(2.5), 0.1), Settled::default(), "nothing has changed");
    persistence.open_link(Vec::new(), None);
    let opened = persistence.settle(&scaled(9.0), 0.2);
    assert_eq!(opened, Settled { address: address(&scaled(9.0)), ..Settled::default() });
    assert_eq!(persistence.history().undo_count(), 1);
    persistence.touch();
    let changed = persistence.settle(&scaled(10.0), 0.3);
    assert_eq!(file::read(changed.copy.unwrap().as_bytes()), Ok(scaled(10.0)));
    let mut private = Persistence::new(scaled(2.0), false);
    private.settle(&scaled(2.0), 0.0);
    assert_eq!(private.settle(&scaled(3.0), 0.0), Settled::default());
}

/// Preparing the first map takes seconds; what is set meanwhile must be stored.
#[test]
fn a_change_before_the_first_rest_is_copied() {
    let mut persistence = Persistence::new(scaled(2.0), true);
    persistence.touch();
    let copy = persistence.settle(&scaled(3.0), 0.0).copy;
    assert_eq!(file::read(copy.unwrap().as_bytes()), Ok(scaled(3.0)));
    assert_eq!(persistence.history().undo_count(), 0);
}

#[test]
fn a_link_undone_while_it_is_prepared_leaves_nothing() {
    let (_, Decoded { session: _, missing }) = with_missing();
    let mut persistence = persistence(&[2.0, 3.0]);
    persistence.open_link(missing, None);
    assert_eq!(persistence.undo(None), Some(scaled(3.0)));
    assert!(persistence.missing().is_empty());
    assert_eq!(persistence.settle(&scaled(3.0), 1.0).address, address(&scaled(3.0)));
}

#[test]
fn undo_stops_at_a_new_beginning() {
    let mut at_rest = persistence(&[2.0, 3.0]);
    at_rest.begin_anew();
    assert_eq!(at_rest.undo(Some(&scaled(9.0))), None);
    let mut under_way = persistence(&[2.0, 3.0]);
    under_way.undo(Some(&scaled(3.0)));
    under_way.settle(&scaled(2.0), 0.0);
    under_way.begin_anew();
    assert_eq!((under_way.undo(None), under_way.redo(None)), (None, None), "while it is prepared");
    assert_eq!(under_way.settle(&scaled(9.0), 1.0).address, address(&scaled(9.0)));
    assert!(!under_way.history().can_undo() && !under_way.history().can_redo());
    under_way.settle(&scaled(10.0), 2.0);
    assert_eq!(under_way.undo(Some(&scaled(10.0))), Some(scaled(9.0)), "from there on there is a way back");
}

#[test]
fn a_failing_store_is_complained_of_once() {
    let mut persistence = persistence(&[]);
    assert!(persistence.not_kept("the disk is full".into()).unwrap().english().contains("the disk is full"));
    assert_eq!(persistence.not_kept("the disk is full".into()), None);
}

fn circle(name: &str, count: u32) -> OutlineSpec {
    let angle = |k: u32| std::f64::consts::TAU * f64::from(k) / f64::from(count);
    // with noise, as of a coast
    let radius = |k: u32| 1.0 + 1e-2 * f64::from(k.wrapping_mul(2_654_435_761) >> 16) / 65536.0;
    let points: Vec<DVec2> = (0..count).map(|k| DVec2::from_angle(angle(k)) * radius(k)).collect();
    OutlineSpec::points(name.into(), points.try_into().unwrap())
}

/// A polygon with a notch finer than the grid of a link.
fn notched() -> OutlineSpec {
    let notch = [(0.5 + 1e-9, 1.0), (0.5, -0.6), (0.5 - 1e-9, 1.0)];
    let points = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0)].into_iter().chain(notch).chain([(-1.0, 1.0)]);
    let points: Vec<DVec2> = points.map(DVec2::from).collect();
    OutlineSpec::points("rough".into(), points.try_into().unwrap())
}

/// A session whose source is too fine for a link, and the decoded link.
fn with_missing() -> (Session, Decoded) {
    let mut session = Session::default();
    let side = Side::Source;
    session.apply(Command::SetOutline { side, outline: notched() });
    session.apply(Command::MoveInterior { side, point: DVec2::new(0.25, -0.125).into() });
    session.apply(Command::MoveAnchor { side, fraction: 0.75 });
    let dab = crate::optimization::Dab { middle: DVec2::splat(0.25).extend(0.0), radius: 0.125 };
    session.apply(Command::SetRegion(vec![dab]));
    let decoded = link::decode(&link::encode(&session).unwrap().fragment).unwrap();
    assert_eq!(decoded.missing.len(), 1);
    (session, decoded)
}

#[test]
fn pins_come_with_the_last_outline_that_was_missing() {
    let pins = crate::conformal::Pins::new([[0.1, 0.2], [0.4, 0.5], [0.8, 0.9]].map(PerSide::from)).unwrap();
    let both = Side::BOTH.map(|side| Command::SetOutline { side, outline: notched() });
    let whole = Session::default().and(both).and([Command::SetPins(Some(pins))]);
    let Decoded { session, missing } = link::decode(&link::encode(&whole).unwrap().fragment).unwrap();
    assert_eq!((missing.len(), session.pins()), (2, None), "none on the disks that stand in");
    let mut persistence = Persistence::new(session.clone(), true);
    persistence.open_link(missing, None);
    let mut loaded = session;
    for side in Side::BOTH {
        assert_eq!(loaded.pins(), None);
        loaded.apply(Command::SetOutline { side, outline: notched() });
        loaded = loaded.clone().and(persistence.settle(&loaded, 1.0).moves);
    }
    assert_eq!(loaded, whole);
}

#[test]
fn an_outline_that_comes_later_gets_its_points_and_then_the_address_follows() {
    let (whole, Decoded { session, missing }) = with_missing();
    let mut persistence = Persistence::new(session.clone(), true);
    persistence.open_link(missing, None);
    assert_eq!(persistence.settle(&session, 0.0), Settled::default(), "the address stays as it was opened");
    let outline = whole.domain(Side::Source).outline.clone();
    let loaded = changed(&session, Command::SetOutline { side: Side::Source, outline });
    let settled = persistence.settle(&loaded, 1.0);
    assert_eq!((settled.address, settled.copy), (None, None));
    let loaded = loaded.and(settled.moves);
    assert_eq!(loaded, whole);
    let settled = persistence.settle(&loaded, 2.0);
    assert_eq!(settled.address, address(&whole));
    assert_eq!(file::read(settled.copy.unwrap().as_bytes()), Ok(whole));
    assert_eq!(persistence.history().undo_count(), 1, "one step");
    assert!(persistence.missing().is_empty());
}

#[test]
fn a_change_releases_the_address_and_another_outline_drops_the_missing_one() {
    let (whole, Decoded { session, missing }) = with_missing();
    let mut persistence = Persistence::new(session.clone(), true);
    persistence.open_link(missing, None);
    persistence.settle(&session, 0.0);
    let grown = changed(&session, Command::SetTextureScale(21.0));
    assert_eq!(persistence.settle(&grown, 1.0).address, address(&grown));
    assert_eq!(persistence.missing().len(), 1, "it can still be opened");
    let other = changed(&grown, Command::SetOutline { side: Side::Source, outline: circle("other", 100) });
    assert_eq!(persistence.settle(&other, 2.0).address, address(&other));
    assert!(persistence.missing().is_empty());
    let outline = whole.domain(Side::Source).outline.clone();
    let late = changed(&other, Command::SetOutline { side: Side::Source, outline });
    assert!(persistence.settle(&late, 3.0).moves.is_empty());
}

#[test]
fn a_large_session_is_copied_once_in_a_while() {
    let mut large = Session::default();
    let outline = circle("large", LARGE_POINTS as u32 + 1);
    large.apply(Command::SetOutline { side: Side::Source, outline });
    let mut persistence = Persistence::new(Session::default(), true);
    persistence.settle(&Session::default(), 0.0);
    assert!(persistence.settle(&large, 10.0).copy.is_some());
    large.apply(Command::SetTextureScale(21.0));
    let settled = persistence.settle(&large, 11.0);
    assert_eq!((settled.copy, settled.copy_due), (None, Some(COPY_SECONDS - 1.0)));
    assert!(settled.address.is_some());
    let copy = persistence.settle(&large, 10.0 + COPY_SECONDS).copy;
    assert_eq!(file::read(copy.unwrap().as_bytes()), Ok(large));
}

#[test]
fn an_address_that_was_refused_shows_at_once_what_it_showed_before() {
    let mut persistence = Persistence::new(scaled(1.0), true);
    assert_eq!(persistence.correct_address(), None, "nothing yet");
    let first = persistence.settle(&scaled(1.0), 0.0).address;
    assert_eq!(first, address(&scaled(1.0)));
    assert_eq!(persistence.correct_address(), first);
    assert_eq!(persistence.settle(&scaled(1.0), 1.0), Settled::default(), "it is shown already");
    let (_, Decoded { session, missing }) = with_missing();
    persistence.open_link(missing, Some("#s=1.opened".into()));
    assert_eq!(persistence.settle(&session, 2.0), Settled::default());
    assert_eq!(persistence.correct_address().as_deref(), Some("#s=1.opened"), "it waits for its outline");
}

#[test]
fn an_address_that_does_not_follow_is_left_alone() {
    let mut persistence = Persistence::new(scaled(1.0), false);
    persistence.settle(&scaled(1.0), 0.0);
    assert_eq!(persistence.correct_address(), None);
}
