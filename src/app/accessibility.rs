//! The text for screen readers: the state of the picture, and the focused control.
//!
//! egui draws on a canvas, which a screen reader cannot read: in the browser these sentences are placed beside
//! it in the page. On the desktop the system's accessibility interface reads the widgets themselves.

use crate::app::RiemapApp;
use crate::app::input::handles::{Handle, HandleKind};
use crate::app::language::words;
use crate::app::panels::{best_panel, invariants_panel, pins_panel, quadrilateral_panel, symmetry_panel};
use crate::app::status::pointed;
use crate::app::viewport::probe;
use crate::conformal::{PerSide, Side};
use crate::language::{key, number, say, significant, tr};
use crate::model::Model;
use crate::model::best::{Landscapes, Marks};
use crate::model::shape::Shape;
use crate::session::{Colouring, TextureKind};
use crate::worker::Number;
use egui::{Role, WidgetInfo};

/// A boundary point is found again from its fraction of the length up to this distance, in extents of the outline.
const SAME_PLACE: f64 = 1e-9;

/// A description of the picture in a few sentences.
pub fn state(app: &RiemapApp) -> String {
    let model = &app.model;
    let mut sentences = vec![shown(model)];
    sentences.extend(tiling(model));
    sentences.extend(Side::BOTH.into_iter().filter_map(|side| points(model, side)));
    sentences.extend(pins(model));
    sentences.extend(Side::BOTH.into_iter().filter_map(|side| marks(model, side)));
    if let Some(quality) = model.quality() {
        let mean = quality.resolved_mean().map(|mean| number(mean, 3));
        let mean = mean.unwrap_or_else(|| String::from(tr(key::quality_unresolved())));
        sentences.push(say(&key::accessible_quality(mean, quality.flipped)));
        if quality.collapsed > 0 {
            sentences.push(say(&key::accessible_collapsed(number(100.0 * quality.collapsed_area, 2))));
        }
    }
    sentences.extend(Side::BOTH.into_iter().filter_map(|side| symmetries(model, side)));
    sentences.extend(caught(app));
    sentences.extend(Side::BOTH.into_iter().filter_map(|side| invariants(model, side)));
    sentences.extend(Side::BOTH.into_iter().filter_map(|side| quadrilateral_panel::sentence(model, side)));
    sentences.extend(best(model));
    sentences.extend(app.clicked().as_ref().map(pointed::sentence));
    if !model.is_ready() {
        sentences.push(tr(key::being_prepared()).into());
    }
    sentences.extend(app.pictures.probe.as_ref().map(|image| format!("{}.", probe::words(image))));
    sentences.extend(app.windows.explore.words().into_iter().flatten().map(String::from));
    sentences.extend(app.windows.projection.words());
    let formula = app.windows.exporter.formula_notes();
    sentences.extend(formula.into_iter().map(|(note, _)| say(&key::sentence(note))));
    sentences.extend(app.messages.notice.map(|notice| String::from(tr(notice.text))));
    sentences.extend(app.errors().iter().map(|error| say(&key::problem(error.clone()))));
    sentences.join(" ")
}

fn shown(model: &Model) -> String {
    let names = PerSide::from_fn(|side| words::shape(model.shape(side)));
    let (source, target) = (&*names.source, &*names.target);
    say(&match (model.shape(Side::Source), model.shape(Side::Target)) {
        (Shape::Surface(_), Shape::Surface(_)) => key::accessible_map_of_surfaces(source, target),
        (Shape::Surface(_), Shape::Outline(_)) => key::accessible_surface_map(source, target),
        (Shape::Outline(_), Shape::Surface(_)) => key::accessible_surface_map(target, source),
        (Shape::Outline(_), Shape::Outline(_)) => key::accessible_map(source, target),
    })
}

/// The hyperbolic tiling, where it is the pattern.
fn tiling(model: &Model) -> Option<String> {
    let session = model.session();
    let is_seen = session.texture() == TextureKind::Tiling && session.colouring() == Colouring::Texture;
    let tiling = session.tiling().tiling;
    is_seen.then(|| say(&key::accessible_tiling(u32::from(tiling.p()), u32::from(tiling.q()))))
}

