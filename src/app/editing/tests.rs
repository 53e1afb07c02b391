//! The editor and the model, action by action, without a screen.

use super::*;
use crate::conformal::PrepareSettings;
use crate::geometry::DVec2;
use crate::geometry::SimplePolygon;
use crate::mesh::Sizing;
use crate::model::editing::Pen;
use crate::model::opening::Arrived;
use crate::outline::{Preset, Sampling};
use crate::session::{Command, OutlineSpec, Session};
use crate::worker::{Request, Task, run};

const SIDE: Side = Side::Source;

/// Settings that are finer than the coarse maps shown during a drag.
const SETTINGS: PrepareSettings = PrepareSettings {
    sampling: Sampling::Uniform { count: 600, keep_corners: true },
    sizing: Sizing::Graded(0.3),
    kernel: crate::conformal::KernelMode::Adjoint,
    solver: crate::laplace::SolverKind::Direct,
};

struct Bench {
    model: Model,
    editor: Editor,
    views: PerSide<View>,
}

impl Bench {
    /// An editor of a prepared outline.
    fn of(outline: OutlineSpec) -> Self {
        let mut session = Session::default();
        session.apply(Command::SetOutline { side: SIDE, outline });
        for side in Side::BOTH {
            session.apply(Command::SetSettings { side, settings: SETTINGS });
        }
        let mut bench = Self { model: Model::new(session), editor: Editor::default(), views: PerSide::default() };
        bench.answer_all();
        bench.act(EditAction::Toggle(SIDE));
        bench
    }

    fn square() -> Self {
        let points = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)].map(DVec2::from).to_vec();
        Self::of(OutlineSpec::points("square".into(), points.try_into().unwrap()))
    }

    fn act(&mut self, action: EditAction) {
        self.editor.act(action, &mut self.model, &mut self.views);
    }

    fn requests(&mut self) -> Vec<(Side, Request)> {
        self.editor.follow(&mut self.model, &mut self.views);
        self.model.take_requests(f64::INFINITY)
    }

    fn answer(&mut self, requests: Vec<(Side, Request)>) {
        for (side, request) in requests {
            run(&request, &mut |generation, response| {
                self.model.accept(side, generation, response);
                match self.model.take_arrived() {
                    Some(Arrived::Outline(..)) => self.editor.end_paste(&mut self.model, &mut self.views),
                    Some(Arrived::NoOutline(side, why)) => self.editor.refuse_paste(side, why),
                    _ => {}
                }
            });
        }
        while self.model.refresh(false).images || self.model.is_pending() {}
    }

    fn answer_all(&mut self) {
        loop {
            let requests = self.requests();
            if requests.is_empty() {
                break;
            }
            self.answer(requests);
        }
        self.editor.follow(&mut self.model, &mut self.views);
    }

    fn points(&self) -> Vec<DVec2> {
        self.model.session().domain(Side::Source).outline.polygon().vertices().to_vec()
    }

    fn reshaping(&self) -> &Reshaping {
        self.editor.reshaping(SIDE).unwrap()
    }
}

fn settings_of(requests: &[(Side, Request)]) -> PrepareSettings {
    let [(SIDE, Request { task: Task::Outline { settings, .. }, .. })] = requests else { panic!("{requests:?}") };
    *settings
}

