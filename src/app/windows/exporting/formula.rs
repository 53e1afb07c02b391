//! The formula in the export window: its format and digits, the work of its worker, and what it reached.

use crate::app::theme::Palette;
use crate::app::theme::number_field::{number_field, spoken};
use crate::app::windows::exporting::Exporter;
use crate::conformal::PerSide;
use crate::export::FormulaFormat;
use crate::language::{Message, decimal, key, say, tr};
use crate::model::export::ReadyFile;
use crate::rational::Reached;
use crate::session::SideState;
use crate::worker::{Finding, FormulaTask};
use egui::{RichText, Ui};

/// The formula that is computed, or the one that was computed last.
#[derive(Debug, Default)]
pub(super) enum FormulaWork {
    /// Neither.
    #[default]
    None,
    /// The worker is at it.
    Running {
        asked: Box<Asked>,
        /// The share that is done.
        done: f64,
    },
    /// The file was made.
    Made {
        asked: Box<Asked>,
        file: ReadyFile,
        reached: PerSide<Reached>,
        /// Whether the map is still the one that was asked for.
        is_current: bool,
    },
}

/// A task with the outlines and points that it is for.
#[derive(Debug)]
pub(super) struct Asked {
    task: FormulaTask,
    sides: PerSide<SideState>,
}

impl Exporter {
    /// Waits for the findings about `task`, which is for these outlines and points.
    pub fn begin_formula(&mut self, task: FormulaTask, sides: PerSide<SideState>) {
        self.tell(None);
        self.formula = FormulaWork::Running { asked: Box::new(Asked { task, sides }), done: 0.0 };
    }

    /// Compares the formula that was made with the outlines and points that are shown.
    pub fn compare_formula(&mut self, sides: PerSide<&SideState>) {
        if let FormulaWork::Made { asked, is_current, .. } = &mut self.formula {
            *is_current = asked.sides.as_ref() == sides;
        }
    }

    /// The file that was made, if it is that of `task`: a dialog that was closed costs no second computation.
    pub fn made_formula(&self, task: &FormulaTask) -> Option<ReadyFile> {
        match &self.formula {
            FormulaWork::Made { asked, file, .. } if asked.task == *task => Some(file.clone()),
            _ => None,
        }
    }

    /// Takes a finding about `task`; returns the file once complete. Findings about another task than the one that is
    /// running are dropped.
    pub fn accept_formula(&mut self, task: &FormulaTask, finding: Finding) -> Option<ReadyFile> {
        let FormulaWork::Running { asked, done } = &mut self.formula else { return None };
        if asked.task != *task {
            return None;
        }
        if let Finding::Progress(share) = finding {
            *done = share;
            return None;
        }
        match (std::mem::take(&mut self.formula), finding) {
            (FormulaWork::Running { asked, .. }, Finding::Formula(found)) => {
                let name = format!("riemap_formula.{}", task.format().extension());
                let file = ReadyFile::new(name, found.text);
                let made = FormulaWork::Made { asked, file: file.clone(), reached: found.reached, is_current: true };
                self.formula = made;
                return Some(file);
            }
            (_, Finding::Failed(reason)) => self.tell(Some(reason)),
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
        let FormulaWork::Made { asked, file, reached, is_current } = &self.formula else { return Vec::new() };
        if self.places().is_none() {
            return Vec::new();
        }
        let digits = asked.task.digits();
        let mut all = vec![(Message::from(file.name.as_str()), false)];
        if !is_current {
            all.push((key::formula_of_earlier_map().into(), true));
        }
        notes(Message::from("f"), reached.source, digits, &mut all);
        notes(key::inverse_of_f().into(), reached.target, digits, &mut all);
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
        let field = number_field(&mut digits).range(self.request.formula.digits()).speed(0.05);
        let response = ui.add_sized([84.0, height], field).on_hover_text(tr(key::digits_tooltip()));
        let response = spoken(response, tr(key::digits()), f64::from(digits));
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
    let short = |error: f64| decimal(&format!("{error:.1e}"));
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
