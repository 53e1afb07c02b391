//! The parts of the Rust toolchain: the web target, rustfmt and clippy.
//! rustup installs missing ones; without rustup a missing one is an error.

use crate::places::Places;
use crate::shell::{Failure, ask, find_on_path, run};
use std::fs;
use std::path::Path;
use std::process::Command;

pub const WEB_TARGET: &str = "wasm32-unknown-unknown";

/// Installs the web target if necessary.
pub fn ensure_web_target() -> Result<(), Failure> {
    let step = "adding the web target";
    let library = ask("rustc", &["--print", "target-libdir", "--target", WEB_TARGET]);
    if library.is_some_and(|folder| Path::new(folder.trim()).is_dir()) {
        return Ok(());
    }
    rustup(step, &["target", "add", WEB_TARGET])
}

/// Installs a component with a cargo subcommand if necessary.
pub fn ensure_component(component: &str, subcommand: &str) -> Result<(), Failure> {
    if ask("cargo", &[subcommand, "--version"]).is_some() {
        return Ok(());
    }
    rustup(&format!("adding {component}"), &["component", "add", component])
}

/// The version of a package in Cargo.lock.
pub fn locked_version(places: &Places, package: &str) -> Result<String, Failure> {
    let step = "reading Cargo.lock";
    let lock =
        fs::read_to_string(places.root.join("Cargo.lock")).map_err(|error| Failure::new(step, error.to_string()))?;
    version_in_lock(&lock, package).ok_or_else(|| Failure::new(step, format!("it has no package {package}")))
}

fn version_in_lock(lock: &str, package: &str) -> Option<String> {
    let name = format!("name = \"{package}\"");
    let mut lines = lock.lines().skip_while(|line| *line != name).skip(1);
    let version = lines.next()?.strip_prefix("version = \"")?.strip_suffix('"')?;
    Some(version.to_owned())
}

fn rustup(step: &str, arguments: &[&str]) -> Result<(), Failure> {
    if find_on_path("rustup").is_none() {
        let line = arguments.join(" ");
        return Err(Failure::new(step, format!("needs rustup (https://rustup.rs), to run `rustup {line}`")));
    }
    run(step, Command::new("rustup").args(arguments))
}

#[cfg(test)]
mod tests {
    use super::version_in_lock;

    const LOCK: &str = "[[package]]\nname = \"wasm-bindgen-futures\"\nversion = \"0.4.1\"\n\n\
                        [[package]]\nname = \"wasm-bindgen\"\nversion = \"0.2.130\"\nsource = \"registry\"\n";

    #[test]
    fn locked_version_is_that_of_the_package_with_exactly_this_name() {
        assert_eq!(version_in_lock(LOCK, "wasm-bindgen").as_deref(), Some("0.2.130"));
    }

    #[test]
    fn a_package_that_is_not_locked_has_no_version() {
        assert_eq!(version_in_lock(LOCK, "wasm"), None);
    }
}
