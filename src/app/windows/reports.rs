//! Windows with the paper's tables, and with its convergence figure and the accuracy of all methods, measured on this
//! machine row by row.
//!
//! Closing a window stops its measurements: no further row is requested, and the result in flight is dropped.

use crate::app::input::action::{Action, Actions, LadderShown, Report};
use crate::app::language::words::grouped;
use crate::app::plots::{convergence_chart, ladder_chart};
use crate::app::theme::Palette;
use crate::app::theme::widgets::close_button;
use crate::figures::{
    BenchRow, BenchSetting, ConvergenceRow, Detail, LadderRow, LadderShape, Measurement, PaperFrame, PaperPreparation,
    Rung, TABLE_1, TABLE_2,
};
use crate::language::{self, Label, Message, key, number, say, tr};
use crate::worker::{Finding, Study};
use egui::{Grid, Key, RichText, ScrollArea, Ui, Window, vec2};
use std::collections::VecDeque;

/// The most characters of a column's title in one line.
const SHORT_TITLE: usize = 8;

/// Measurements per row; the row shows their median.
const RUNS: usize = 3;

/// The height of a table's row, in points: also on touch screens, since nothing in it is touched.
const ROW_HEIGHT: f32 = 20.0;

/// Resolutions of Figure 15 in the app; the command line goes up to 4000.
const RESOLUTIONS: [u32; 4] = [250, 500, 1000, 2000];

/// The open report window, its queue of studies and its results.
#[derive(Debug, Default)]
pub struct Reports {
    open: Option<Report>,
    waiting: VecDeque<Study>,
    running: Option<Study>,
    /// Whether the study of a closed window is still in flight. The next one waits for it: two at once would slow each
    /// other down.
    is_abandoned: bool,
    rows: Vec<(BenchRow, Measurement)>,
    convergence: Vec<ConvergenceRow>,
    ladder: Vec<LadderRow>,
    shown: LadderShown,
    failures: Vec<Message>,
}

impl Reports {
    /// Whether the window is open.
    pub fn is_open(&self) -> bool {
        self.open.is_some()
    }

    /// How many rows are measured.
    pub fn measured(&self) -> usize {
        self.rows.len() + self.convergence.len() + self.ladder.len()
    }

    /// How many rows are under way or wait.
    pub fn left(&self) -> usize {
        self.waiting.len() + usize::from(self.running.is_some())
    }

    /// Opens a window and starts its measurements from the beginning.
    pub fn open(&mut self, report: Report) {
        let waiting = match report {
            Report::Bench => BenchRow::all().into_iter().map(|row| Study::Bench { row, runs: runs(row) }).collect(),
            Report::Convergence => {
                let figure = RESOLUTIONS.map(|m| Study::Convergence { m });
                figure.into_iter().chain(ladder(self.shown.shape)).collect()
            }
        };
        self.close();
        (self.open, self.waiting) = (Some(report), waiting);
    }

    /// Closes the window: what is under way is dropped when it comes.
    pub fn close(&mut self) {
        let is_abandoned = self.is_abandoned || self.running.is_some();
        *self = Self { is_abandoned, shown: self.shown, ..Self::default() };
    }

    /// Shows another outline or axis of the plot of accuracy; what is not measured yet comes first.
    pub fn show_ladder(&mut self, shown: LadderShown) {
        self.shown = shown;
        let is_waiting = |study: &Study| matches!(study, Study::Ladder { rung } if rung.shape == shown.shape);
        let (first, rest): (Vec<Study>, Vec<Study>) = self.waiting.drain(..).partition(is_waiting);
        let is_known = self.ladder.iter().any(|row| row.rung.shape == shown.shape)
            || self.running.as_ref().is_some_and(is_waiting);
        let missing = ladder(shown.shape).filter(|_| first.is_empty() && !is_known);
        self.waiting = missing.collect::<Vec<_>>().into_iter().chain(first).chain(rest).collect();
    }

    /// Takes the next study to run; `None` while one is in flight or when all are done.
    pub fn take_study(&mut self) -> Option<Study> {
        if self.running.is_some() || self.is_abandoned {
            return None;
        }
        self.running = self.waiting.pop_front();
        self.running.clone()
    }

    /// Stores the finding of a study. That of a stale study is dropped.
    pub fn accept(&mut self, study: &Study, finding: Finding) {
        if std::mem::take(&mut self.is_abandoned) {
            return;
        }
        let Some(running) = self.running.take_if(|running| study == running) else {
            return;
        };
        match (running, finding) {
            (Study::Bench { row, .. }, Finding::Bench(measurement)) => self.rows.push((row, measurement)),
            (Study::Convergence { .. }, Finding::Convergence(rows)) => self.convergence.extend(rows),
            (Study::Ladder { .. }, Finding::Ladder(row)) => self.ladder.push(*row),
            (_, Finding::Failed(reason)) => self.failures.push(reason),
            _ => self.failures.push(key::another_answer().into()),
        }
    }

