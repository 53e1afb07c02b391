//! The npm package playwright-core for the browser tests, in the version of their lock file.

use crate::places::Places;
use crate::shell::{Failure, ask, run};
use crate::system::ensure_program;
use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::SystemTime;

const OLDEST_NODE: u32 = 20;

/// Installs playwright-core in the locked version if necessary, and checks Node.
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

/// The major version: 20 for "v20.11.1".
fn major(version: &str) -> Option<u32> {
    version.strip_prefix('v')?.split('.').next()?.parse().ok()
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
