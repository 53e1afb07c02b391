//! Files and links are read back as written; damaged and hostile ones are refused, with the line or the step.

use super::*;
use crate::outline::Preset;
use crate::session::link::LinkError;
use crate::session::{Command, OutlineSpec, SurfaceSpec, TextureKind, scaled};
use crate::surface::SurfacePreset;

fn address(fragment: &str) -> String {
    format!("https://example.org/riemap/#{fragment}")
}

fn step(scale: f64, caption: &str) -> Step {
    Step::of(&scaled(scale), caption.into()).unwrap().0
}

fn lesson() -> Lesson {
    let surface = SurfaceSpec { shape: SurfaceShape::preset(SurfacePreset::AnimalHead), ..SurfaceSpec::default() };
    let solid = Session::with([Command::SetSurface { side: Side::Target, surface }]);
    let steps = vec![
        step(5.0, "Drag the green dot.\n\nThe squares stay squares: f′ turns and scales."),
        step(9.0, ""),
        Step::of(&solid, "Größe".into()).unwrap().0,
    ];
    Lesson { title: "Winkel bleiben \"gleich\"".into(), steps }
}

/// The lines of the lesson's file with one of them replaced, read.
fn with_line(at: usize, line: &str) -> Result<Lesson, LessonError> {
    let text = write(&lesson(), address).unwrap();
    let lines = text.lines().enumerate().map(|(k, old)| if k + 1 == at { line } else { old });
    read(lines.collect::<Vec<_>>().join("\n").as_bytes())
}

#[test]
fn files_and_links_are_read_back_as_written() {
    let text = write(&lesson(), address).unwrap();
    assert!(text.starts_with("riemap lesson 1\nTitle: Winkel bleiben \"gleich\"\n\nhttps://example.org/riemap/#s="));
    assert_eq!(read(text.as_bytes()), Ok(lesson()), "{text}");
    let fragment = encode(&lesson()).unwrap();
    for link in [fragment.clone(), format!("#{fragment}"), address(&format!("x=1&{fragment}"))] {
        assert!(is_link(&link) && !crate::session::link::is_link(&link));
        assert_eq!(decode(&link), Ok(lesson()));
    }
}

#[test]
fn a_file_written_by_hand_is_read_whatever_its_line_ends() {
    let [first, second] = [5.0, 9.0].map(|scale| address(&link::encode(&scaled(scale)).unwrap().fragment));
    let text = format!(
        "\u{feff}\r\nRiemap Lesson  1 \r\ntitle : My class \r\nLevel: 3 (of a later version)\r\n\r\n {first} \r\n\
         one  \r\n\r\n two\r\n\r\n\r\n{second}"
    );
    assert!(is_file(text.as_bytes()));
    let read = read(text.as_bytes()).unwrap();
    assert_eq!((read.title.as_str(), read.steps.len()), ("My class", 2));
    assert_eq!(read.steps[0], step(5.0, "one\n\ntwo"));
    assert_eq!(read.steps[1], step(9.0, ""));
}

#[test]
fn a_line_of_a_caption_that_would_begin_a_step_has_brackets() {
    let link = address(&link::encode(&scaled(9.0)).unwrap().fragment);
    let lesson = Lesson { title: " two\nlines\t".into(), steps: vec![step(5.0, &format!("\n see \n{link}\n\n"))] };
    let tidied = lesson.tidied();
    assert_eq!(tidied.title, "two lines");
    assert_eq!(tidied.steps[0].caption, format!("see\n<{link}>"));
    assert_eq!(read(write(&lesson, address).unwrap().as_bytes()), Ok(tidied.clone()));
    assert_eq!(decode(&encode(&lesson).unwrap()), Ok(tidied));
}

