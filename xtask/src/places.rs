//! Paths: the repository, the user's cargo home, and the project's
//! folder in the user's cache, the only place outside the repository that
//! these commands write to.

use crate::shell::Failure;
use std::env;
use std::path::{Path, PathBuf};

/// The folders that the commands work with.
pub struct Places {
    /// The root of the repository.
    pub root: PathBuf,
    /// The folder of the user's own `cargo install` (programs are in its `bin/`).
    pub cargo_home: PathBuf,
    /// `riemap/` in the user's cache.
    pub cache: PathBuf,
    /// Where these commands install programs, each version in a folder of its own.
    pub tools: PathBuf,
}

impl Places {
    pub fn find() -> Result<Self, Failure> {
        let missing = |what: &str| Failure::new("looking around", format!("{what} is not set"));
        let manifest = folder("CARGO_MANIFEST_DIR").unwrap_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")));
        let root = manifest.parent().map(Path::to_path_buf).ok_or_else(|| missing("the repository's root"))?;
        let home = folder("HOME").or_else(|| folder("USERPROFILE")).ok_or_else(|| missing("HOME"))?;
        let cargo_home = folder("CARGO_HOME").unwrap_or_else(|| home.join(".cargo"));
        let user_cache = folder("XDG_CACHE_HOME").or_else(|| folder("LOCALAPPDATA"));
        let cache = user_cache.unwrap_or_else(|| home.join(".cache")).join("riemap");
        Ok(Self {
            root,
            cargo_home: folder("CARGO_INSTALL_ROOT").unwrap_or(cargo_home),
            tools: cache.join("tools"),
            cache,
        })
    }

    /// The folder of the browser tests, which is an npm package.
    pub fn browser_tests(&self) -> PathBuf {
        self.root.join("tests").join("browser")
    }

    /// Outlines and meshes for tests that may not be copied into the repository; missing in many clones.
    pub fn shared_data(&self) -> PathBuf {
        self.root.join("..").join("shared").join("data")
    }

    /// The built web app.
    pub fn dist(&self) -> PathBuf {
        self.root.join("dist")
    }
}

fn folder(variable: &str) -> Option<PathBuf> {
    env::var_os(variable).filter(|value| !value.is_empty()).map(PathBuf::from)
}
