//! Layout: all controls are on the screen and do not overlap, on a desktop, a tablet and a phone, in both languages.

use crate::app::input::action::{EditAction, ExploreAction, ExportAction, LessonAction, Report};
use crate::app::input::preferences::Preferences;
use crate::app::panels::offer::Offer;
use crate::app::tests::{ready_app, step_until};
use crate::app::viewport::legend;
use crate::app::*;
use crate::conformal::Side;
use crate::language::{self, Label, Language, key, tr};
use crate::model::side::user_error::UserError;
use crate::session::{Colouring, Command, OutlineSpec, SurfaceShape, SurfaceSpec};
use crate::surface::SurfacePreset;
use crate::worker::Sketch;
use egui::{Key, Rect, Role};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use std::sync::Arc;

const DESK: [f32; 2] = [1440.0, 900.0];
const TABLET: [f32; 2] = [820.0, 1180.0];
const PHONE: [f32; 2] = [390.0, 844.0];
/// The lowest screen: a phone in landscape.
const LYING_PHONE: [f32; 2] = [844.0, 390.0];
/// An iframe in another page.
const FRAME: [f32; 2] = [480.0, 320.0];
/// The height of the top bar.
const BAR: f32 = 46.0;

type Screen = Harness<'static, RiemapApp>;

/// The app on a screen of this size, with touch unless it is [`DESK`].
fn screen(size: [f32; 2], language: Language) -> Screen {
    let mut screen = ready_app(size);
    screen.state_mut().screen.has_fingers = size != DESK;
    screen.state_mut().screen.preferences = Preferences { language: Some(language), ..Preferences::fixed() };
    language::set(language);
    screen.run_steps(4);
    screen
}

fn act(screen: &mut Screen, action: Action) {
    let context = screen.ctx.clone();
    screen.state_mut().carry_out(&context, vec![action]);
    screen.run_steps(8);
}

/// The buttons whose rectangles satisfy `is_there`, from left to right.
fn buttons(screen: &Screen, is_there: impl Fn(Rect) -> bool) -> Vec<(String, Rect)> {
    let nodes = screen.root().children_recursive().filter_map(|node| {
        let accessible = node.accesskit_node();
        let label = accessible.label().filter(|_| accessible.role() == Role::Button)?;
        Some((label, node.rect()))
    });
    let mut found: Vec<_> = nodes.filter(|(_, rect)| is_there(*rect)).collect();
    found.sort_by(|(_, a), (_, b)| a.left().total_cmp(&b.left()));
    found
}

fn assert_in_a_row(found: &[(String, Rect)], place: Rect, where_: &str) {
    for (label, rect) in found {
        assert!(place.contains_rect(*rect), "{where_}: {label} at {rect:?} is cut off by {place:?}");
    }
    for pair in found.windows(2) {
        assert!(pair[0].1.right() <= pair[1].1.left(), "{where_}: {pair:?} overlap");
    }
}

fn whole(screen: &Screen) -> Rect {
    screen.ctx.content_rect()
}

#[test]
fn the_bar_along_the_top_has_room_for_what_it_shows() {
    for language in [Language::English, Language::German] {
        for (width, least) in [(360.0, 4), (390.0, 4), (700.0, 6), (820.0, 7), (1024.0, 7), (1440.0, 8)] {
            let screen = screen([width, 800.0], language);
            let found = buttons(&screen, |rect| rect.top() < BAR && rect.bottom() <= BAR);
            assert!(found.len() >= least, "{width} points: {found:?}");
            assert_in_a_row(&found, whole(&screen), &format!("{language:?}, {width} points"));
        }
    }
}