#[test]
fn steps_that_show_the_same_outline_share_its_space() {
    let outline = |k: usize| {
        let angle = |k: usize| std::f64::consts::TAU * k as f64 / 300.0;
        let point = |k: usize| (2.0 + (17.3 * angle(k)).sin()) * crate::geometry::DVec2::from_angle(angle(k));
        let polygon = (0..300).map(point).collect::<Vec<_>>().try_into().unwrap();
        Session::with([
            Command::SetOutline { side: Side::Source, outline: OutlineSpec::points("wave".into(), polygon) },
            Command::SetTextureScale(2.0 + k as f64),
        ])
    };
    let one = link::encode(&outline(0)).unwrap().fragment.len();
    let steps = (0..20).map(|k| Step::of(&outline(k), format!("caption {k}")).unwrap().0).collect();
    let all = encode(&Lesson { title: String::new(), steps }).unwrap().len();
    assert!(one > 500 && all < 4 * one, "one link has {one} characters, 20 steps have {all}");
}

#[test]
fn what_no_link_holds_cannot_be_a_step() {
    let shape = SurfaceShape::File { name: "cow.obj".into() };
    let surface = SurfaceSpec { shape, ..SurfaceSpec::default() };
    let solid = Session::with([Command::SetSurface { side: Side::Source, surface }]);
    let refused = |session: &Session| Step::of(session, String::new()).unwrap_err();
    assert_eq!(refused(&solid), StepError::SurfaceFile { name: "cow.obj".into() });
    assert_eq!(refused(&Session::with([Command::SetTexture(TextureKind::Image)])), StepError::OwnPicture);
    let tiled = Session::with([Command::SetTexture(TextureKind::Tiling)]);
    let pictured = tiled.clone().and([tiled.to_show_picture()]);
    assert_eq!(refused(&pictured), StepError::OwnPicture);
    let spike = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.31 + 1e-9, 1.0), (0.31, 0.2), (0.31 - 1e-9, 1.0), (0.0, 1.0)];
    let polygon = spike.map(crate::geometry::DVec2::from).to_vec().try_into().unwrap();
    let outline = OutlineSpec::points("spike".into(), polygon);
    let fine = Session::with([Command::SetOutline { side: Side::Source, outline }]);
    assert!(matches!(refused(&fine), StepError::LeftOut(outline) if outline.name == "spike"));
    // the same by their links
    let link = address(&link::encode(&fine).unwrap().fragment);
    let expected = StepError::MissingOutline { side: Side::Source, name: "spike".into() };
    assert_eq!(with_line(4, &link), Err(LessonError::Step { step: 1, line: Some(4), error: expected }));
}

#[test]
fn errors_name_the_line_and_the_step() {
    let number = |line: &str| write(&lesson(), address).unwrap().lines().position(|text| text == line).unwrap() + 1;
    let second = number(&address(lesson().steps[1].link()));
    let damaged = StepError::Link(LinkError::Damaged);
    let expected = LessonError::Step { step: 2, line: Some(second), error: damaged };
    assert_eq!(with_line(second, "https://example.org/#s=1.eJw"), Err(expected.clone()));
    assert!(expected.to_string().starts_with(&format!("step 2 (line {second}): the link is damaged")), "{expected}");
    let newer = with_line(second, "#s=9.eJw");
    assert!(matches!(newer, Err(LessonError::Step { step: 2, error: StepError::Link(LinkError::Version { .. }), .. })));
    assert_eq!(with_line(3, "https://example.org/"), Err(LessonError::Line { line: 3 }));
    assert_eq!(with_line(3, "what is this"), Err(LessonError::Line { line: 3 }));
    assert_eq!(with_line(1, "riemap lesson 2"), Err(LessonError::Version { found: "2".into() }));
    assert_eq!(with_line(1, "riemap"), Err(LessonError::NoLesson));
    assert_eq!(read(b""), Err(LessonError::NoLesson));
    assert_eq!(read(b"riemap lesson 1\nTitle: x\n"), Err(LessonError::NoSteps));
    assert!(read_draft(b"riemap lesson 1\nTitle: x\n").is_ok_and(|lesson| lesson.title == "x"));
    assert_eq!(read(b"riemap lesson 1\n\xff"), Err(LessonError::NotText));
    assert_eq!(read(&vec![b' '; MAX_BYTES + 1]), Err(LessonError::TooLarge));
}

