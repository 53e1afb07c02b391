//! What a screen reader is told: the state of the picture, and the control that has the keyboard.
//!
//! egui draws on a canvas, which a screen reader cannot look into: in the browser these sentences stand beside
//! it in the page. On the desktop the system's accessibility interface reads the widgets themselves.

use super::RiemapApp;
use super::language::{number, tr, tr_count, tr_message, tr_with};
use super::model::Model;
use super::words;
use crate::conformal::Side;
use crate::geometry::DVec2;
use egui::{Role, WidgetInfo};

/// The picture in a few sentences.
pub fn state(app: &RiemapApp) -> String {
    let model = &app.model;
    let mut sentences = vec![shown(model)];
    sentences.extend(Side::BOTH.into_iter().filter_map(|side| points(model, side)));
    if let Some(quality) = model.quality() {
        let mean = number(quality.q_mean, 3);
        let forms =
            ["Mean angle distortion {0}; {1} triangle flipped.", "Mean angle distortion {0}; {1} triangles flipped."];
        sentences.push(tr_count(quality.flipped as usize, forms, &[&mean, &quality.flipped]));
    }
    if !model.is_ready() {
        sentences.push(tr("Being prepared.").into());
    }
    sentences.extend(app.explore.words().into_iter().flatten().map(String::from));
    sentences.extend(app.notice.map(|(notice, _)| String::from(tr(notice))));
    sentences.extend(app.errors().iter().map(|error| tr_with("Problem: {0}", &[&tr_message(error)])));
    sentences.join(" ")
}

fn shown(model: &Model) -> String {
    let source = words::outline(&model.session().source.outline);
    if let Some((_, surface)) = model.surface() {
        let surface = words::surface(&surface.spec.shape);
        return tr_with("The surface {0}, mapped conformally to the outline {1}.", &[&surface, &source]);
    }
    let target = words::outline(&model.session().target.outline);
    tr_with("Conformal map from {0} to {1}.", &[&source, &target])
}

fn points(model: &Model, side: Side) -> Option<String> {
    let [x, y] = match side {
        Side::Source => ["x₁", "y₁"],
        Side::Target => ["x₂", "y₂"],
    };
    let surface = model.surface().filter(|_| side == Side::Target);
    let (place, fraction) = match surface {
        Some((_, state)) => (model.surface_point()?.to_array().to_vec(), state.anchor),
        None => (DVec2::to_array(&model.interior(side)?).to_vec(), model.session().anchor[side as usize]),
    };
    let place = place.iter().map(|coordinate| number(*coordinate, 3)).collect::<Vec<_>>().join("; ");
    let along = number(100.0 * fraction, 1);
    Some(tr_with("{0} at ({1}), {2} at {3} % of the boundary.", &[&x, &place, &y, &along]))
}

/// A control, as it is read out when it gets the keyboard or changes.
pub fn control(info: &WidgetInfo) -> String {
    let label = info.label.clone().unwrap_or_default();
    let role = match info.role {
        Role::Button => tr("button"),
        Role::RadioButton => tr("choice"),
        Role::CheckBox => tr("check box"),
        Role::Slider => tr("slider"),
        Role::TextInput | Role::MultilineTextInput => tr("text field"),
        _ => "",
    };
    let selected = match info.selected {
        Some(true) => tr("selected"),
        Some(false) => tr("not selected"),
        None => "",
    };
    let refused = if info.enabled { "" } else { tr("not available") };
    let value = info.value.map(|value| number((1e4 * value).round() / 1e4, 4)).unwrap_or_default();
    let text = info.current_text_value.as_deref().unwrap_or_default();
    let parts = [label.as_str(), text, role, selected, value.as_str(), refused];
    parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::reports::Report;
    use crate::app::tests::ready_app;
    use crate::app::{Action, EditAction};
    use crate::worker::Finding;

    #[test]
    fn what_is_wrong_in_a_window_is_said_and_counted_among_the_errors() {
        let mut harness = ready_app([1200.0, 800.0]);
        let context = harness.ctx.clone();
        let app = harness.state_mut();
        assert_eq!(app.stats().errors, [""; 0]);
        app.carry_out(&context, vec![Action::PasteText(String::from("0,0 1,x")), Action::OpenExport]);
        app.exporter.tell(Some(String::from("there is no map of this session")));
        app.reports.open(Report::Convergence);
        assert!(app.reports.take_study().is_some());
        app.reports.accept(None, Finding::Failed(String::from("there is no such row")));
        let errors = app.stats().errors;
        assert_eq!(errors.len(), 3, "{errors:?}");
        assert!(errors[0].contains('x'), "{errors:?}");
        for error in errors {
            assert!(state(app).contains(&format!("Problem: {error}")), "{}", state(app));
        }
        app.carry_out(&context, vec![Action::Edit(EditAction::ClosePaste)]);
        assert_eq!(app.stats().errors.len(), 2);
    }

    #[test]
    fn a_control_is_read_with_its_kind_and_its_state() {
        assert_eq!(control(&WidgetInfo::labeled(Role::Button, true, "Open…")), "Open…, button");
        assert_eq!(control(&WidgetInfo::selected(Role::RadioButton, true, true, "Grid")), "Grid, choice, selected");
        assert_eq!(control(&WidgetInfo::slider(true, 0.123_456, "Growth")), "Growth, slider, 0.1235");
        assert_eq!(control(&WidgetInfo::labeled(Role::Button, false, "Fit")), "Fit, button, not available");
    }
}