#[test]
fn while_a_handle_is_dragged_one_coarse_request_is_in_flight_and_the_latest_is_next() {
    let mut bench = Bench::square();
    bench.act(EditAction::Grab(2, Hold::Pointer));
    bench.act(EditAction::Drag(DVec2::new(2.2, 2.1)));
    let first = bench.requests();
    let settings = settings_of(&first);
    assert!(matches!(settings.sampling, Sampling::Adaptive { target: Some(m) } if m <= 500), "{settings:?}");
    for x in [2.3, 2.4, 2.5] {
        bench.act(EditAction::Drag(DVec2::new(x, 2.5)));
        assert_eq!(bench.requests(), [], "one request is in flight");
        assert_eq!(bench.model.next_due(), None, "no frame is requested while waiting for it");
    }
    let generation = bench.model.generation();
    bench.answer(first);
    assert_eq!(bench.points()[2], DVec2::new(2.2, 2.1), "the map follows");
    assert!(bench.model.generation() > generation && !bench.model.is_ready(), "the coarse map is not the final one");
    assert_eq!(bench.model.session().domain(Side::Source).settings, SETTINGS, "the session keeps its settings");
    let second = bench.requests();
    bench.answer(second);
    assert_eq!(bench.points()[2], DVec2::new(2.5, 2.5), "the requests in between are skipped");
    bench.act(EditAction::Release);
    let last = bench.requests();
    assert_eq!(settings_of(&last), SETTINGS, "the released outline is prepared at full resolution");
    bench.answer(last);
    assert!(bench.model.is_ready() && bench.requests().is_empty());
    assert_eq!(bench.points()[2], DVec2::new(2.5, 2.5));
}

#[test]
fn a_handle_released_where_it_was_grabbed_changes_nothing() {
    let mut bench = Bench::square();
    let before = bench.model.session().clone();
    bench.act(EditAction::Grab(1, Hold::Pointer));
    bench.act(EditAction::Release);
    assert!(bench.requests().is_empty() && bench.model.is_ready());
    assert_eq!(*bench.model.session(), before, "a click is no change");
    bench.act(EditAction::Grab(1, Hold::Pointer));
    bench.act(EditAction::Drag(DVec2::new(3.0, 0.0)));
    bench.act(EditAction::Drag(DVec2::new(2.0, 0.0)));
    bench.act(EditAction::Release);
    bench.answer_all();
    assert!(bench.model.is_ready() && bench.points() == before.domain(Side::Source).outline.polygon().vertices());
}

#[test]
fn while_the_outline_crosses_itself_the_last_good_one_stays_and_the_place_is_known() {
    let mut bench = Bench::square();
    bench.act(EditAction::Grab(2, Hold::Pointer));
    bench.act(EditAction::Drag(DVec2::new(1.5, 1.5)));
    bench.answer_all();
    let good = bench.points();
    bench.act(EditAction::Drag(DVec2::new(-1.0, 1.0)));
    assert!(bench.requests().is_empty());
    let crossing = bench.reshaping().crossing().unwrap();
    let at = crossing.at.unwrap();
    assert!(
        at.x.abs() < 1e-12 && (0.0..2.0).contains(&at.y) && crossing.text.english().contains("crosses itself"),
        "{crossing:?}"
    );
    assert_eq!(bench.reshaping().shape().handle(2), Some(DVec2::new(-1.0, 1.0)), "the dragged outline is drawn");
    bench.act(EditAction::Drag(DVec2::new(1.2, 1.2)));
    assert!(bench.reshaping().crossing().is_none());
    bench.answer_all();
    bench.act(EditAction::Drag(DVec2::new(-1.0, 1.0)));
    bench.act(EditAction::Release);
    bench.answer_all();
    assert!(bench.editor.message().unwrap().english().contains("last good one was kept"));
    assert_eq!(bench.points()[2], DVec2::new(1.2, 1.2));
    assert!(bench.points() != good && bench.model.is_ready() && bench.reshaping().crossing().is_none());
    bench.act(EditAction::Dismiss);
    assert_eq!(bench.editor.message(), None);
}