#[test]
fn too_much_is_refused_when_written_and_when_read() {
    let many = Lesson { title: String::new(), steps: vec![step(5.0, ""); MAX_STEPS + 1] };
    assert_eq!(write(&many, address), Err(LessonError::TooManySteps));
    assert_eq!(encode(&many), Err(LessonError::TooManySteps));
    let long = LessonError::of_step(0, StepError::LongCaption { length: MAX_CAPTION + 1 });
    let mut talking = Lesson { title: String::new(), steps: vec![step(5.0, "")] };
    talking.steps[0].caption = "ä".repeat(MAX_CAPTION + 1);
    assert_eq!((write(&talking, address), encode(&talking)), (Err(long.clone()), Err(long)));
    let titled = Lesson { title: "x".repeat(MAX_TITLE + 1), steps: vec![step(5.0, "")] };
    assert_eq!(encode(&titled), Err(LessonError::LongTitle { length: MAX_TITLE + 1 }));
    let text = write(&lesson(), address).unwrap().replacen("Größe", &"ä".repeat(MAX_CAPTION + 1), 1);
    assert!(matches!(read(text.as_bytes()), Err(LessonError::Step { step: 3, line: Some(_), .. })));
    let text = write(&lesson(), address).unwrap().replacen("Winkel", &"x".repeat(MAX_TITLE), 1);
    assert!(matches!(read(text.as_bytes()), Err(LessonError::LongTitle { .. })));
    // words that do not deflate
    let noise = |k: usize| {
        (0..MAX_CAPTION).map(|i| char::from(33 + (((i * i + k * 7919) * 2_654_435) >> 7) as u8 % 90)).collect()
    };
    let steps = (0..20).map(|k| Step { caption: noise(k), ..step(5.0, "") }).collect();
    assert_eq!(encode(&Lesson { title: String::new(), steps }), Err(LessonError::TooLongForLink));
    assert_eq!(encode(&Lesson::default()), Err(LessonError::NoSteps));
}

#[test]
fn damaged_links_are_refused_and_a_wrong_step_is_named() {
    let fragment = encode(&lesson()).unwrap();
    for end in 0..fragment.len() {
        assert!(decode(&fragment[..end]).is_err(), "cut at {end}");
    }
    assert_eq!(decode(&fragment.replace("=1.", "=2.")), Err(LessonError::Version { found: "2".into() }));
    assert_eq!(decode("#lesson=x"), Err(LessonError::Link(LinkError::Damaged)));
    assert_eq!(decode("#s=1.eJw"), Err(LessonError::NoLesson));
    let long = format!("lesson=1.{}", "A".repeat(link::MAX_LENGTH));
    assert!(matches!(decode(&long), Err(LessonError::Link(LinkError::TooLong { .. }))));
    // the second step is of a version that does not exist; postcard writes a list as its length and its items
    let fine = link::State::of(lesson().steps[0].link()).unwrap();
    let steps = postcard::to_allocvec(&("", 2_u32, (fine, "fine"), ("9", [0_u8; 0].as_slice(), "wrong"))).unwrap();
    let hostile = format!("lesson=1.{}", link::pack(&steps).unwrap());
    let error = decode(&hostile).unwrap_err();
    assert!(
        matches!(error, LessonError::Step { step: 2, error: StepError::Link(LinkError::Version { .. }), .. }),
        "{error}"
    );
}

#[test]
fn a_built_in_outline_stays_the_one_that_it_is() {
    let session =
        Session::with([Command::SetOutline { side: Side::Target, outline: OutlineSpec::Preset(Preset::Star) }]);
    let (step, shortened) = Step::of(&session, String::new()).unwrap();
    assert_eq!((step.session(), shortened.len()), (&session, 0));
}
