//! Locked controls in the whole app: no user input changes them.

use crate::app::input::action::EditAction;
use crate::app::input::locks::{Control, Locks, guarded};
use crate::app::panels::offer::Offer;
use crate::app::tests::{ready_app, step_until};
use crate::app::*;
use crate::conformal::Side;
use crate::model::files::FilePurpose;
use crate::session::{Command, TextureKind};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};

#[test]
fn a_locked_control_is_grey_and_does_nothing() {
    for locks in [Locks::default(), Locks::default().with(Control::Pattern)] {
        let mut clicks = 0;
        let setup = move |context: &egui::Context| {
            theme::install(context);
            locks.install(context);
        };
        let mut harness = Harness::builder().with_context_setup(setup).build_ui(|ui| {
            clicks += usize::from(guarded(ui, Control::Pattern, |ui| ui.button("Grid")).clicked());
        });
        let is_locked = locks.holds(Control::Pattern);
        assert_eq!(harness.get_by_label("Grid").accesskit_node().is_disabled(), is_locked);
        harness.get_by_label("Grid").click();
        harness.run();
        drop(harness);
        assert_eq!(clicks, usize::from(!is_locked));
    }
}

#[test]
fn a_locked_action_is_refused_and_the_others_are_carried_out() {
    let mut harness = ready_app([1200.0, 800.0]);
    let context = harness.ctx.clone();
    Locks::default().with(Control::Pattern).install(&context);
    let app = harness.state_mut();
    let before = app.session().clone();
    let actions = vec![
        Action::Session(Command::SetTexture(TextureKind::Grid)),
        Action::New,
        Action::Session(Command::MoveAnchor { side: Side::Source, fraction: 0.25 }),
    ];
    app.carry_out(&context, actions);
    assert_eq!(app.session().texture(), before.texture());
    assert_eq!(app.session().side(Side::Source).anchor(), 0.25, "actions that are not locked are carried out");
}

#[test]
fn undo_does_not_restore_a_session_that_the_page_has_replaced_despite_a_lock() {
    for (control, steps) in [(Control::Outline, 0), (Control::View, 1)] {
        let mut harness = ready_app([1200.0, 800.0]);
        harness.run_steps(2);
        let app = harness.state_mut();
        app.options.locks = Locks::default().with(control);
        let mut session = app.session().clone();
        session.apply(Command::SetTextureScale(21.0));
        app.open_session(session);
        harness.run_steps(3);
        let stats = harness.state().stats();
        assert_eq!((harness.state().session().texture_scale(), stats.screen.undo), (21.0, steps), "{control:?}");
    }
}

#[test]
fn a_file_does_not_reset_locked_points() {
    let mut harness = ready_app([1200.0, 800.0]);
    let app = harness.state_mut();
    app.options.locks = Locks::default().with(Control::Interior);
    let before = app.session().clone();
    app.take_file(FilePurpose::Outline(Side::Source), "square.csv", Ok(b"0,0\n1,0\n1,1\n0,1\n".to_vec()));
    harness.run_steps(3);
    let stats = harness.state().stats();
    assert!(
        stats.preparation.ready && stats.screen.errors.iter().any(|error| error.contains("interior")),
        "{:?}",
        stats.screen.errors
    );
    assert_eq!(*harness.state().session(), before);
}

#[test]
fn an_outline_is_not_mirrored_where_that_would_move_locked_points() {
    for (locks, moves) in [(Locks::default(), true), (Locks::default().with(Control::Boundary), false)] {
        let mut harness = ready_app([1200.0, 800.0]);
        let context = harness.ctx.clone();
        locks.install(&context);
        harness.state_mut().carry_out(&context, vec![Action::Edit(EditAction::Toggle(Side::Source))]);
        harness.run_steps(2);
        let before = harness.state().session().clone();
        assert_eq!(harness.get_by_label("Mirror").accesskit_node().is_disabled(), !moves);
        harness.get_by_label("Mirror").click();
        harness.run_steps(3);
        assert_eq!(
            harness.state().model.side(Side::Source).wanted().outline != before.domain(Side::Source).outline,
            moves
        );
    }
}