#[test]
fn the_points_stay_where_they_are_and_come_back_when_the_outline_does() {
    let mut bench = Bench::square();
    let point = DVec2::new(1.6, 1.6);
    bench.model.dispatch(Command::MoveInterior { side: SIDE, point: point.into() }, 0.0);
    bench.model.dispatch(Command::MoveAnchor { side: SIDE, fraction: 0.125 }, 0.0);
    bench.answer_all();
    let anchor = bench.model.anchor(SIDE).unwrap();
    bench.act(EditAction::Grab(2, Hold::Pointer));
    bench.act(EditAction::Drag(DVec2::new(1.3, 1.3)));
    bench.answer_all();
    let pushed = bench.model.interior(SIDE).unwrap();
    let polygon = SimplePolygon::try_from(bench.points()).unwrap();
    assert!(polygon.contains(pushed) && pushed.distance(point) > 0.2, "{pushed}");
    bench.act(EditAction::Drag(DVec2::new(2.0, 2.4)));
    bench.act(EditAction::Release);
    bench.answer_all();
    assert_eq!(bench.model.interior(SIDE), Some(point), "the outline has room for it again");
    let moved = bench.model.anchor(SIDE).unwrap();
    assert!(moved.distance(anchor) < 1e-9, "{moved}, {anchor}: its edge did not move");
}

#[test]
fn an_outline_turned_inside_out_is_taken_the_other_way_round() {
    let points = [(0.0, 0.0), (2.0, 0.0), (1.0, 1.0)].map(DVec2::from).to_vec();
    let mut bench = Bench::of(OutlineSpec::points("triangle".into(), points.try_into().unwrap()));
    bench.model.dispatch(Command::MoveAnchor { side: SIDE, fraction: 0.1 }, 0.0);
    bench.answer_all();
    let anchor = bench.model.anchor(SIDE).unwrap();
    bench.act(EditAction::Grab(2, Hold::Pointer));
    bench.act(EditAction::Drag(DVec2::new(1.0, -1.0)));
    bench.act(EditAction::Release);
    bench.answer_all();
    assert_eq!(bench.points(), [(0.0, 0.0), (1.0, -1.0), (2.0, 0.0)].map(DVec2::from));
    assert!(bench.model.anchor(SIDE).unwrap().distance(anchor) < 1e-9);
    assert_eq!(bench.reshaping().shape().vertices(), bench.points());
}

#[test]
fn changes_without_a_drag_are_prepared_at_full_resolution() {
    let mut bench = Bench::square();
    bench.act(EditAction::Change(Change::Insert(DVec2::new(1.0, -0.1))));
    assert_eq!(bench.reshaping().selected, Some(1));
    assert_eq!(settings_of(&bench.requests()), SETTINGS);
    bench.act(EditAction::Grab(1, Hold::Keys));
    bench.act(EditAction::Drag(DVec2::new(1.0, -1.0)));
    bench.act(EditAction::Release);
    bench.answer_all();
    assert_eq!(bench.points().len(), 5);
    let point = DVec2::new(0.4, 0.7);
    bench.model.dispatch(Command::MoveInterior { side: SIDE, point: point.into() }, 0.0);
    bench.act(EditAction::Change(Change::Mirror));
    bench.answer_all();
    assert_eq!(bench.model.session().side(Side::Source).interior, Some(DVec2::new(1.6, 0.7)));
    let area = |bench: &Bench| SimplePolygon::try_from(bench.points()).unwrap().area();
    assert!((area(&bench) - 5.0).abs() < 1e-12);
    bench.act(EditAction::Change(Change::Smooth));
    bench.answer_all();
    assert!((area(&bench) - 5.0).abs() < 1e-9 && bench.points().len() > 100);
    let OutlineSpec::Points { name, .. } = &bench.model.session().domain(Side::Source).outline else { panic!() };
    assert_eq!(name, "square*");
}

#[test]
fn the_last_three_handles_cannot_be_removed_and_the_reason_is_given() {
    let mut bench = Bench::square();
    bench.act(EditAction::Change(Change::Remove(0)));
    bench.answer_all();
    assert_eq!(bench.points().len(), 3);
    bench.act(EditAction::Change(Change::Remove(0)));
    assert!(bench.editor.message().unwrap().english().contains("at least 3 handles"));
    assert!(bench.requests().is_empty() && bench.points().len() == 3);
}

