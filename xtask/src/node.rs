//! What comes from npm: playwright-core for the browser tests, at the versions
//! of their lock file, and binaryen's wasm-opt, which is optional.

use crate::places::Places;
use crate::shell::{Failure, ask, run, say};
use crate::system::ensure_program;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::SystemTime;

const BINARYEN_VERSION: &str = "132.0.0";
const OLDEST_NODE: u32 = 20;

/// Makes sure that Node can run the browser tests: playwright-core is there, as locked.
pub fn ensure_test_packages(places: &Places) -> Result<(), Failure> {
    let folder = places.browser_tests();
    ensure_node()?;
    let installed = changed(&folder.join("node_modules").join(".package-lock.json"));
    if installed.is_some() && installed >= changed(&folder.join("package-lock.json")) {
        return Ok(());
    }
    let npm = ensure_program("npm", "npm")?;
    let mut command = Command::new(npm);
    command.args(["ci", "--ignore-scripts", "--no-audit", "--no-fund"]).current_dir(&folder);
    run("installing playwright-core", &mut command)
}

fn ensure_node() -> Result<(), Failure> {
    let node = ensure_program("node", "nodejs")?;
    let version = ask(node, &["--version"]).unwrap_or_default();
    if major(&version).is_some_and(|major| major >= OLDEST_NODE) {
        return Ok(());
    }
    Err(Failure::new(
        "looking for Node",
        format!("playwright-core needs Node {OLDEST_NODE}, this is {}", version.trim()),
    ))
}

/// The 20 of "v20.11.1".
fn major(version: &str) -> Option<u32> {
    version.strip_prefix('v')?.split('.').next()?.parse().ok()
}

/// wasm-opt, or `None` with a line that says why the app goes without.
pub fn wasm_opt(places: &Places) -> Option<PathBuf> {
    let folder = places.cache.join("npm").join(format!("binaryen-{BINARYEN_VERSION}"));
    let program = folder.join("node_modules").join(".bin").join("wasm-opt");
    if program.exists() {
        return Some(program);
    }
    match install_binaryen(&folder) {
        Ok(()) => Some(program),
        Err(failure) => {
            say(format_args!("going on without wasm-opt, which is optional ({failure})"));
            None
        }
    }
}

fn install_binaryen(folder: &Path) -> Result<(), Failure> {
    let step = "installing wasm-opt";
    fs::create_dir_all(folder).map_err(|error| Failure::new(step, error.to_string()))?;
    let mut command = Command::new("npm");
    command.args(["install", "--no-save", "--ignore-scripts", "--no-audit", "--no-fund", "--prefix"]).arg(folder);
    run(step, command.arg(format!("binaryen@{BINARYEN_VERSION}")))
}

fn changed(file: &Path) -> Option<SystemTime> {
    fs::metadata(file).and_then(|metadata| metadata.modified()).ok()
}

#[cfg(test)]
mod tests {
    use super::major;

    #[test]
    fn nodes_major_version_is_the_number_before_the_first_dot() {
        assert_eq!(major("v20.11.1\n"), Some(20));
        assert_eq!(major("not found"), None);
    }
}
