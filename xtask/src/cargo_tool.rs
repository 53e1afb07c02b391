//! Programs installed by cargo: identified by their exact version, installed once.
//!
//! They go into the project's folder in the user's cache and not into the cargo
//! home: they have only the features that are used here. Each version of each
//! program has a folder of its own, so that clones that need different versions
//! do not replace each other's.

use crate::places::Places;
use crate::shell::{Failure, ask, find_on_path, program_in, run, say};
use std::env;
use std::ffi::OsString;
use std::fs;
use std::hash::{DefaultHasher, Hasher};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Set by a caller (or by cargo itself) for builds of this repository; removed when a tool
/// is built.
const OUR_BUILD_SETTINGS: [&str; 5] =
    ["CARGO_TARGET_DIR", "CARGO_BUILD_TARGET", "CARGO_ENCODED_RUSTFLAGS", "RUSTFLAGS", "RUSTDOCFLAGS"];

/// Overrides for fat LTO in one codegen unit, which trunk and cargo-deny request: it takes
/// several times as long to build without a noticeable gain.
const QUICK_RELEASE: [(&str, &str); 2] =
    [("CARGO_PROFILE_RELEASE_LTO", "off"), ("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "16")];

/// How much a tool is optimized. The time that matters is that of its compilation.
#[derive(Clone, Copy)]
pub enum Optimization {
    /// Not at all: for a tool that copies files and starts other programs.
    None,
    /// A little: for a tool that processes megabytes.
    Basic,
}

impl Optimization {
    fn level(self) -> &'static str {
        match self {
            Self::None => "0",
            Self::Basic => "1",
        }
    }
}

/// The origin of a program.
pub enum Source {
    /// A package of the registry, with additional arguments for `cargo install`.
    Registry { package: &'static str, arguments: &'static [&'static str] },
    /// This project's own package xtask, with the feature of the program's name; `source` is the program's file.
    Xtask { source: &'static str },
}

/// A program at a pinned version.
pub struct CargoTool {
    /// The program's name.
    pub program: &'static str,
    /// The required version.
    pub version: String,
    /// Where to install it from.
    pub source: Source,
    /// How it is compiled.
    pub optimization: Optimization,
    /// What it is used for, printed while it is installed.
    pub purpose: &'static str,
}

impl CargoTool {
    /// The folder that contains this version of the program; installs it if necessary.
    pub fn ensure(&self, places: &Places) -> Result<PathBuf, Failure> {
        let root = self.root(places)?;
        let programs = [self.program_in(&root), self.program_in(&places.cargo_home), find_on_path(self.program)];
        let is_right = |program: &PathBuf| version_of(program).as_ref() == Some(&self.version);
        if let Some(program) = programs.into_iter().flatten().find(is_right) {
            return Ok(program.parent().unwrap_or(Path::new("")).to_path_buf());
        }
        self.install(places, &root)?;
        match self.program_in(&root).as_deref().and_then(version_of) {
            Some(version) if version == self.version => Ok(root.join("bin")),
            other => Err(Failure::new(
                format!("installing {} {}", self.program, self.version),
                format!("{} says that it is version {}", root.display(), other.as_deref().unwrap_or("(none)")),
            )),
        }
    }

    /// Where this version is installed (it goes to the folder's `bin/`). The name of this project's own program
    /// includes a hash of its source, which may change while the version does not.
    fn root(&self, places: &Places) -> Result<PathBuf, Failure> {
        let name = format!("{}-{}", self.program, self.version);
        let Source::Xtask { source } = self.source else { return Ok(places.tools.join(name)) };
        let text = fs::read(places.root.join(source)).map_err(|error| Failure::new(source, error.to_string()))?;
        let mut hasher = DefaultHasher::new();
        hasher.write(&text);
        Ok(places.tools.join(format!("{name}-{:016x}", hasher.finish())))
    }

    fn program_in(&self, root: &Path) -> Option<PathBuf> {
        Some(program_in(&root.join("bin"), self.program)).filter(|file| file.is_file())
    }

    fn install(&self, places: &Places, root: &Path) -> Result<(), Failure> {
        let step = format!("installing {} {}", self.program, self.version);
        fs::create_dir_all(&places.cache).map_err(|error| Failure::new(&step, error.to_string()))?;
        if let Some(mut binstall) = self.binstall(root)
            && run(&step, &mut binstall).is_ok()
        {
            return Ok(());
        }
        say(format_args!(
            "{} ({}) is compiled from source, once, into {}: this takes minutes",
            self.program,
            self.purpose,
            root.display()
        ));
        run(&step, self.compile(places, root).current_dir(&places.cache))
    }

    /// Fetches a ready-made program, where cargo-binstall is there and the program is published.
    fn binstall(&self, root: &Path) -> Option<Command> {
        let Source::Registry { package, .. } = self.source else { return None };
        find_on_path("cargo-binstall")?;
        let mut command = Command::new("cargo");
        command.args(["binstall", "--no-confirm", "--disable-strategies", "compile", "--root"]).arg(root);
        command.arg(format!("{package}@{}", self.version));
        Some(command)
    }

    fn compile(&self, places: &Places, root: &Path) -> Command {
        let mut command = Command::new("cargo");
        command.args(["install", "--locked", "--root"]).arg(root);
        match self.source {
            Source::Registry { package, arguments } => {
                command.args([package, "--version", &self.version]).args(arguments);
            }
            Source::Xtask { .. } => {
                command.arg("--path").arg(places.root.join("xtask"));
                command.args(["--features", self.program, "--bin", self.program]);
            }
        }
        for setting in OUR_BUILD_SETTINGS {
            command.env_remove(setting);
        }
        command.envs(QUICK_RELEASE).env("CARGO_PROFILE_RELEASE_OPT_LEVEL", self.optimization.level());
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