    /// The messages in the open window about failed measurements.
    pub fn errors(&self) -> impl Iterator<Item = &Message> {
        self.failures.iter()
    }

    /// Shows the open window, if there is one.
    pub fn show(&self, context: &egui::Context, actions: &mut Actions) {
        let Some(report) = self.open else { return };
        let title = match report {
            Report::Bench => key::tables_of_paper(),
            Report::Convergence => key::accuracy_and_convergence(),
        };
        let screen = context.content_rect();
        let mut still_open = true;
        let given_up = context.input(|input| input.key_pressed(Key::Escape));
        Window::new(tr(title))
            .open(&mut still_open)
            .collapsible(false)
            .pivot(egui::Align2::CENTER_CENTER)
            .default_pos(screen.center())
            .default_size(vec2(780.0, 700.0).min(screen.size() - vec2(24.0, 90.0)))
            .show(context, |ui| self.content(ui, report, actions));
        if !still_open || given_up {
            actions.push(Action::CloseReport);
        }
    }

    fn content(&self, ui: &mut Ui, report: Report, actions: &mut Actions) {
        let palette = Palette::of(ui.visuals());
        let left = self.left();
        let state = if left == 0 { String::from(tr(key::done())) } else { say(&key::measuring_rows(left)) };
        ui.label(RichText::new(state).color(palette.weak));
        for failure in &self.failures {
            ui.label(RichText::new(say(failure)).color(palette.error_edge));
        }
        let below = 2.0 * ui.spacing().item_spacing.y + ui.spacing().interact_size.y;
        let height = ui.available_height() - below;
        ScrollArea::both().auto_shrink(false).max_height(height).show(ui, |ui| match report {
            Report::Bench => self.tables(ui),
            Report::Convergence => {
                heading(ui, key::convergence_of_paper());
                convergence_chart(ui, &self.convergence, &RESOLUTIONS);
                heading(ui, key::accuracy_of_methods());
                ladder_chart(ui, &self.ladder, self.shown, actions);
            }
        });
        if close_button(ui).clicked() {
            ui.close();
        }
    }

    fn tables(&self, ui: &mut Ui) {
        let weak = Palette::of(ui.visuals()).weak;
        ui.label(RichText::new(say(&key::paper_machine_and_here(key::paper_machine()))).color(weak));
        for setting in BenchSetting::ALL {
            self.table_1(ui, setting);
            self.table_2(ui, setting);
        }
    }

    fn table_1(&self, ui: &mut Ui, setting: BenchSetting) {
        table_heading(ui, key::table_1(), setting);
        grid(ui, format!("table 1 {setting:?}"), |ui| {
            header(
                ui,
                &[
                    "",
                    "m",
                    "N",
                    tr(key::stage_mesh()),
                    &of_paper(key::stage_mesh()),
                    tr(key::factor()),
                    tr(key::with_psi()),
                    &of_paper(key::with_psi()),
                    tr(key::zipper()),
                    &of_paper(key::zipper()),
                    tr(key::bff_paper()),
                ],
            );
            for (index, paper) in TABLE_1.iter().enumerate() {
                let asked = BenchRow::Preparation { index, setting };
                let Some(Measurement::Preparation(here)) = self.measurement(asked) else { continue };
                let psi = match self.measurement(BenchRow::PsiTable { index }) {
                    Some(Measurement::PsiTable { psi_s: Some(s) }) if setting == BenchSetting::Paper => seconds(s),
                    Some(Measurement::PsiTable { psi_s: None }) if setting == BenchSetting::Paper => {
                        tr(key::too_large()).into()
                    }
                    _ => "–".into(),
                };
                let PaperPreparation { triangulation_s, psi_s, zipper_s, bff_s, .. } = *paper;
                row(
                    ui,
                    tr(language::preset(paper.domain)),
                    &[
                        here.m.to_string(),
                        grouped(here.triangles),
                        seconds(here.triangulation_s),
                        seconds(triangulation_s),
                        seconds(here.factorisation_s),
                        psi,
                        seconds(psi_s),
                        seconds(here.zipper_s),
                        seconds(zipper_s),
                        seconds(bff_s),
                    ],
                );
            }
        });
    }