#[test]
fn the_buttons_over_a_picture_have_room_beside_its_title() {
    for language in [Language::English, Language::German] {
        for size in [DESK, TABLET, PHONE] {
            let screen = screen(size, language);
            for (_, view) in screen.state().pictures.views.iter() {
                let line = view.rect.with_max_y(view.rect.top() + 60.0);
                let found = buttons(&screen, |rect| line.contains(rect.center()));
                assert!(found.len() >= 2, "{found:?}");
                let beside_title = line.with_min_x(line.left() + 90.0);
                assert_in_a_row(&found, beside_title, &format!("{language:?}, {size:?}"));
            }
        }
    }
}

#[test]
fn windows_fit_and_are_closed_with_a_finger() {
    for size in [DESK, TABLET, PHONE, LYING_PHONE] {
        let mut screen = screen(size, Language::English);
        let finger = if size == DESK { theme::ROW_HEIGHT } else { theme::FINGER_HEIGHT };
        for action in [
            Action::Explore(ExploreAction::Gallery),
            Action::Explore(ExploreAction::Figures),
            Action::Explore(ExploreAction::Shortcuts),
            Action::Export(ExportAction::Open),
            Action::OpenReport(Report::Convergence),
        ] {
            act(&mut screen, action.clone());
            let close = screen.get_by_label("Close").rect();
            assert!(whole(&screen).contains_rect(close), "{action:?} on {size:?}: the button is at {close:?}");
            assert!(close.size().min_elem() >= finger - 0.1, "{action:?} on {size:?}: {:?}", close.size());
            screen.get_by_label("Close").click();
            screen.run_steps(20);
            assert!(screen.query_by_label("Close").is_none(), "{action:?} on {size:?} is still open");
        }
    }
}

#[test]
fn a_list_is_as_high_as_the_screen_allows() {
    let mut screen = screen(TABLET, Language::English);
    let check = |screen: &Screen, [first, last, below]: [&'static str; 3]| {
        let at = |label| screen.query_all_by_label(label).next().unwrap().rect();
        let height = at(last).bottom() - at(first).top();
        assert!(height > 400.0 && at(last).bottom() < at(below).top(), "{height} points until {:?}", at(last));
    };
    act(&mut screen, Action::Explore(ExploreAction::Figures));
    check(&screen, ["m = 25", "x₁ = 0", "Tables 1 and 2 · times on this machine, beside the paper's"]);
    screen.key_press(Key::Escape);
    screen.run_steps(4);
    act(&mut screen, Action::Explore(ExploreAction::Shortcuts));
    check(&screen, ["Drag a dot", "Space or Enter", "Close"]);
}

#[test]
fn the_papers_figures_are_reached_on_a_phone() {
    let mut screen = screen(PHONE, Language::English);
    assert!(screen.query_by_label("Figures").is_none());
    screen.get_by_label("Help").click();
    screen.run_steps(4);
    screen.get_by_label("The paper's figures…").click();
    screen.run_steps(4);
    screen.query_all_by_label("m = 50").next().unwrap().click();
    let disk = OutlineSpec::Preset(crate::outline::Preset::Disk);
    for _ in 0..600 {
        screen.step();
        if screen.state().session().domain(Side::Target).outline == disk {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(20)); // until the disk is prepared
    }
    assert_eq!(screen.state().session().domain(Side::Target).outline, disk, "Figure 6 is of the disk");
    assert!(screen.query_by_label("Close").is_none(), "the map takes the window's place");
}

#[test]
fn a_tablet_has_one_plot_at_a_time_and_a_desk_all() {
    for (size, expected) in [(TABLET, 1), (DESK, 3)] {
        let mut screen = screen(size, Language::English);
        screen.key_press(Key::P);
        screen.run_steps(4);
        let titles = ["Poisson kernel", "Harmonic measure", "Reparameterization"];
        assert_eq!(titles.iter().filter(|title| screen.query_by_label(title).is_some()).count(), expected);
    }
}

