//! The files that tests read: the exact values in `tests/data`, and the outlines and meshes in `../shared/data`, which
//! may not be copied into the repository.
//!
//! A test whose file is missing fails. Those that read `../shared/data` stand in modules called `shared_data` and are
//! marked `#[ignore = "needs ../shared/data"]`, so that a clone without that folder leaves them out, and says so:
//! `cargo xtask test` runs them where the folder is there, and names them at its end where it is not.

use std::path::{Path, PathBuf};

fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The rows of a table of exact values; `tests/data/README.md` says what its columns are.
pub fn exact_values(name: &str) -> Vec<Vec<f64>> {
    let path = repository().join("tests/data").join(name);
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let row = |line: &str| line.split_whitespace().map(|word| word.parse().unwrap()).collect();
    text.lines().filter(|line| !line.starts_with('#')).map(row).collect()
}

/// A file or folder of `../shared/data`.
pub fn shared(name: &str) -> PathBuf {
    let path = repository().join("../shared/data").join(name);
    assert!(path.exists(), "{} is absent", path.display());
    path
}

/// The outlines of `../shared/data`, in the order of their names.
pub fn shared_outlines() -> Vec<PathBuf> {
    let entries = std::fs::read_dir(shared("outlines")).unwrap();
    let mut paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "json"));
    paths.sort();
    assert!(!paths.is_empty(), "there are no outlines");
    paths
}
