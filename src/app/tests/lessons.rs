//! Lessons on the screen: made in their panel, played on the card of the tour, and ended.

use crate::app::input::action::{Action, EditAction, ExploreAction, LessonAction};
use crate::app::tests::{ready_app, step_until};
use crate::app::{RiemapApp, Startup};
use crate::conformal::Side;
use crate::model::files::FilePurpose;
use crate::outline::Preset;
use crate::session::lesson::{self, Lesson, Step};
use crate::session::{Command, OutlineSpec, Session, SurfaceShape, SurfaceSpec, scaled};
use crate::surface::SurfacePreset;
use egui::Key;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};

type Screen = Harness<'static, RiemapApp>;

fn act(screen: &mut Screen, actions: impl IntoIterator<Item = LessonAction>) {
    let context = screen.ctx.clone();
    screen.state_mut().carry_out(&context, actions.into_iter().map(Action::Lesson).collect());
    screen.run_steps(3);
}

fn draft(screen: &Screen) -> &Lesson {
    screen.state().windows.lesson.draft()
}

fn captions(screen: &Screen) -> Vec<&str> {
    draft(screen).steps.iter().map(|step| step.caption.as_str()).collect()
}

fn two_steps() -> Lesson {
    let step = |scale, caption: &str| Step::of(&scaled(scale), caption.into()).unwrap().0;
    Lesson { title: "Angles".into(), steps: vec![step(9.0, "wide"), step(33.0, "fine")] }
}

#[test]
fn steps_are_added_moved_renewed_and_deleted_and_all_of_it_can_be_taken_back() {
    let mut screen = ready_app([1440.0, 900.0]);
    act(&mut screen, [LessonAction::Open]);
    screen.get_by_label("Add step").click();
    screen.run_steps(3);
    let context = screen.ctx.clone();
    screen.state_mut().carry_out(&context, vec![Action::Session(Command::SetTextureScale(9.0))]);
    let words = |k: usize, text: &str| LessonAction::Caption(k, text.into());
    act(&mut screen, [LessonAction::Add, words(0, "one"), words(1, "two"), words(7, "none")]);
    act(&mut screen, [LessonAction::Swap(0), LessonAction::Swap(1)]);
    assert_eq!(captions(&screen), ["two", "one"]);
    act(&mut screen, [LessonAction::Renew(1)]);
    assert_eq!((captions(&screen), draft(&screen).steps[1].session().texture_scale()), (vec!["two", "one"], 9.0));
    act(&mut screen, [LessonAction::Delete(0)]);
    assert_eq!(captions(&screen), ["one"]);
    screen.get_by_label("Step deleted");
    screen.get_by_label("Undo in the lesson").click();
    screen.run_steps(3);
    assert_eq!(captions(&screen), ["two", "one"]);
    screen.get_by_label("Step 2 updated");
    act(&mut screen, [LessonAction::Undo, LessonAction::Undo]);
    assert_eq!(captions(&screen), ["one", "two"]);
    act(&mut screen, [LessonAction::Undo]);
    assert_eq!(captions(&screen), ["one", ""]);
    for _ in 0..4 {
        screen.get_by_label("Redo in the lesson").click();
        screen.run_steps(3);
    }
    assert_eq!(captions(&screen), ["one"]);
    assert!(screen.get_by_label("Redo in the lesson").accesskit_node().is_disabled());
}

/// Plays the lesson of two steps.
fn play(screen: &mut Screen) {
    screen.state_mut().play_lesson(two_steps());
    screen.run_steps(3);
    assert!(screen.state().windows.explore.plays_lesson());
}

#[test]
fn a_surface_that_is_not_there_yet_when_a_lesson_begins_is_there_when_it_ends() {
    let shape = SurfaceShape::Preset { preset: SurfacePreset::AnimalHead, boundary: 60 };
    let surface = SurfaceSpec { shape, ..SurfaceSpec::default() };
    let own = Session::default().and([Command::SetSurface { side: Side::Target, surface }]);
    let startup = Startup::start(own.clone());
    let mut screen = Harness::builder()
        .with_size([1200.0, 800.0])
        .build_eframe(|creation| RiemapApp::new(creation, startup).unwrap());
    play(&mut screen);
    step_until(&mut screen, |app| app.model.is_ready());
    screen.key_press(Key::Escape);
    screen.step();
    step_until(&mut screen, |app| app.model.is_ready() && !app.windows.explore.is_touring());
    assert_eq!(*screen.state().session(), own);
}