fn points(model: &Model, side: Side) -> Option<String> {
    let [x, y] = match side {
        Side::Source => [key::x1(), key::y1()].map(tr),
        Side::Target => [tr(key::x2()), "y₂"],
    };
    let (place, fraction) = (model.coordinates(side)?, model.session().side(side).points().anchor());
    let place = place.iter().map(|coordinate| number(*coordinate, 3)).collect::<Vec<_>>().join("; ");
    let along = number(100.0 * fraction, 1);
    Some(say(&key::points_of_side(x, place, y, along)))
}

/// The pins and how far the map misses them.
fn pins(model: &Model) -> Option<String> {
    let misses = model.pin_misses();
    let pairs = model.pins()?.pairs().iter().enumerate().map(|(pin, pair)| {
        let [from, onto] = pair.into_array().map(|fraction| number(100.0 * fraction, 1));
        let miss = pins_panel::missed(misses.map(|misses| misses[pin]));
        say(&key::accessible_pin(pin + 1, from, onto, miss))
    });
    Some(pairs.collect::<Vec<_>>().join(" "))
}

/// The marks of a side.
fn marks(model: &Model, side: Side) -> Option<String> {
    let [a, b, c, d] = model.marks(side)?.map(|fraction| number(100.0 * fraction, 1));
    Some(say(&key::accessible_marks(side, a, b, c, d)))
}

/// The best map: its search, its result, and the landscape.
fn best(model: &Model) -> Option<String> {
    let best = model.best();
    let search = best.progress().map(|_| String::from(tr(key::best_sought())));
    let outcome = best.outcome().map(|outcome| say(&key::sentence(best_panel::said(outcome))));
    let lowest = best.landscape().and_then(Landscapes::marks).map(|Marks { lowest, least, .. }| {
        say(&key::accessible_landscape(number(lowest.x, 3), number(lowest.y, 3), significant(least, 3)))
    });
    let sentences: Vec<String> = search.into_iter().chain(outcome).chain(lowest).collect();
    (!sentences.is_empty()).then(|| sentences.join(" "))
}

/// The symmetries of a side that are shown.
fn symmetries(model: &Model, side: Side) -> Option<String> {
    let words = match model.symmetries(side)? {
        Ok(found) => symmetry_panel::lines(&found.symmetries).join("; "),
        Err(reason) => say(reason),
    };
    Some(format!("{}: {words}.", say(&key::symmetries_of(words::side_within(side)))))
}

/// What has caught the dot that was dragged last, while it is still there.
pub(super) fn caught(app: &RiemapApp) -> Option<String> {
    let (model, (handle, catch)) = (&app.model, app.input.handles.caught?);
    let Handle { side, kind } = handle;
    let samples = model.domain(side).filter(|_| model.surface(side).is_none())?.samples();
    let place = match kind {
        HandleKind::Interior => model.interior(side)?,
        HandleKind::Boundary => model.anchor(side)?,
        HandleKind::Pin(pin) => {
            samples.position(samples.at_fraction(model.pins()?.pairs().get(usize::from(pin))?[side]))
        }
        HandleKind::Mark(mark) => samples.position(samples.at_fraction(*model.marks(side)?.get(usize::from(mark))?)),
    };
    let (low, high) = model.extent(side)?;
    // a boundary point lies on the samples, next to what catches it
    let expected = match kind {
        HandleKind::Interior => catch.place,
        HandleKind::Boundary | HandleKind::Pin(_) | HandleKind::Mark(_) => {
            samples.position(samples.nearest(catch.place))
        }
    };
    let is_there = place.distance(expected) <= SAME_PLACE * (high - low).max_element();
    let words = catch.by.words(model.symmetries(side).and_then(|found| found.as_ref().ok())).filter(|_| is_there)?;
    Some(say(&key::caught_dot(handle.symbol().into_owned(), words)))
}

