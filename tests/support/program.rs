//! Runs the program as a person does, and reads what it says and writes.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

pub fn riemap(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_riemap")).args(arguments).output().unwrap()
}

/// Runs and expects that all went well.
pub fn succeeds(arguments: &[&str]) -> Output {
    let output = riemap(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    output
}

/// Runs, expects `status` and a message that contains every word, in one line if it is not about the usage: the message.
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

/// All lines of stderr but those that say how far a command is: on a busy machine there may be any number of them.
pub fn notes(stderr: &str) -> Vec<&str> {
    stderr.lines().filter(|line| !line.ends_with("so far") && !line.ends_with("% done")).collect()
}

/// An empty folder for one test; its name has a space in it.
pub fn folder(name: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("{} {name}", env!("CARGO_CRATE_NAME")));
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).unwrap();
    path
}

/// Writes a file into a folder: its path, as an argument.
pub fn file(folder: &Path, name: &str, text: &str) -> String {
    let path = folder.join(name);
    std::fs::write(&path, text).unwrap();
    path.display().to_string()
}

/// What is in a folder.
pub fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}