    fn table_2(&self, ui: &mut Ui, setting: BenchSetting) {
        table_heading(ui, key::table_2(), setting);
        grid(ui, format!("table 2 {setting:?}"), |ui| {
            header(
                ui,
                &[
                    "",
                    "m₁, m₂",
                    "N₁",
                    tr(key::psi_match_x1_moves()),
                    tr(key::x2_moves()),
                    &of_paper(key::psi_match_x1_moves()),
                    tr(key::extend()),
                    &of_paper(key::extend()),
                ],
            );
            for (index, paper) in TABLE_2.iter().enumerate() {
                let asked = BenchRow::Frame { index, setting };
                let Some(Measurement::Frame(here)) = self.measurement(asked) else { continue };
                let PaperFrame { source, target, matching_ms, extension_ms, .. } = *paper;
                row(
                    ui,
                    &format!("{} → {}", tr(language::preset(source)), tr(language::preset(target))),
                    &[
                        format!("{}, {}", here.m[0], here.m[1]),
                        grouped(here.triangles),
                        milliseconds(here.source.matching_ms),
                        milliseconds(here.target.matching_ms),
                        milliseconds(matching_ms),
                        milliseconds(here.source.extension_ms),
                        milliseconds(extension_ms),
                    ],
                );
            }
        });
    }

    fn measurement(&self, row: BenchRow) -> Option<Measurement> {
        self.rows.iter().find(|(measured, _)| *measured == row).map(|(_, measurement)| *measurement)
    }
}

/// The measurements of an outline for the plot of accuracy.
fn ladder(shape: LadderShape) -> impl Iterator<Item = Study> {
    Rung::of(shape, Detail::Quick).into_iter().map(|rung| Study::Ladder { rung })
}

/// Measurements of a row: one for the tables of Ψ, which take seconds each and which riemap does not need.
fn runs(row: BenchRow) -> usize {
    if matches!(row, BenchRow::PsiTable { .. }) { 1 } else { RUNS }
}

fn heading(ui: &mut Ui, text: Label) {
    ui.add_space(8.0);
    ui.label(RichText::new(tr(text)).strong());
}

fn table_heading(ui: &mut Ui, table: Label, setting: BenchSetting) {
    heading(ui, table);
    let of = match setting {
        BenchSetting::Paper => key::setting_paper(),
        BenchSetting::Default => key::setting_default(),
    };
    ui.label(RichText::new(tr(of)).small().color(Palette::of(ui.visuals()).weak));
}

fn grid(ui: &mut Ui, id: String, content: impl FnOnce(&mut Ui)) {
    Grid::new(id).striped(true).min_row_height(ROW_HEIGHT).spacing([14.0, 3.0]).show(ui, content);
}

/// The title of the paper's column beside the one of this name.
fn of_paper(column: Label) -> String {
    say(&key::of_paper(tr(column)))
}

/// The titles of columns; long ones take two lines, so that all columns fit into the window.
fn header(ui: &mut Ui, titles: &[&str]) {
    for title in titles {
        let long = title.chars().count() > SHORT_TITLE;
        let lines = if long { title.replacen(", ", ",\n", 1).replacen(" (", "\n(", 1) } else { String::from(*title) };
        ui.label(RichText::new(lines).small().color(Palette::of(ui.visuals()).weak));
    }
    ui.end_row();
}

fn row(ui: &mut Ui, name: &str, cells: &[String]) {
    ui.label(name);
    for cell in cells {
        ui.label(RichText::new(cell).monospace());
    }
    ui.end_row();
}

fn seconds(s: f64) -> String {
    if s < 0.1 { number(s, 4) } else { number(s, 2) }
}

fn milliseconds(ms: f64) -> String {
    number(ms, 2)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn rows_come_one_after_the_other_and_stale_ones_are_dropped() {
        let mut reports = Reports::default();
        reports.open(Report::Convergence);
        let first = reports.take_study().unwrap();
        assert!(matches!(first, Study::Convergence { .. }), "Figure 15 before the accuracy: {first:?}");
        assert!(reports.take_study().is_none(), "one at a time");
        reports.open(Report::Bench);
        assert!(reports.take_study().is_none(), "the closed window's study is still in flight");
        reports.accept(&first, Finding::Convergence(Vec::new()));
        assert!(reports.convergence.is_empty(), "the finding of the closed window is dropped");
        let second = reports.take_study().unwrap();
        reports.accept(&second, Finding::Failed("no".into()));
        assert_eq!(reports.failures.len(), 1);
        let third = reports.take_study().unwrap();
        reports.accept(&first, Finding::Failed("stale".into()));
        reports.accept(&third, Finding::Failed("the worker died".into()));
        assert_eq!(reports.failures.len(), 2);
    }
}