#[test]
fn a_lesson_gives_back_what_was_being_prepared_and_what_can_be_redone() {
    let mut screen = ready_app([1200.0, 800.0]);
    let context = screen.ctx.clone();
    let carry_out = |screen: &mut Screen, action| {
        screen.state_mut().carry_out(&context, vec![action]);
        step_until(screen, |app| app.model.is_ready());
        screen.run_steps(2);
    };
    carry_out(&mut screen, Action::Session(Command::SetTextureScale(9.0)));
    carry_out(&mut screen, Action::Undo);
    let steps = |screen: &Screen| {
        let history = screen.state().persistence.history();
        (history.undo_count(), history.can_redo())
    };
    assert_eq!(steps(&screen), (0, true));
    play(&mut screen);
    carry_out(&mut screen, Action::Explore(ExploreAction::LeaveTour { keeps: false }));
    assert_eq!(steps(&screen), (0, true), "the lesson was no step");
    let star = OutlineSpec::Preset(Preset::Star);
    let command = Command::SetOutline { side: Side::Source, outline: star.clone() };
    let wanted = screen.state().session().clone().and([command.clone()]);
    screen.state_mut().carry_out(&context, vec![Action::Session(command)]);
    assert_ne!(screen.state().session().domain(Side::Source).outline, star, "it is being prepared");
    play(&mut screen);
    carry_out(&mut screen, Action::Explore(ExploreAction::LeaveTour { keeps: false }));
    assert_eq!(*screen.state().session(), wanted);
    carry_out(&mut screen, Action::Undo);
    assert_ne!(screen.state().session().domain(Side::Source).outline, star);
}

#[test]
fn the_picture_of_a_step_is_shown_and_undo_brings_the_own_one_back() {
    let mut screen = ready_app([1200.0, 800.0]);
    screen.state_mut().windows.lesson.replace(two_steps());
    let own = screen.state().session().clone();
    act(&mut screen, [LessonAction::Show(1)]);
    step_until(&mut screen, |app| app.session().texture_scale() == 33.0 && app.model.is_ready());
    screen.run_steps(2);
    let context = screen.ctx.clone();
    screen.state_mut().carry_out(&context, vec![Action::Undo]);
    step_until(&mut screen, |app| app.model.is_ready());
    assert_eq!(*screen.state().session(), own);
}

#[test]
fn while_an_outline_is_edited_no_picture_is_taken_or_shown_and_the_reason_is_said() {
    let mut screen = ready_app([1440.0, 900.0]);
    act(&mut screen, [LessonAction::Open, LessonAction::Add]);
    let context = screen.ctx.clone();
    screen.state_mut().carry_out(&context, vec![Action::Edit(EditAction::Toggle(Side::Source))]);
    screen.run_steps(3);
    screen.get_by_label("Finish or cancel the editing of the outline first");
    for button in ["Add step", "Update", "Play lesson"] {
        assert!(screen.get_by_label(button).accesskit_node().is_disabled(), "{button}");
    }
    assert!(!screen.get_by_label("Copy link").accesskit_node().is_disabled());
    act(&mut screen, [LessonAction::Add, LessonAction::Play]);
    assert_eq!(draft(&screen).steps.len(), 1);
    let text = lesson::write(&two_steps(), |fragment| format!("#{fragment}")).unwrap();
    screen.state_mut().take_file(FilePurpose::Dropped(Side::Source), "class.txt", Ok(text.into_bytes()));
    screen.run_steps(3);
    let app = screen.state();
    assert!(!app.windows.explore.is_touring() && app.editor.side().is_some(), "the editing goes on");
    assert!(app.messages.common.as_ref().is_some_and(|message| message.english().contains("editing of the outline")));
    let link = format!("#{}", lesson::encode(&two_steps()).unwrap());
    assert!(screen.state_mut().try_link(&link).is_err());
}

