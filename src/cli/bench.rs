//! `riemap bench`: Tables 1 and 2 of the paper, measured here, beside the paper's numbers.

use super::CliError;
use super::arguments::BenchArguments;
use super::output::print;
use crate::figures::{
    BenchRow, BenchSetting, Frame, Measurement, PAPER_MACHINE, PaperFrame, PaperPreparation, Preparation, TABLE_1,
    TABLE_2,
};
use std::fmt::Write as _;

/// Runs per row, of which the median is taken; the paper doesn't say how many it took.
const RUNS: usize = 5;

/// What is measured on.
#[derive(serde::Serialize)]
struct Machine {
    cpu: Option<String>,
    cores: Option<usize>,
    threads: usize,
    system: String,
    optimised: bool,
}

impl Machine {
    fn this() -> Self {
        Self {
            cpu: std::fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| model_name(&text)),
            cores: std::thread::available_parallelism().ok().map(std::num::NonZero::get),
            threads: 1,
            system: format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
            optimised: !cfg!(debug_assertions),
        }
    }

    fn say(&self) -> String {
        let cpu = self.cpu.as_deref().unwrap_or("a processor that does not say its name");
        let cores = self.cores.map_or_else(String::new, |cores| format!(", {cores} cores"));
        let build = if self.optimised { "" } else { "; not a release build: times are too long" };
        format!("{cpu}{cores} ({}); one thread{build}", self.system)
    }
}

/// The first processor's name in the format of Linux.
fn model_name(cpuinfo: &str) -> Option<String> {
    let line = cpuinfo.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

/// A measured row with the paper's.
#[derive(serde::Serialize)]
struct Measured<T, P> {
    setting: BenchSetting,
    #[serde(flatten)]
    here: T,
    paper: P,
}

#[derive(serde::Serialize)]
struct Report {
    machine: Machine,
    paper_machine: &'static str,
    runs: usize,
    table_1: Vec<Measured<Preparation, PaperPreparation>>,
    table_2: Vec<Measured<Frame, PaperFrame>>,
}

/// Measures all rows and prints them.
pub fn run(arguments: &BenchArguments) -> Result<(), CliError> {
    let runs = if arguments.quick { 1 } else { RUNS };
    let machine = Machine::this();
    let mut report = Report { machine, paper_machine: PAPER_MACHINE, runs, table_1: vec![], table_2: vec![] };
    for row in BenchRow::all() {
        match (row, row.measure(runs)?) {
            (BenchRow::Preparation { index, setting }, Some(Measurement::Preparation(here))) => {
                report.table_1.push(Measured { setting, here, paper: TABLE_1[index] });
            }
            (BenchRow::Frame { index, setting }, Some(Measurement::Frame(here))) => {
                report.table_2.push(Measured { setting, here, paper: TABLE_2[index] });
            }
            _ => (),
        }
    }
    if arguments.json {
        let text = serde_json::to_string_pretty(&report).map_err(|error| CliError::Input(error.to_string()))?;
        return print(&text);
    }
    print(&report.say())
}

impl Report {
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
            "{:<12} {:>5} {:>7} {:>7} | {:>17} | {:>19} | {:>15} | {:>7} {:>7}",
            "", "m", "n", "N", "mesh here  paper", "factor here  Ψ paper", "Zipper here  paper", "BFF", "SC"
        );
        for row in self.table_1.iter().filter(|row| row.setting == setting) {
            let (here, paper) = (&row.here, &row.paper);
            let sc = paper.sc_toolbox_s.map_or_else(|| "–".to_owned(), |s| format!("~{s}"));
            let _ = writeln!(
                text,
                "{:<12} {:>5} {:>7} {:>7} | {:>9.3} {:>7.3} | {:>11.3} {:>8.3} | {:>11.3} {:>6.3} | {:>7.3} {:>7}",
                paper.domain.name(),
                here.m,
                here.n,
                here.triangles,
                here.triangulation_s,
                paper.triangulation_s,
                here.factorisation_s,
                paper.psi_s,
                here.zipper_s,
                paper.zipper_s,
                paper.bff_s,
                sc
            );
        }
    }

    fn say_table_2(&self, setting: BenchSetting, text: &mut String) {
        let _ = writeln!(text, "\nTable 2, a frame in milliseconds, {}", title(setting));
        let _ = writeln!(
            text,
            "{:<36} {:>11} {:>7} | {:>26} | {:>16}",
            "", "m₁, m₂", "N₁", "ψ + matching: x₁   x₂  paper", "extension  paper"
        );
        for row in self.table_2.iter().filter(|row| row.setting == setting) {
            let (here, paper) = (&row.here, &row.paper);
            let name = format!("Figure {}, {} → {}", paper.figure, paper.source.name(), paper.target.name());
            let _ = writeln!(
                text,
                "{name:<36} {:>11} {:>7} | {:>14.3} {:>6.3} {:>6.3} | {:>9.3} {:>6.3}",
                format!("{}, {}", here.m[0], here.m[1]),
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn processor_is_read_from_cpuinfo() {
        assert_eq!(model_name("processor\t: 0\nmodel name\t: A B @ 2 GHz\n"), Some("A B @ 2 GHz".to_owned()));
        assert_eq!(model_name("Features : fp"), None);
    }
}
