//! Lessons on the screen: made in their panel, played on the card of the tour, and ended.

use crate::app::RiemapApp;
use crate::app::input::action::{Action, LessonAction};
use crate::app::tests::{ready_app, step_until};
use crate::conformal::Side;
use crate::model::files::FilePurpose;
use crate::session::lesson::{self, Lesson, Step};
use crate::session::{Command, SurfaceShape, SurfaceSpec, scaled};
use egui::Key;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

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
fn steps_are_added_moved_renewed_and_deleted_and_a_deletion_can_be_taken_back() {
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
    act(&mut screen, [LessonAction::Restore]);
    assert_eq!(captions(&screen), ["two", "one"]);
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
    act(&mut screen, [LessonAction::Restore]);
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