/// Checks that the edit bar of the target is between the outline and the legend of triangle colors.
fn assert_bar_between(screen: &mut Screen, where_: &str) {
    act(screen, Action::Session(crate::session::Command::SetColouring(Colouring::Angle)));
    act(screen, Action::Edit(EditAction::Toggle(Side::Target)));
    let app = screen.state();
    let view = &app.pictures.views[Side::Target];
    let arrangement = arrangement::Arrangement { narrow: whole(screen).width() < theme::PHONE_WIDTH, stacked: false };
    let legend = view.rect.bottom() - legend::height(view.rect, arrangement.is_tight(view.rect));
    let (low, _) = app.model.extent(Side::Target).unwrap();
    let outline = view.to_screen(low).y;
    let names = [key::smooth(), key::mirror(), key::delete(), key::finish_editing()].map(tr);
    let mut bar: Vec<_> = buttons(screen, |rect| view.rect.contains(rect.center()));
    bar.retain(|(label, _)| names.contains(&label.as_str()));
    assert_eq!(bar.len(), names.len(), "{where_}: {bar:?}");
    let place = view.rect.with_min_y(outline).with_max_y(legend);
    for (k, (label, rect)) in bar.iter().enumerate() {
        assert!(place.contains_rect(*rect), "{where_}: {label} at {rect:?} is not in {place:?}");
        let covers = bar[..k].iter().any(|(_, other)| other.shrink(0.1).intersects(*rect));
        assert!(!covers, "{where_}: {bar:?} overlap");
    }
}

#[test]
fn the_edit_bar_lies_below_the_outline_and_above_the_legend() {
    for language in [Language::English, Language::German] {
        for size in [DESK, TABLET, PHONE, LYING_PHONE] {
            assert_bar_between(&mut screen(size, language), &format!("{language:?}, {size:?}"));
        }
    }
}

#[test]
fn the_pictures_are_side_by_side_in_landscape_and_stacked_in_portrait() {
    for (size, stacked) in [(FRAME, false), (LYING_PHONE, false), (PHONE, true), (TABLET, true)] {
        let mut screen = screen(size, Language::English);
        screen.state_mut().screen.sheet_open = true;
        screen.run_steps(40); // it slides
        let [source, target] = screen.state().pictures.views.as_ref().map(|view| view.rect).into_array();
        assert_eq!(source.bottom() <= target.top(), stacked, "{size:?}: {source:?} and {target:?}");
    }
}

/// The offer to trace a dropped image.
fn offer() -> Offer {
    let pixels = image::RgbaImage::from_pixel(20, 20, image::Rgba([9, 9, 9, 255]));
    Offer::new(Side::Source, &crate::model::files::Picture { name: "a.png".into(), pixels })
}

/// The lower edge of the pictures.
fn message_bar_top(screen: &Screen) -> f32 {
    screen.state().pictures.views.iter().map(|(_, view)| view.rect.bottom()).fold(0.0, f32::max)
}

#[test]
fn a_message_about_both_sides_covers_nothing_and_can_be_closed() {
    for size in [DESK, PHONE, LYING_PHONE, FRAME] {
        let mut screen = screen(size, Language::English);
        act(&mut screen, Action::Edit(EditAction::Toggle(Side::Source)));
        let before = message_bar_top(&screen);
        screen.state_mut().messages.common = Some("Not saved: there is no room. ".repeat(3).into());
        screen.state_mut().messages.offer = Some(offer());
        screen.run_steps(4);
        let below = Rect::everything_below(message_bar_top(&screen)).intersect(whole(&screen));
        for label in ["Trace it as outline", "No", "Close this message"] {
            let button = screen.get_by_label(label).rect();
            assert!(below.contains_rect(button), "{size:?}: {label} at {button:?} is not in {below:?}");
        }
        screen.state_mut().messages.common = Some("The link could not be opened: ".repeat(200).into());
        screen.run_steps(4);
        assert!(before - message_bar_top(&screen) < 160.0, "{size:?}: a long message is folded");
        screen.get_by_label("More").click();
        screen.run_steps(4);
        let share = (before - message_bar_top(&screen)) / before;
        assert!((0.25..0.5).contains(&share), "{size:?}: a long message takes {share} of the height");
        (screen.state_mut().messages.common, screen.state_mut().messages.offer) = (Some("Not saved.".into()), None);
        screen.run_steps(4);
        assert!(
            before - message_bar_top(&screen) < 75.0,
            "{size:?}: a short one takes {}",
            before - message_bar_top(&screen)
        );
        screen.get_by_label("Close this message").click();
        screen.run_steps(3);
        assert!(screen.state().messages.common.is_none() && message_bar_top(&screen) == before);
    }
}

