//! Runs the program, and reads its output and files.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

pub fn riemap(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_riemap")).args(arguments).output().unwrap()
}

/// Runs the program and asserts success.
pub fn succeeds(arguments: &[&str]) -> Output {
    let output = riemap(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    output
}

/// Runs the program, asserts `status` and a message with all `words`, in one line except for usage errors; returns it.
pub fn fails(arguments: &[&str], status: i32, words: &[&str]) -> String {
    let output = riemap(arguments);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(status), "{arguments:?}: {stderr}");
    assert!(!stderr.contains("panicked"), "{arguments:?}: {stderr}");
    assert!(status == 2 || notes(&stderr).len() == 1, "{arguments:?}: {stderr}");
    for word in words {
        assert!(stderr.contains(word), "{arguments:?}: no {word:?} in: {stderr}");
    }
    stderr
}

/// The lines of stderr without progress messages, whose number depends on how busy the machine is.
pub fn notes(stderr: &str) -> Vec<&str> {
    stderr.lines().filter(|line| !line.ends_with("so far") && !line.ends_with("% done")).collect()
}

/// An empty folder for one test, with a space in its name.
pub fn folder(name: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("{} {name}", env!("CARGO_CRATE_NAME")));
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).unwrap();
    path
}

/// Writes a file into a folder and returns its path as an argument.
pub fn file(folder: &Path, name: &str, text: &str) -> String {
    let path = folder.join(name);
    std::fs::write(&path, text).unwrap();
    path.display().to_string()
}

/// The names in a folder.
pub fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}
