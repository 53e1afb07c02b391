//! All tests: those of the crate natively (images on lavapipe), then those of the release
//! web app in Chromium, with WebGPU and with WebGL2.

use crate::node::ensure_test_packages;
use crate::places::Places;
use crate::report::Report;
use crate::shell::{Failure, output_of, run, say};
use crate::system::{ensure_chromium, ensure_lavapipe, ensure_program};
use crate::web;
use std::process::Command;
use std::thread;

/// The arguments for running the tests that read `../shared/data`, selected by the name of their modules (see
/// `tests/support/data.rs`).
const ON_SHARED_DATA: [&str; 4] = ["--tests", "--", "--ignored", "shared_data::"];

/// Runs all tests, continues after failures, and prints a summary. The web app is built meanwhile: most of that is
/// linking, which uses one core.
pub fn everything(places: &Places) -> Result<(), Failure> {
    let mut report = Report::default();
    let web_app = thread::scope(|scope| {
        let web_app = scope.spawn(|| web::dist(places));
        natively(places, &mut report);
        report.step("the web app (release), in the end", || {
            web_app.join().unwrap_or_else(|_| Err(Failure::new("building the web app", "it panicked")))
        })
    });
    if web_app {
        report.step("the web app in Chromium", || browser(places));
    } else {
        report.not_run("the web app in Chromium", "there is no web app to test");
    }
    report.finish("test")
}

fn natively(places: &Places, report: &mut Report) {
    report.step("cargo test", || run("cargo test", &mut cargo_test(places, &[])?));
    // the tool is not part of the workspace's default features
    report.step("wasm-bindgen's tests", || run("wasm-bindgen's tests", &mut wasm_bindgen_tests(places)));
    on_shared_data(places, report);
}

/// Runs the tests that read `../shared/data`; without that folder, lists them in the report.
fn on_shared_data(places: &Places, report: &mut Report) {
    const STEP: &str = "cargo test, on ../shared/data";
    if places.shared_data().is_dir() {
        report.step(STEP, || run(STEP, &mut cargo_test(places, &ON_SHARED_DATA)?));
        return;
    }
    let mut names = Vec::new();
    report.step("listing the tests on ../shared/data", || {
        let arguments = [&ON_SHARED_DATA[..], &["--list", "--format", "terse"]].concat();
        names = listed(&output_of("listing tests", &mut cargo_test(places, &arguments)?)?);
        if names.is_empty() { Err(Failure::new("listing tests", "there are none")) } else { Ok(()) }
    });
    report.left_out("../shared/data is absent", names);
}

/// The names of tests in the list printed by test programs, whose lines read `name: test`.
fn listed(output: &str) -> Vec<String> {
    output.lines().filter_map(|line| line.strip_suffix(": test")).map(str::to_owned).collect()
}

fn cargo_test(places: &Places, arguments: &[&str]) -> Result<Command, Failure> {
    // they run the formulas that are written as code
    for (program, package) in [("python3", "python3"), ("node", "nodejs")] {
        ensure_program(program, package)?;
    }
    let mut command = Command::new("cargo");
    command.args(["test", "--workspace", "--locked", "--no-fail-fast"]).args(arguments).current_dir(&places.root);
    if cfg!(target_os = "linux") {
        let driver = ensure_lavapipe()?;
        // the old and the new name of the variable; each loader reads one of them
        command.env("VK_ICD_FILENAMES", &driver).env("VK_DRIVER_FILES", &driver).env("WGPU_BACKEND", "vulkan");
    } else {
        say("images are drawn by this machine's GPU: lavapipe is set up on Linux only");
    }
    Ok(command)
}

fn wasm_bindgen_tests(places: &Places) -> Command {
    let mut command = Command::new("cargo");
    command.args(["test", "--package", "xtask", "--all-features", "--locked"]).current_dir(&places.root);
    // they compute nothing, and the library is large
    command.env("CARGO_PROFILE_DEV_OPT_LEVEL", "0");
    command
}

fn browser(places: &Places) -> Result<(), Failure> {
    let chromium = ensure_chromium()?;
    ensure_test_packages(places)?;
    let mut command = Command::new("node");
    // every file whose name ends in ".test.mjs", in sequence
    command.args(["--test", "--test-reporter=spec", "--test-concurrency=1"]);
    command.current_dir(places.browser_tests());
    command.env("CHROMIUM", chromium).env("RIEMAP_DIST", places.dist());
    run("the web app in Chromium", &mut command)
}

#[cfg(test)]
mod tests {
    use super::listed;

    #[test]
    fn tests_are_listed_by_their_names() {
        let output = "mesh::shared_data::reads: test\nshared_data::maps: test\nsweep: benchmark\n\n";
        assert_eq!(listed(output), ["mesh::shared_data::reads", "shared_data::maps"]);
    }
}
