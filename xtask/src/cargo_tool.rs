//! Programs that cargo installs: found by their exact version, installed once.
//!
//! They go into the user's cargo home. If another version is there already, it
//! is left alone and ours goes into the project's folder in the user's cache.

use crate::places::Places;
use crate::shell::{Failure, ask, find_on_path, program_in, run, say};
use std::env;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Set by a caller (or by cargo itself) for this repository's own builds; a
/// tool is built without them, in a temporary folder.
const OUR_BUILD_SETTINGS: [&str; 5] =
    ["CARGO_TARGET_DIR", "CARGO_BUILD_TARGET", "CARGO_ENCODED_RUSTFLAGS", "RUSTFLAGS", "RUSTDOCFLAGS"];

/// Fat LTO in one codegen unit, which trunk and cargo-deny ask for, takes
/// several times as long to build and saves nothing that one can notice.
const QUICK_RELEASE: [(&str, &str); 2] =
    [("CARGO_PROFILE_RELEASE_LTO", "off"), ("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "16")];

/// A program at a pinned version.
pub struct CargoTool {
    /// The package that holds it.
    pub package: &'static str,
    /// The program's name.
    pub program: &'static str,
    /// The one version that is right.
    pub version: String,
    /// Further arguments of `cargo install`.
    pub arguments: &'static [&'static str],
    /// What it is for, to say why one waits.
    pub purpose: &'static str,
}

impl CargoTool {
    /// The folder that holds this version of the program, after installing it if need be.
    pub fn ensure(&self, places: &Places) -> Result<PathBuf, Failure> {
        let private = places.private_root();
        let candidates = [find_on_path(self.program), self.program_in(&places.install_root), self.program_in(&private)];
        let found: Vec<PathBuf> = candidates.into_iter().flatten().collect();
        if let Some(right) = found.iter().find(|file| version_of(file).as_deref() == Some(&self.version)) {
            return Ok(right.parent().unwrap_or(Path::new("")).to_path_buf());
        }
        let root = match found.first() {
            Some(other) => {
                say(format_args!("{} is not version {}; it is left alone", other.display(), self.version));
                private
            }
            None => places.install_root.clone(),
        };
        self.install(&root, places)?;
        Ok(root.join("bin"))
    }

    fn program_in(&self, root: &Path) -> Option<PathBuf> {
        Some(program_in(&root.join("bin"), self.program)).filter(|file| file.is_file())
    }

    fn install(&self, root: &Path, places: &Places) -> Result<(), Failure> {
        let step = format!("installing {} {}", self.package, self.version);
        fs::create_dir_all(&places.cache).map_err(|error| Failure::new(&step, error.to_string()))?;
        if find_on_path("cargo-binstall").is_some() && run(&step, &mut self.binstall(root)).is_ok() {
            return Ok(());
        }
        say(format_args!(
            "{} ({}) is compiled from source, once, into {}: this takes minutes, as no ready-made program was found",
            self.package,
            self.purpose,
            root.display()
        ));
        run(&step, self.compile(root).current_dir(&places.cache))
    }

    fn binstall(&self, root: &Path) -> Command {
        let mut command = Command::new("cargo");
        command.args(["binstall", "--no-confirm", "--disable-strategies", "compile", "--root"]).arg(root);
        command.arg(format!("{}@{}", self.package, self.version));
        command
    }

    fn compile(&self, root: &Path) -> Command {
        let mut command = Command::new("cargo");
        command.args(["install", self.package, "--version", &self.version, "--root"]).arg(root).args(self.arguments);
        for setting in OUR_BUILD_SETTINGS {
            command.env_remove(setting);
        }
        command.envs(QUICK_RELEASE);
        command
    }
}

/// `PATH` with `folders` in front of it.
pub fn path_with(folders: &[PathBuf]) -> Result<OsString, Failure> {
    let path = env::var_os("PATH").unwrap_or_default();
    let all = folders.iter().cloned().chain(env::split_paths(&path));
    env::join_paths(all).map_err(|error| Failure::new("setting PATH", error.to_string()))
}

/// The version in the second word of `program --version`.
fn version_of(program: &Path) -> Option<String> {
    ask(program, &["--version"])?.split_whitespace().nth(1).map(str::to_owned)
}
