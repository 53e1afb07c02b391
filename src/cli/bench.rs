//! `riemap bench`: measures Tables 1 and 2 of the paper and prints the times beside the paper's.

use super::CliError;
use super::arguments::BenchArguments;
use super::machine::Machine;
use super::output::print;
use super::progress::Progress;
use crate::figures::{
    BenchRow, BenchSetting, Frame, Measurement, PAPER_MACHINE, PaperFrame, PaperPreparation, Preparation, TABLE_1,
    TABLE_2,
};
use std::fmt::Write as _;

/// Runs per row; their median is reported. The paper does not state its number of runs.
const RUNS: usize = 5;

/// A measured row and the paper's.
#[derive(serde::Serialize)]
struct Measured<T, P> {
    setting: BenchSetting,
    #[serde(flatten)]
    here: T,
    paper: P,
}

/// A row of Table 1, and the time for the table of Ψ if it was measured.
#[derive(serde::Serialize)]
struct Prepared {
    #[serde(flatten)]
    row: Measured<Preparation, PaperPreparation>,
    psi_s: Option<f64>,
}

#[derive(serde::Serialize)]
struct Report {
    machine: Machine,
    paper_machine: &'static str,
    runs: usize,
    table_1: Vec<Prepared>,
    table_2: Vec<Measured<Frame, PaperFrame>>,
}

/// Measures all rows and prints them.
pub fn run(arguments: &BenchArguments) -> Result<(), CliError> {
    let runs = if arguments.quick { 1 } else { RUNS };
    let machine = Machine::this();
    let mut report = Report { machine, paper_machine: PAPER_MACHINE, runs, table_1: vec![], table_2: vec![] };
    let rows = BenchRow::all();
    let progress = Progress::new("measuring");
    for (k, &row) in rows.iter().enumerate() {
        progress.enter(format!("measuring, row {} of {}", k + 1, rows.len()));
        // the tables of Ψ take seconds each and riemap does not use them: one run is enough
        let runs = if matches!(row, BenchRow::PsiTable { .. }) { 1 } else { runs };
        if arguments.quick && matches!(row, BenchRow::PsiTable { .. }) {
            continue;
        }
        if let Some(measurement) = row.measure(runs)? {
            report.add(row, measurement);
        }
    }
    drop(progress);
    if arguments.json {
        let text = serde_json::to_string_pretty(&report).map_err(|error| CliError::Input(error.to_string()))?;
        return print(&text);
    }
    print(&report.say())
}

impl Report {
    fn add(&mut self, row: BenchRow, measurement: Measurement) {
        match (row, measurement) {
            (BenchRow::Preparation { index, setting }, Measurement::Preparation(here)) => {
                self.table_1.push(Prepared { row: Measured { setting, here, paper: TABLE_1[index] }, psi_s: None });
            }
            (BenchRow::PsiTable { index }, Measurement::PsiTable { psi_s }) => {
                let same = |r: &&mut Prepared| r.row.setting == BenchSetting::Paper && r.row.paper == TABLE_1[index];
                if let Some(prepared) = self.table_1.iter_mut().find(same) {
                    prepared.psi_s = psi_s;
                }
            }
            (BenchRow::Frame { index, setting }, Measurement::Frame(here)) => {
                self.table_2.push(Measured { setting, here, paper: TABLE_2[index] });
            }
            _ => (),
        }
    }

    fn say(&self) -> String {
        let mut text = format!("here:  {}\npaper: {PAPER_MACHINE}\n", self.machine.say());
        let _ = writeln!(text, "median of {} run(s); outlines but V-shape and blob are riemap's own", self.runs);
        for setting in BenchSetting::ALL {
            self.say_table_1(setting, &mut text);
        }
        for setting in BenchSetting::ALL {
            self.say_table_2(setting, &mut text);
        }
        text.trim_end().to_owned()
    }

    fn say_table_1(&self, setting: BenchSetting, text: &mut String) {
        let _ = writeln!(text, "\nTable 1, preparation in seconds, {}", title(setting));
        let _ = writeln!(
            text,
            "{:<12} {:>5} {:>7} {:>7} | {:>8} {:>7} | {:>8} {:>8} {:>8} | {:>8} {:>7} | {:>6} {:>6}",
            "", "", "", "", "mesh", "", "factor", "with Ψ", "", "Zipper", "", "BFF", "SC"
        );
        let _ = writeln!(
            text,
            "{:<12} {:>5} {:>7} {:>7} | {:>8} {:>7} | {:>8} {:>8} {:>8} | {:>8} {:>7} | {:>6} {:>6}",
            "", "m", "n", "N", "here", "paper", "here", "here", "paper", "here", "paper", "paper", "paper"
        );
        for Prepared { row, psi_s } in self.table_1.iter().filter(|prepared| prepared.row.setting == setting) {
            let (here, paper) = (&row.here, &row.paper);
            let optional =
                |s: &Option<f64>, digits: usize| s.map_or_else(|| "–".to_owned(), |s| format!("{s:.digits$}"));
            let _ = writeln!(
                text,
                "{:<12} {:>5} {:>7} {:>7} | {:>8.4} {:>7.3} | {:>8.4} {:>8} {:>8.3} | {:>8.3} {:>7.3} | {:>6.3} {:>6}",
                paper.domain.name(),
                here.m,
                here.n,
                here.triangles,
                here.triangulation_s,
                paper.triangulation_s,
                here.factorisation_s,
                optional(psi_s, 3),
                paper.psi_s,
                here.zipper_s,
                paper.zipper_s,
                paper.bff_s,
                optional(&paper.sc_toolbox_s, 0)
            );
        }
    }

    fn say_table_2(&self, setting: BenchSetting, text: &mut String) {
        let _ = writeln!(text, "\nTable 2, a frame in milliseconds, {}", title(setting));
        let _ = writeln!(
            text,
            "{:<36} {:>10} {:>7} | {:>8} {:>8} {:>8} | {:>8} {:>8}",
            "", "", "", "ψ+match", "", "", "extend", ""
        );
        let _ = writeln!(
            text,
            "{:<36} {:>10} {:>7} | {:>8} {:>8} {:>8} | {:>8} {:>8}",
            "", "m₁, m₂", "N₁", "x₁ moves", "x₂ moves", "paper", "here", "paper"
        );
        for row in self.table_2.iter().filter(|row| row.setting == setting) {
            let (here, paper) = (&row.here, &row.paper);
            let name = format!("Figure {}, {} → {}", paper.figure, paper.source.name(), paper.target.name());
            let samples = format!("{}, {}", here.m[0], here.m[1]);
            let _ = writeln!(
                text,
                "{name:<36} {samples:>10} {:>7} | {:>8.3} {:>8.3} {:>8.3} | {:>8.3} {:>8.3}",
                here.triangles,
                here.source.matching_ms,
                here.target.matching_ms,
                paper.matching_ms,
                here.source.extension_ms,
                paper.extension_ms
            );
        }
    }
}

fn title(setting: BenchSetting) -> &'static str {
    match setting {
        BenchSetting::Paper => "the paper's settings: uniform samples and triangles",
        BenchSetting::Default => "riemap's defaults: adaptive samples, graded triangles (the paper's numbers as above)",
    }
}