#[test]
fn a_file_that_could_be_repaired_is_not_offered_where_shapes_are_locked() {
    let spike = b"0,0\n2,0\n2,1\n3,1\n2,1\n2,2\n0,2\n";
    for locked in [false, true] {
        let mut harness = ready_app([1200.0, 800.0]);
        let app = harness.state_mut();
        app.options.locks = if locked { Locks::default().with(Control::Outline) } else { Locks::default() };
        app.take_file(FilePurpose::Outline(Side::Source), "spike.csv", Ok(spike.to_vec()));
        step_until(&mut harness, |app| !app.model.is_preparing(Side::Source));
        let app = harness.state();
        let has_quick_fix = app.model.user_errors(Side::Source).any(|user_error| user_error.quick_fix.is_some());
        assert_eq!(has_quick_fix, !locked);
        assert_eq!(app.messages.common.is_some(), locked);
    }
}

#[test]
fn a_locked_panel_stays_folded() {
    let mut harness = ready_app([1200.0, 800.0]);
    let context = harness.ctx.clone();
    let app = harness.state_mut();
    app.carry_out(&context, vec![Action::TogglePanels]);
    assert!(!app.screen.panels_open);
    Locks::default().with(Control::Panels).install(&context);
    app.carry_out(&context, vec![Action::TogglePanels]);
    assert!(!app.screen.panels_open);
}

#[test]
fn locked_keys_and_pastes_are_refused_with_a_reason_and_locked_buttons_are_gray() {
    let mut harness = ready_app([1200.0, 800.0]);
    let context = harness.ctx.clone();
    Locks::default().with(Control::Boundary).install(&context);
    let pixels = image::RgbaImage::from_pixel(20, 20, image::Rgba([9, 9, 9, 255]));
    let app = harness.state_mut();
    app.messages.offer = Some(Offer::new(Side::Source, &crate::model::files::Picture { name: "a.png".into(), pixels }));
    app.carry_out(&context, vec![Action::PasteText(String::from("M 0 0 L 4 0 L 1 3 Z"))]);
    assert!(app.messages.common.take().is_some_and(|message| message.english().contains("\"boundary\"")));
    harness.key_press(egui::Key::D);
    harness.run_steps(3);
    assert!(harness.state().editor.side().is_none() && harness.state().messages.common.is_some());
    for label in ["Swap", "Trace it as outline"] {
        assert!(harness.get_by_label(label).accesskit_node().is_disabled(), "{label}");
    }
}

#[test]
fn the_hint_is_under_a_dot_that_can_be_dragged() {
    let shapes_of = |locks: Locks| {
        let mut harness = ready_app([1200.0, 800.0]);
        locks.install(&harness.ctx);
        harness.run_steps(3);
        let hint = harness.output().shapes.iter().find_map(|clipped| match &clipped.shape {
            egui::Shape::Text(text) if text.galley.text() == "drag a dot" => Some(text.visual_bounding_rect().center()),
            _ => None,
        });
        let handles = harness.state().stats().screen.handles;
        (hint, [handles.x1, handles.y1].map(|place| egui::Pos2::from(place.unwrap())))
    };
    let interior = Locks::default().with(Control::Interior);
    for (locks, dot) in [(Locks::default(), Some(0)), (interior, Some(1)), (interior.with(Control::Boundary), None)] {
        let (hint, dots) = shapes_of(locks);
        assert_eq!(hint.is_some(), dot.is_some());
        if let (Some(hint), Some(dot)) = (hint, dot) {
            assert!(hint.distance(dots[dot]) < 40.0, "{hint} is not by {:?}", dots[dot]);
        }
    }
}
