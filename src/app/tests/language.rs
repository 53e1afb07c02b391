//! The whole screen in German: no text is left in English.

use crate::app::input::action::EditAction;
use crate::app::input::action::ExploreAction;
use crate::app::input::locks::Locks;
use crate::app::input::preferences::{Habit, Preferences};
use crate::app::tests::ready_app;
use crate::app::*;
use crate::conformal::{Extension, Side};
use crate::geometry::DVec2;
use crate::language::{self, Language, key};
use crate::model::editing::Hold;
use crate::model::files::FilePurpose;
use crate::session::{Colouring, Command, Comparison, SurfaceShape, SurfaceSpec, TextureKind};
use crate::surface::SurfacePreset;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use std::collections::BTreeSet;

/// The labels on the screen that are the English text of a key and not also the German text of one.
fn left_in_english(harness: &Harness<'_, RiemapApp>) -> Vec<String> {
    let words = |language: Language| key::all_labels().map(|label| language.label(label)).collect::<BTreeSet<_>>();
    let (english, german) = (words(Language::English), words(Language::German));
    let labels = harness.root().children_recursive().filter_map(|node| {
        let node = node.accesskit_node();
        node.label().or_else(|| node.value())
    });
    labels.filter(|label| english.contains(label.as_str()) && !german.contains(label.as_str())).collect()
}

fn check(harness: &mut Harness<'_, RiemapApp>, shown: &str) {
    harness.run_steps(3);
    assert_eq!(left_in_english(harness), Vec::<String>::new(), "{shown}");
}

/// Opens a session and waits for its map.
fn open(harness: &mut Harness<'_, RiemapApp>, session: Session) {
    harness.state_mut().open_session(session);
    for _ in 0..600 {
        harness.step();
        if harness.state().stats().preparation.ready {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    assert!(harness.state().stats().preparation.ready);
}

#[test]
fn the_whole_screen_speaks_german() {
    language::set(Language::German);
    let mut harness = ready_app([1500.0, 1000.0]);
    let preferences = Preferences { language: Some(Language::German), ..Preferences::fixed() };
    harness.state_mut().screen.preferences = preferences;
    language::set(Language::German);
    check(&mut harness, "the first picture");
    harness.state_mut().recall(Habit::Advanced(true));
    check(&mut harness, "the advanced controls");
    for menu in ["Datei", "Formen", "Figuren", "Hilfe"] {
        harness.get_all_by_label(menu).next().unwrap().click();
        check(&mut harness, menu);
        harness.key_press(egui::Key::Escape);
        harness.run_steps(3);
    }
    for action in [ExploreAction::Gallery, ExploreAction::Figures, ExploreAction::Shortcuts] {
        harness.state_mut().explore(action);
        check(&mut harness, &format!("{action:?}"));
        harness.key_press(egui::Key::Escape);
    }
    for step in 0..6 {
        harness.state_mut().explore(ExploreAction::Tour(step));
        check(&mut harness, &format!("step {step} of the tour"));
    }
    harness.state_mut().explore(ExploreAction::LeaveTour { keeps: false });
    let standard = Session::with([Command::SetPlots(true)]);
    let others = [
        [Command::SetColouring(Colouring::Area), Command::SetTexture(TextureKind::Polar)],
        [Command::SetColouring(Colouring::Angle), Command::SetTexture(TextureKind::Conformal)],
        [Command::SetComparison(Comparison::Both), Command::SetExtension(Extension::CauchyGreen)],
    ];
    for session in others.map(|commands| standard.clone().and(commands)) {
        let shown = format!("{:?}, {:?}", session.colouring(), session.texture());
        open(&mut harness, session);
        check(&mut harness, &shown);
    }
    let mut solid = standard;
    let shape = SurfaceShape::Preset { preset: SurfacePreset::Saddle, boundary: 60 };
    solid.apply(Command::SetSurface { side: Side::Target, surface: SurfaceSpec { shape, ..SurfaceSpec::default() } });
    open(&mut harness, solid);
    assert!(harness.state().model.surface(Side::Target).is_some());
    check(&mut harness, "a surface");
}

/// Drags a handle of the source's outline far across the outline, and releases it.
fn cross(app: &mut RiemapApp) {
    let across = DVec2::splat(-40.0);
    for action in [
        EditAction::Toggle(Side::Source),
        EditAction::Grab(0, Hold::Pointer),
        EditAction::Drag(across),
        EditAction::Release,
    ] {
        app.editor.act(action, &mut app.model, &mut app.pictures.views);
    }
}

#[test]
fn messages_on_the_screen_follow_a_change_of_language() {
    let mut harness = ready_app([1500.0, 1000.0]);
    language::set(Language::German);
    let app = harness.state_mut();
    app.options.locks = Locks::default().with(Control::Outline);
    app.take_file(FilePurpose::Outline(Side::Source), "square.csv", Ok(b"0,0\n1,0\n1,1\n0,1\n".to_vec()));
    cross(app);
    let said = [
        (
            Language::German,
            ["Die Adresse der Seite hält „outline“ fest.", "Der Umriss kreuzte sich dort: der letzte gute blieb."],
        ),
        (
            Language::English,
            [
                "The page's address keeps \"outline\" as it is.",
                "The outline crossed itself there: the last good one was kept.",
            ],
        ),
    ];
    for (language, sentences) in said {
        language::set(language);
        harness.run_steps(2);
        for sentence in sentences {
            harness.get_by_label(sentence);
        }
    }
}