#[test]
fn another_outline_is_followed_and_editing_moves_to_another_side() {
    let mut bench = Bench::square();
    bench.model.dispatch(Command::SetOutline { side: SIDE, outline: OutlineSpec::Preset(Preset::Star) }, 0.0);
    bench.answer_all();
    let star = Preset::Star.outline().polygon().vertices()[0];
    assert_eq!(bench.reshaping().shape().vertices()[0], star);
    bench.act(EditAction::Change(Change::Smooth));
    bench.answer_all();
    assert_eq!(
        crate::app::language::words::outline(&bench.model.session().domain(Side::Source).outline),
        "Star (edited)"
    );
    bench.act(EditAction::Toggle(Side::Target));
    assert_eq!(bench.editor.side(), Some(Side::Target));
    bench.act(EditAction::Leave);
    assert!(bench.editor.side().is_none());
}

#[test]
fn the_view_rests_while_editing_and_fits_afterwards() {
    let mut bench = Bench::square();
    assert!(bench.views.source.is_fitted());
    bench.act(EditAction::Grab(0, Hold::Pointer));
    assert!(!bench.views.source.is_fitted(), "the view does not refit during a drag");
    bench.act(EditAction::Toggle(SIDE));
    assert!(bench.views.source.is_fitted());
}

#[test]
fn a_link_carries_an_edited_preset() {
    let mut bench = Bench::of(OutlineSpec::Preset(Preset::Gingerbread));
    let at = bench.reshaping().shape().handle(3).unwrap();
    bench.act(EditAction::Grab(3, Hold::Pointer));
    bench.act(EditAction::Drag(at + DVec2::new(0.01, 0.01)));
    bench.act(EditAction::Release);
    bench.answer_all();
    let encoded = crate::session::link::encode(bench.model.session()).unwrap();
    assert_eq!(encoded.left_out, [], "{} points", bench.points().len());
}

#[test]
fn a_button_ends_the_drag_of_a_handle_by_keys() {
    let mut bench = Bench::square();
    bench.act(EditAction::Grab(2, Hold::Keys));
    bench.act(EditAction::Drag(DVec2::new(2.5, 2.5)));
    bench.act(EditAction::Change(Change::Remove(2)));
    let requests = bench.requests();
    assert_eq!(settings_of(&requests), SETTINGS);
    bench.answer(requests);
    bench.act(EditAction::Drag(DVec2::new(3.0, 3.0)));
    bench.act(EditAction::Release);
    bench.answer_all();
    assert_eq!(bench.points().len(), 3, "the removed handle does not come back");
}

fn pixel(bench: &mut Bench) {
    let rect = egui::Rect::from_min_size(egui::Pos2::ZERO, vec2(400.0, 400.0));
    let bounds = Some((DVec2::splat(-1.0), DVec2::splat(1.0)));
    bench.views.source.fit();
    bench.views.source.place(rect, 1.0, crate::app::viewport::view::DESK_MARGINS, bounds);
}

#[test]
fn clicked_points_become_the_outline_when_they_are_closed() {
    for (pen, area) in [(Pen::Lines, 2.0), (Pen::Curve, 2.73)] {
        let mut bench = Bench::square();
        pixel(&mut bench);
        bench.act(EditAction::Draw(SIDE, pen));
        for (x, y) in [(1.0, 0.0), (0.0, 1.0), (5.0, 5.0)] {
            bench.act(EditAction::Point(DVec2::new(x, y)));
        }
        bench.act(EditAction::TakeBack);
        bench.act(EditAction::Close);
        assert!(
            bench.editor.message().unwrap().english().contains("at least 3 points; 2"),
            "{:?}",
            bench.editor.message()
        );
        for (x, y) in [(-1.0, 0.0), (0.0, -1.0)] {
            bench.act(EditAction::Point(DVec2::new(x, y)));
        }
        bench.act(EditAction::Close);
        bench.answer_all();
        assert!(bench.editor.side().is_none() && bench.model.is_ready());
        let polygon = SimplePolygon::try_from(bench.points()).unwrap();
        // the curve through four points is not quite a circle, whose area would be 3.14
        assert!((polygon.area() / area - 1.0).abs() < 0.01, "{pen:?}: {}", polygon.area());
    }
}

