//! The formula in the export window: its format and digits, the work of its worker, and what it reached.

use crate::app::theme::Palette;
use crate::app::windows::exporting::Exporter;
use crate::conformal::PerSide;
use crate::export::FormulaFormat;
use crate::language::{Message, key, say, tr};
use crate::model::export::ReadyFile;
use crate::rational::Reached;
use crate::worker::{Finding, FormulaTask};
use egui::{DragValue, RichText, Ui};

/// The formula that is computed, or the one that was computed last.
#[derive(Debug, Default)]
pub(super) enum FormulaWork {
    /// Neither.
    #[default]
    None,
    /// The worker is at it.
    Running {
        task: Box<FormulaTask>,
        /// The share that is done.
        done: f64,
    },
    /// The file was made.
    Made {
        name: String,
        /// The number of digits that were asked for.
        digits: u32,
        reached: PerSide<Reached>,
    },
}

impl Exporter {
    /// Waits for the findings about `task`.
    pub fn begin_formula(&mut self, task: FormulaTask) {
        self.tell(None);
        self.formula = FormulaWork::Running { task: Box::new(task), done: 0.0 };
    }

    /// Takes a finding about `task`; returns the file once complete. Findings about another task than the one that is
    /// running are dropped.
    pub fn accept_formula(&mut self, task: &FormulaTask, finding: Finding) -> Option<ReadyFile> {
        let FormulaWork::Running { task: running, done } = &mut self.formula else { return None };
        if **running != *task {
            return None;
        }
        if let Finding::Progress(share) = finding {
            *done = share;
            return None;
        }
        self.formula = FormulaWork::None;
        match finding {
            Finding::Formula(found) => {
                let name = format!("riemap_formula.{}", task.format().extension());
                let (digits, reached) = (task.digits(), found.reached);
                self.formula = FormulaWork::Made { name: name.clone(), digits, reached };
                return Some(ReadyFile { name, bytes: found.text.into_bytes() });
            }
            Finding::Failed(reason) => self.tell(Some(reason)),
            _ => self.tell(Some(key::another_answer().into())),
        }
        None
    }

    /// The share of the formula that is computed; `None` unless its worker is at it.
    pub fn formula_progress(&self) -> Option<f64> {
        if let FormulaWork::Running { done, .. } = self.formula { Some(done) } else { None }
    }

    /// What the formula that was computed last reached, with the warnings marked; nothing while the window is closed.
    pub fn formula_notes(&self) -> Vec<(Message, bool)> {
        let FormulaWork::Made { name, digits, reached } = &self.formula else { return Vec::new() };
        if self.places().is_none() {
            return Vec::new();
        }
        let mut all = vec![(Message::from(name.as_str()), false)];
        notes(Message::from("f"), reached.source, *digits, &mut all);
        notes(key::inverse_of_f().into(), reached.target, *digits, &mut all);
        all
    }

    /// Shows format and digits, as rows of a grid.
    pub(super) fn formula_settings(&mut self, ui: &mut Ui, height: f32) {
        ui.label(tr(key::format()));
        ui.vertical(|ui| {
            ui.horizontal_wrapped(|ui| {
                for format in FormulaFormat::ALL {
                    let is_chosen = self.request.formula == format;
                    if self.choice_named(ui, [format.title(); 2], is_chosen, height).clicked() {
                        self.request.formula = format;
                    }
                }
            });
        });
        ui.end_row();
        ui.label(tr(key::digits()));
        let mut digits = self.request.digits();
        let field = DragValue::new(&mut digits).range(self.request.formula.digits()).speed(0.05);
        let response = ui.add_sized([84.0, height], field).on_hover_text(tr(key::digits_tooltip()));
        self.note(key::digits().english(), &response);
        if response.changed() {
            self.request.digits = digits;
        }
        ui.end_row();
    }

    /// Shows what the last formula reached.
    pub(super) fn show_formula_notes(&self, ui: &mut Ui) {
        let palette = Palette::of(ui.visuals());
        for (note, is_warning) in self.formula_notes() {
            let ink = if is_warning { palette.error_edge } else { palette.weak };
            ui.label(RichText::new(say(&note)).small().color(ink));
        }
    }
}

/// Adds what one function reached, with warnings marked, as `riemap formula` says it.
fn notes(name: Message, reached: Reached, digits: u32, all: &mut Vec<(Message, bool)>) {
    if reached.digits == 0 {
        all.push((key::formula_left_out(name), true));
        return;
    }
    let short = |error: f64| format!("{error:.1e}");
    let found =
        key::formula_function(name.clone(), reached.degree, reached.poles, short(reached.error), reached.digits);
    all.push((found, false));
    if reached.digits < digits {
        all.push((key::formula_reaches(name.clone(), reached.digits, digits), true));
    }
    if !reached.is_boundary_exact {
        all.push((key::formula_boundary_values(name, short(reached.boundary_error)), true));
    }
}
