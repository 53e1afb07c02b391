//! The checks that do not run the program: the table of rooms, the number of fields, formatting, clippy
//! and documentation, natively and for the web, and the licenses of dependencies.

use crate::cargo_tool::{CargoTool, Optimization, Source, path_with};
use crate::fields;
use crate::places::Places;
use crate::report::Report;
use crate::rooms;
use crate::rust::{WEB_TARGET, ensure_component, ensure_web_target};
use crate::shell::{Failure, run, say};
use std::process::Command;

/// The newest cargo-deny that has been tested; it needs rustc 1.88.
const CARGO_DENY_VERSION: &str = "0.20.2";

/// The parts of cargo-deny's check that need no network.
const DENY_OFFLINE: [&str; 3] = ["bans", "licenses", "sources"];

/// Runs all checks. Their order lets later steps reuse the compilation of earlier ones.
pub fn everything(places: &Places) -> Result<(), Failure> {
    ensure_component("rustfmt", "fmt")?;
    ensure_component("clippy", "clippy")?;
    ensure_web_target()?;
    let mut report = Report::default();
    report.step("rooms", || rooms::check(places));
    report.step("fields", || fields::check(places));
    let mut cargo_step = |name: &str, arguments: &[&str]| {
        report.step(name, || run(name, cargo(places, arguments).env("RUSTDOCFLAGS", "-D warnings")));
    };
    cargo_step("rustfmt", &["fmt", "--all", "--check"]);
    cargo_step("clippy", &["clippy", "--workspace", "--all-targets", "--locked", "--", "-D", "warnings"]);
    cargo_step(
        "clippy for the web",
        &["clippy", "--lib", "--bins", "--locked", "--target", WEB_TARGET, "--", "-D", "warnings"],
    );
    cargo_step(
        "clippy of wasm-bindgen",
        &["clippy", "--package", "xtask", "--all-features", "--all-targets", "--locked", "--", "-D", "warnings"],
    );
    cargo_step("rustdoc", &["doc", "--lib", "--no-deps", "--locked"]);
    cargo_step("the core alone", &["check", "--lib", "--no-default-features", "--locked"]);
    cargo_step(
        "the core alone, for the web",
        &["check", "--lib", "--no-default-features", "--locked", "--target", WEB_TARGET],
    );
    report.step("cargo-deny", || deny(places));
    report.finish("lint")
}

fn cargo(places: &Places, arguments: &[&str]) -> Command {
    let mut command = Command::new("cargo");
    command.args(arguments).current_dir(&places.root);
    command
}

/// Checks licenses, duplicates and sources; also advisories, if their database is available.
fn deny(places: &Places) -> Result<(), Failure> {
    let tool = CargoTool {
        program: "cargo-deny",
        version: CARGO_DENY_VERSION.to_owned(),
        source: Source::Registry { package: "cargo-deny", arguments: &[] },
        optimization: Optimization::Basic,
        purpose: "which checks the licences and sources of the dependencies",
    };
    let path = path_with(&[tool.ensure(places)?])?;
    let deny = |arguments: &[&str]| {
        let mut command = cargo(places, &["deny"]);
        command.args(arguments).env("PATH", &path);
        command
    };
    run("cargo-deny", deny(&["check", "--hide-inclusion-graph"]).args(DENY_OFFLINE))?;
    if let Err(failure) = run("fetching the advisories", &mut deny(&["fetch", "db"])) {
        say(format_args!("security advisories were NOT checked: their database is out of reach ({failure})"));
        return Ok(());
    }
    run("advisories", &mut deny(&["check", "--disable-fetch", "advisories"]))
}