#[test]
fn a_message_does_not_change_the_stacking_and_waits_for_the_end_of_a_drag() {
    // the area of the pictures is nearly square
    let mut screen = screen([1080.0, 900.0], Language::English);
    let stacked = |screen: &Screen| {
        let [source, target] = screen.state().pictures.views.as_ref().map(|view| view.rect).into_array();
        source.bottom() <= target.top()
    };
    assert!(stacked(&screen));
    let (before, place) = (message_bar_top(&screen), screen.state().stats().screen.handles.x1.unwrap());
    screen.drag_at(place.into());
    screen.step();
    screen.state_mut().messages.common = Some("Not saved.".into());
    screen.run_steps(3);
    assert_eq!(message_bar_top(&screen), before, "a dot is held");
    screen.drop_at(place.into());
    screen.run_steps(3);
    assert!(message_bar_top(&screen) < before && stacked(&screen));
}

#[test]
fn a_long_message_of_a_side_ends_above_the_edit_bar() {
    for size in [DESK, TABLET, PHONE, LYING_PHONE] {
        let mut screen = screen(size, Language::English);
        act(&mut screen, Action::Session(crate::session::Command::SetColouring(Colouring::Angle)));
        act(&mut screen, Action::Edit(EditAction::Toggle(Side::Target)));
        let text = "This outline is none, for a reason that takes some words. ".repeat(40);
        screen.state_mut().model.refuse(Side::Target, UserError::new(text.into()));
        screen.run_steps(4);
        let bar = screen.get_by_label("Smooth").rect();
        let at = bar.center() - egui::vec2(0.0, bar.height());
        screen.hover_at(at);
        screen.event(egui::Event::MouseWheel {
            unit: egui::MouseWheelUnit::Point,
            delta: egui::vec2(0.0, -9000.0),
            source: egui::MouseWheelSource::Unknown,
            phase: egui::TouchPhase::Move,
            modifiers: egui::Modifiers::NONE,
        });
        screen.run_steps(30); // egui scrolls smoothly
        let cross = screen.get_by_label("Close this message").rect();
        assert!(cross.bottom() < bar.top(), "{size:?}: the cross at {cross:?} is under the bar at {bar:?}");
    }
}

#[test]
fn the_buttons_of_a_lesson_in_german_do_not_overlap_and_undo_and_redo_are_in_one_row() {
    for size in [[1280.0, 720.0], TABLET, PHONE, [320.0, 640.0], LYING_PHONE] {
        let mut screen = screen(size, Language::German);
        for action in [LessonAction::Open, LessonAction::Add, LessonAction::Add, LessonAction::Undo] {
            act(&mut screen, Action::Lesson(action));
        }
        let rects_of =
            |label: Label| -> Vec<Rect> { screen.get_all_by_label(tr(label)).map(|node| node.rect()).collect() };
        let row = [key::show_step(), key::renew_step(), key::step_up(), key::step_down(), key::delete_step()];
        let [undo, redo] = [key::undo_in_lesson(), key::redo_in_lesson()].map(|label| rects_of(label)[0]);
        assert!((undo.center().y - redo.center().y).abs() < 1.0, "{size:?}: {undo:?}, {redo:?}");
        let all: Vec<Rect> = row.into_iter().flat_map(rects_of).chain([undo, redo]).collect();
        for (k, a) in all.iter().enumerate() {
            let covered = all[..k].iter().find(|b| a.shrink(0.5).intersects(**b));
            assert!(covered.is_none(), "{size:?}: {a:?} over {covered:?}");
        }
    }
}

