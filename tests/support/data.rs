//! The files that tests read: the exact values in `tests/data`, and the outlines and meshes in `../shared/data`, which
//! may not be copied into the repository.
//!
//! A test whose file is missing fails. Tests that read `../shared/data` are in modules called `shared_data` and
//! marked `#[ignore = "needs ../shared/data"]`, so that they are skipped, and reported as skipped, in a clone without
//! that folder. `cargo xtask test` runs them if the folder exists, and otherwise lists them at the end.

use std::path::{Path, PathBuf};

fn repository() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The rows of a table of exact values; `tests/data/README.md` describes its columns.
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

/// The outlines of `../shared/data`, sorted by name.
pub fn shared_outlines() -> Vec<PathBuf> {
    let entries = std::fs::read_dir(shared("outlines")).unwrap();
    let mut paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "json"));
    paths.sort();
    assert!(!paths.is_empty(), "there are no outlines");
    paths
}