#[test]
fn a_drawing_that_crosses_itself_stays_until_it_is_mended_and_a_stroke_begins_anew() {
    let bow = [(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)].map(DVec2::from);
    let mut bench = Bench::square();
    pixel(&mut bench);
    bench.act(EditAction::Draw(SIDE, Pen::Lines));
    for point in bow {
        bench.act(EditAction::Point(point));
    }
    bench.act(EditAction::Close);
    let at = bench.editor.crossing().unwrap().at.unwrap();
    assert!(at.distance(DVec2::splat(0.5)) < 1e-12 && bench.requests().is_empty(), "{at}");
    bench.act(EditAction::TakeBack);
    assert!(bench.editor.message().is_none() && bench.editor.drawing(SIDE).unwrap().points().len() == 3);
    bench.act(EditAction::Draw(SIDE, Pen::Freehand));
    bench.act(EditAction::Point(DVec2::ZERO));
    bench.act(EditAction::Close);
    assert!(bench.editor.message().unwrap().english().contains("too short"));
    for k in 0..100 {
        bench.act(EditAction::Point(DVec2::from_angle(0.062 * f64::from(k))));
    }
    assert_eq!(bench.editor.drawing(SIDE).unwrap().points().len(), 100, "the first stroke is gone");
    bench.act(EditAction::Close);
    bench.answer_all();
    let area = SimplePolygon::try_from(bench.points()).unwrap().area();
    assert!((area / std::f64::consts::PI - 1.0).abs() < 0.02, "{area}");
}

#[test]
fn pasted_text_becomes_the_outline_and_other_text_is_shown_with_its_error() {
    let mut bench = Bench::square();
    let take = |bench: &mut Bench, text: &str| {
        bench.editor.take_text(text.into(), &mut bench.model);
        bench.answer_all();
    };
    take(&mut bench, "M 0 0 h 4 v 1 h -4 z");
    assert!(bench.editor.paste.is_none() && bench.editor.side().is_none());
    assert_eq!(SimplePolygon::try_from(bench.points()).unwrap().area(), 4.0);
    take(&mut bench, "no outline at all");
    assert!(bench.editor.paste.as_ref().and_then(Paste::error).is_some());
    assert_eq!(bench.points().len(), 4, "the last good one stays");
    bench.act(EditAction::ClosePaste);
    assert!(bench.editor.paste.is_none());
}

#[test]
fn a_long_text_is_read_without_being_shown() {
    let mut bench = Bench::square();
    let ring = |count: u32| {
        let angle = |k: u32| std::f64::consts::TAU * f64::from(k) / f64::from(count);
        (0..count)
            .map(|k| DVec2::from_angle(angle(k)))
            .map(|p| format!("{:.12},{:.12}\n", p.x, p.y))
            .collect::<Vec<_>>()
            .concat()
    };
    let text = ring(3000);
    assert!(text.len() > paste::LONGEST_SHOWN, "{}", text.len());
    bench.editor.take_text(text.clone(), &mut bench.model);
    bench.answer_all();
    assert!(bench.editor.paste.is_none() && bench.points().len() == 3000);
    bench.editor.take_text(text.replacen('\n', "\nand so on\n", 1), &mut bench.model);
    bench.answer_all();
    let paste = bench.editor.paste.as_ref().unwrap();
    let error = paste.error().unwrap().english();
    assert!(error.contains("line 2") && error.contains(" bytes") && error.contains("50000"), "{error}");
    assert!(paste.text().is_empty());
}