#[test]
fn a_fitted_surface_lies_below_its_title_and_above_the_legend() {
    for size in [[720.0, 450.0], TABLET, PHONE, LYING_PHONE] {
        let mut screen = screen(size, Language::English);
        let shape = SurfaceShape::Preset { preset: SurfacePreset::AnimalHead, boundary: 60 };
        let surface = SurfaceSpec { shape, ..SurfaceSpec::default() };
        act(&mut screen, Action::Session(Command::SetSurface { side: Side::Target, surface }));
        act(&mut screen, Action::Session(Command::SetColouring(Colouring::Area)));
        let is_colored =
            |app: &RiemapApp| app.model.surface(Side::Target).is_some() && app.pictures.cells.scale().is_some();
        step_until(&mut screen, is_colored);
        screen.run_steps(4);
        let app = screen.state();
        let orbit = &app.pictures.orbits[Side::Target];
        let narrow = whole(&screen).width() < theme::PHONE_WIDTH;
        let arrangement = arrangement::Arrangement { narrow, stacked: size[0] < size[1] };
        let legend = orbit.rect.bottom() - legend::height(orbit.rect, arrangement.is_tight(orbit.rect));
        let title = screen.get_by_label_contains("Animal head").rect();
        let free = orbit.rect.with_min_y(title.bottom()).with_max_y(legend);
        let (surface, _) = app.model.surface(Side::Target).unwrap();
        let places = surface.surface().unwrap().mesh().vertices().iter().filter_map(|&p| orbit.to_screen(p));
        let seen = Rect::from_points(&places.collect::<Vec<_>>());
        assert!(free.contains_rect(seen) && seen.height() > 0.4 * free.height(), "{size:?}: {seen:?} in {free:?}");
    }
}

#[test]
fn a_narrow_picture_has_room_for_its_whole_title_and_a_legend_in_symbols() {
    let mut screen = screen([720.0, 450.0], Language::English);
    screen.get_by_label("interior point x₁");
    act(&mut screen, Action::Lesson(LessonAction::Open));
    let picture = screen.state().pictures.views.source.rect;
    for symbol in ["x₁", "y₁", "Gingerbread man"] {
        assert!(picture.contains_rect(screen.get_by_label(symbol).rect()), "{symbol} is in {picture:?}");
    }
    let beside: Vec<String> = buttons(&screen, |rect| picture.contains_rect(rect)).into_iter().map(|it| it.0).collect();
    assert_eq!(beside, ["Edit"], "no button takes the room of the title");
}

#[test]
fn beside_the_panel_of_a_lesson_a_tablet_keeps_half_of_its_width_for_the_pictures() {
    let mut screen = screen(TABLET, Language::English);
    act(&mut screen, Action::Lesson(LessonAction::Open));
    let width = |screen: &Screen| screen.state().pictures.views.source.rect.width();
    assert!(width(&screen) > 0.5 * TABLET[0], "{}", width(&screen));
    act(&mut screen, Action::ToggleColumn);
    assert!(width(&screen) < 0.5 * TABLET[0], "the column is there when it is asked for");
}