#[test]
fn a_lesson_is_played_on_the_card_and_escape_brings_the_picture_from_before_back() {
    let mut screen = ready_app([1200.0, 800.0]);
    let own = screen.state().session().clone();
    let text = lesson::write(&two_steps(), |fragment| format!("#{fragment}")).unwrap();
    screen.state_mut().take_file(FilePurpose::Dropped(Side::Source), "class.txt", Ok(text.into_bytes()));
    screen.run_steps(3);
    screen.get_by_label("1 of 2");
    screen.get_by_label("wide");
    assert_eq!(screen.state().session().texture_scale(), 9.0);
    screen.get_by_label("Next").click();
    screen.run_steps(3);
    screen.get_by_label("fine");
    assert_eq!(screen.state().session().texture_scale(), 33.0);
    screen.key_press(Key::Escape);
    screen.run_steps(3);
    assert!(!screen.state().windows.explore.is_touring());
    assert_eq!(*screen.state().session(), own);
}

#[test]
fn a_lesson_that_cannot_be_read_says_where_and_nothing_changes() {
    let mut screen = ready_app([1200.0, 800.0]);
    let text = lesson::write(&two_steps(), |fragment| format!("#{fragment}")).unwrap().replacen("s=1.", "s=1.AAAA", 2);
    screen.state_mut().take_file(FilePurpose::Session, "class.txt", Ok(text.into_bytes()));
    screen.run_steps(2);
    let errors = screen.state().errors();
    assert!(errors[0].english().starts_with("class.txt: step 1 (line 4): the link is damaged"), "{errors:?}");
    assert!(!screen.state().windows.explore.is_touring());
    let refused = screen.state_mut().try_link("#lesson=7.x").unwrap_err().english();
    assert!(refused.contains("version 7"), "{refused}");
}

#[test]
fn a_link_plays_its_lesson() {
    let mut screen = ready_app([1200.0, 800.0]);
    let link = format!("https://example.org/#{}", lesson::encode(&two_steps()).unwrap());
    screen.state_mut().try_link(&link).unwrap();
    screen.run_steps(3);
    screen.get_by_label("Angles");
    step_until(&mut screen, |app| app.model.is_ready());
    assert!(screen.state().windows.explore.plays_lesson());
}

#[test]
fn a_file_for_the_panel_replaces_the_draft_which_can_be_brought_back() {
    let mut screen = ready_app([1200.0, 800.0]);
    act(&mut screen, [LessonAction::Open, LessonAction::Add]);
    let text = lesson::write(&two_steps(), |fragment| format!("#{fragment}")).unwrap();
    screen.state_mut().take_file(FilePurpose::Lesson, "class.txt", Ok(text.into_bytes()));
    screen.run_steps(3);
    assert_eq!(draft(&screen), &two_steps());
    assert!(!screen.state().windows.explore.is_touring());
    act(&mut screen, [LessonAction::Undo]);
    assert_eq!(draft(&screen).steps.len(), 1);
}

#[test]
fn what_no_link_holds_is_refused_with_its_name_and_the_lesson_stays() {
    let mut screen = ready_app([1200.0, 800.0]);
    act(&mut screen, [LessonAction::Open]);
    let shape = SurfaceShape::File { name: "cow.obj".into() };
    let surface = SurfaceSpec { shape, ..SurfaceSpec::default() };
    let open = Command::SetSurface { side: Side::Target, surface };
    let session = screen.state().session().clone().and([open]);
    assert!(Step::of(&session, String::new()).is_err());
    let image = Command::SetTexture(crate::session::TextureKind::Image);
    let context = screen.ctx.clone();
    screen.state_mut().carry_out(&context, vec![Action::Session(image)]);
    act(&mut screen, [LessonAction::Add]);
    assert!(draft(&screen).steps.is_empty());
    screen.get_by_label_contains("an own picture");
}

#[test]
fn on_every_screen_the_panel_leaves_half_of_the_height_and_its_buttons_are_seen() {
    for size in [[1440.0, 900.0], [1280.0, 720.0], [390.0, 844.0], [844.0, 390.0]] {
        let mut screen = ready_app(size);
        act(&mut screen, [LessonAction::Open, LessonAction::Add, LessonAction::Add]);
        let whole = screen.ctx.content_rect();
        let views = &screen.state().pictures.views;
        let pictures = views.source.rect.union(views.target.rect);
        assert!(pictures.height() >= 0.45 * whole.height(), "{size:?}: {pictures:?}");
        for button in ["Add step", "Play lesson", "Copy link", "Close the lesson; it is kept"] {
            let rect = screen.get_by_label(button).rect();
            assert!(whole.contains_rect(rect) && !pictures.intersects(rect), "{size:?}: {button} at {rect:?}");
        }
    }
}
