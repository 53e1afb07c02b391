//! Every test: the crate's own natively (images on lavapipe), then the release
//! web app in Chromium, with WebGPU and with WebGL2.

use crate::node::ensure_test_packages;
use crate::places::Places;
use crate::report::Report;
use crate::shell::{Failure, run, say};
use crate::system::{ensure_chromium, ensure_lavapipe};
use crate::web;
use std::process::Command;

/// Runs everything, whatever fails, and sums up.
pub fn everything(places: &Places) -> Result<(), Failure> {
    let mut report = Report::default();
    report.step("cargo test", || native(places));
    if report.step("the web app (release)", || web::dist(places)) {
        report.step("the web app in Chromium", || browser(places));
    } else {
        report.not_run("the web app in Chromium", "there is no web app to test");
    }
    report.finish("test")
}

fn native(places: &Places) -> Result<(), Failure> {
    let mut command = Command::new("cargo");
    command.args(["test", "--workspace", "--locked"]).current_dir(&places.root);
    if cfg!(target_os = "linux") {
        let driver = ensure_lavapipe()?;
        // The old name and the new one; each loader reads the one it knows.
        command.env("VK_ICD_FILENAMES", &driver).env("VK_DRIVER_FILES", &driver).env("WGPU_BACKEND", "vulkan");
    } else {
        say("images are drawn by this machine's GPU: lavapipe is set up on Linux only");
    }
    run("cargo test", &mut command)
}

fn browser(places: &Places) -> Result<(), Failure> {
    let chromium = ensure_chromium()?;
    ensure_test_packages(places)?;
    let mut command = Command::new("node");
    // every file whose name ends in ".test.mjs", one after the other
    command.args(["--test", "--test-reporter=spec", "--test-concurrency=1"]);
    command.current_dir(places.browser_tests());
    command.env("CHROMIUM", chromium).env("RIEMAP_DIST", places.dist());
    run("the web app in Chromium", &mut command)
}