#[test]
fn the_faults_of_a_surface_are_shown_below_their_message_inside_of_the_picture() {
    for size in [DESK, TABLET, PHONE, LYING_PHONE] {
        let mut screen = screen(size, Language::English);
        let corners = [[0, 0, 0], [32767, 0, 0], [0, 32767, 9000]];
        let edges = vec![[corners[0], corners[1]]];
        let sketch = Sketch { triangles: vec![corners], edges, vertices: Vec::new(), unmarked: 3 };
        let error =
            UserError { sketch: Some(Arc::new(sketch)), ..UserError::new("An edge has three triangles.".into()) };
        screen.state_mut().model.refuse(Side::Target, error);
        screen.run_steps(4);
        let picture = screen.state().pictures.views[Side::Target].rect;
        let message = screen.get_by_label_contains("three triangles").rect();
        let sketch = screen.get_by_label_contains("1 of its faults in red (3 more are not marked)").rect();
        assert!(
            message.bottom() < sketch.top() && picture.contains_rect(sketch),
            "{size:?}: {sketch:?} in {picture:?}"
        );
        screen.drag_at(sketch.center());
        screen.hover_at(sketch.center() + egui::vec2(40.0, 0.0));
        screen.drop_at(sketch.center() + egui::vec2(40.0, 0.0));
        screen.run_steps(2);
        screen.get_by_label("Close this message").click();
        screen.run_steps(2);
        assert!(screen.query_by_label_contains("faults in red").is_none());
    }
}

#[test]
fn messages_of_a_side_lie_over_its_dots() {
    let mut screen = screen(LYING_PHONE, Language::English);
    let text = "This outline is none, for a reason that takes some words. ".repeat(6);
    screen.state_mut().model.refuse(Side::Source, UserError::new(text.into()));
    screen.run_steps(4);
    screen.get_by_label("More").click();
    screen.run_steps(4);
    let source = egui::Pos2::from(screen.state().stats().screen.handles.x1.unwrap());
    assert!(screen.get_by_label_contains("is none").rect().contains(source), "the dot is under the message");
    let place = |is: &dyn Fn(&egui::Shape) -> bool| {
        screen.output().shapes.iter().rposition(|clipped| is(&clipped.shape)).unwrap()
    };
    let words = place(&|shape| matches!(shape, egui::Shape::Text(text) if text.galley.text().contains("is none")));
    let dot = place(&|shape| matches!(shape, egui::Shape::Circle(dot) if dot.center.distance(source) < 1.0));
    assert!(dot < words, "the dot is painted before the words");
}

#[test]
fn on_a_phone_in_landscape_tour_and_message_leave_the_pictures_room() {
    for size in [[667.0, 375.0], LYING_PHONE] {
        let mut screen = screen(size, Language::German);
        act(&mut screen, Action::Explore(ExploreAction::Tour(0)));
        let see = |screen: &Screen, button: &str| {
            for (_, view) in screen.state().pictures.views.iter() {
                assert!(view.rect.height() > 150.0, "{size:?}, {button}: {:?}", view.rect);
            }
            let rect = screen.get_by_label(button).rect();
            assert!(whole(screen).contains_rect(rect), "{size:?}: {button} at {rect:?}");
        };
        see(&screen, "Weiter");
        screen.state_mut().messages.common = Some("The link could not be opened: it is none. ".repeat(3).into());
        screen.run_steps(4);
        assert!(screen.query_by_label("Weiter").is_none(), "the message replaces the tour");
        see(&screen, "Diese Meldung schließen");
        act(&mut screen, Action::DismissMessage);
        see(&screen, "Weiter");
    }
}

#[test]
fn a_narrow_picture_has_one_of_fit_and_swap_and_keeps_its_title() {
    let mut screen = screen(LYING_PHONE, Language::German);
    act(&mut screen, Action::ToggleColumn);
    let there = |screen: &Screen| {
        ["Tauschen", "Einpassen"].map(|label| {
            let view = screen.state().pictures.views.target.rect;
            buttons(screen, |rect| view.contains(rect.center())).iter().any(|(found, _)| found == label)
        })
    };
    assert_eq!(there(&screen), [true, false]);
    let middle = screen.state().pictures.views.target.rect.center();
    screen.state_mut().pictures.views.target.zoom(2.0, middle);
    screen.run_steps(3);
    assert_eq!(there(&screen), [false, true]);
}