/// The invariants of a side that are shown.
fn invariants(model: &Model, side: Side) -> Option<String> {
    let heading = say(&key::invariants_of(words::side(side)));
    let numbers = match model.invariants(side)? {
        Ok(found) => {
            let row = |(name, number): (String, Number)| format!("{name}: {}", invariants_panel::shown(number));
            invariants_panel::rows(found).into_iter().map(row).collect::<Vec<_>>().join("; ")
        }
        Err(reason) => say(reason),
    };
    Some(format!("{heading}: {numbers}."))
}

/// The description of a control, for when it gets the focus or changes.
pub fn control(info: &WidgetInfo) -> String {
    let label = info.label.clone().unwrap_or_default();
    let role = match info.role {
        Role::Button => tr(key::button()),
        Role::RadioButton => tr(key::choice()),
        Role::CheckBox => tr(key::check_box()),
        Role::Slider => tr(key::slider()),
        Role::TextInput | Role::MultilineTextInput => tr(key::text_field()),
        _ => "",
    };
    let selected = match info.selected {
        Some(true) => tr(key::selected()),
        Some(false) => tr(key::not_selected()),
        None => "",
    };
    let refused = if info.enabled { "" } else { tr(key::not_available()) };
    let value = info.value.map(|value| number((1e4 * value).round() / 1e4, 4)).unwrap_or_default();
    let text = info.current_text_value.as_deref().unwrap_or_default();
    let parts = [label.as_str(), text, role, selected, value.as_str(), refused];
    parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::app::input::action::{Action, EditAction, ExportAction, Report};
    use crate::app::tests::{prepared_model, ready_app, step_until};
    use crate::session::Command;
    use crate::worker::Finding;

    #[test]
    fn what_is_wrong_in_a_window_is_said_and_counted_among_the_errors() {
        let mut harness = ready_app([1200.0, 800.0]);
        let context = harness.ctx.clone();
        let app = harness.state_mut();
        assert_eq!(app.stats().screen.errors, [""; 0]);
        app.carry_out(&context, vec![Action::PasteText(String::from("0,0 1,x"))]);
        step_until(&mut harness, |app| !app.errors().is_empty());
        let app = harness.state_mut();
        app.carry_out(&context, vec![Action::Export(ExportAction::Open)]);
        app.windows.exporter.tell(Some(key::no_map().into()));
        app.windows.reports.open(Report::Convergence);
        let study = app.windows.reports.take_study().unwrap();
        app.windows.reports.accept(&study, Finding::Failed(key::no_such_row().into()));
        let errors = app.stats().screen.errors;
        assert_eq!(errors.len(), 3, "{errors:?}");
        assert!(errors[0].contains('x'), "{errors:?}");
        for error in errors {
            assert!(state(app).contains(&format!("Problem: {error}")), "{}", state(app));
        }
        app.carry_out(&context, vec![Action::Edit(EditAction::ClosePaste)]);
        assert_eq!(app.stats().screen.errors.len(), 2);
    }

    #[test]
    fn a_tiling_is_said_while_it_is_seen() {
        let mut model = prepared_model();
        assert_eq!(tiling(&model), None);
        model.dispatch(Command::SetTexture(TextureKind::Tiling), 0.0);
        let words = tiling(&model).unwrap();
        assert!(words.contains("polygons with 7 sides, 3 around each corner"), "{words}");
        model.dispatch(Command::SetColouring(Colouring::Angle), 0.0);
        assert_eq!(tiling(&model), None, "colors hide it");
    }

    #[test]
    fn a_control_is_read_with_its_kind_and_its_state() {
        assert_eq!(control(&WidgetInfo::labeled(Role::Button, true, "Open…")), "Open…, button");
        assert_eq!(control(&WidgetInfo::selected(Role::RadioButton, true, true, "Grid")), "Grid, choice, selected");
        assert_eq!(control(&WidgetInfo::slider(true, 0.123_456, "Growth")), "Growth, slider, 0.1235");
        assert_eq!(control(&WidgetInfo::labeled(Role::Button, false, "Fit")), "Fit, button, not available");
    }
}
