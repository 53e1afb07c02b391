//! `riemap prepare`: vertex counts and durations of the preparation of one domain.

use super::CliError;
use super::arguments::PrepareArguments;
use super::named_outline::read_outline;
use super::output::{print, say_kernel, say_solver, triangles, warn_if_coarse, words};
use super::progress::Progress;
use super::tables::Counts;
use crate::conformal::PrepareTimings;

/// Prepares the domain `repeat` times and prints the medians.
pub fn run(arguments: &PrepareArguments) -> Result<(), CliError> {
    let named = read_outline(&arguments.domain, &arguments.reading.one(&arguments.domain)?)?
        .interpreted(arguments.discretization.interpret);
    let settings = arguments.discretization.settings(&named, None);
    let mut runs = Vec::new();
    let mut counts = Counts::default();
    let progress = Progress::new("preparing");
    for _ in 0..arguments.repeat {
        let side = named.prepare(&[], &settings, &mut progress.preparing(&arguments.domain));
        let side = side.map_err(|error| CliError::Input(format!("{}: {error}", arguments.domain)))?;
        counts = Counts::of_side(&side);
        warn_if_coarse(&arguments.domain, &side);
        say_solver(&arguments.domain, settings.solver, side.solver_kind());
        say_kernel(&arguments.domain, &side);
        runs.push(side.timings());
    }
    drop(progress);
    let timings = medians(&runs);
    named.say_notes(&arguments.domain);
    let interpreted = named.interpretation(&arguments.domain);
    if arguments.json {
        let report = serde_json::json!({
            "counts": counts,
            "interpretation": interpreted,
            "timing_ms": timings,
            "total_ms": timings.total(),
        });
        return print(&format!("{report:#}"));
    }
    let PrepareTimings { sample, mesh, assemble, order, factor, table, integral } = timings;
    print(&format!(
        "{}{}: m = {}, n = {}, {}\n\
         {:.1} ms: sample {sample:.1}, mesh {mesh:.1}, assemble {assemble:.1}, order {order:.1}, factor {factor:.1}{}{}",
        named.outline.name(),
        interpreted.map(|interpreted| format!(" ({})", words(interpreted))).unwrap_or_default(),
        counts.m,
        counts.n,
        triangles(counts.triangles),
        timings.total(),
        if table > 0.0 { format!(", table {table:.1}") } else { String::new() },
        if integral > 0.0 { format!(", integral {integral:.1}") } else { String::new() },
    ))
}

fn medians(runs: &[PrepareTimings]) -> PrepareTimings {
    let median = |stage: fn(&PrepareTimings) -> f64| {
        let mut values: Vec<f64> = runs.iter().map(stage).collect();
        values.sort_by(f64::total_cmp);
        values.get(values.len() / 2).copied().unwrap_or(0.0)
    };
    PrepareTimings {
        sample: median(|t| t.sample),
        mesh: median(|t| t.mesh),
        assemble: median(|t| t.assemble),
        order: median(|t| t.order),
        factor: median(|t| t.factor),
        table: median(|t| t.table),
        integral: median(|t| t.integral),
    }
}
