//! Runs other programs. A line announces what is run and why, and a failure names
//! the step. Output goes straight to the terminal.

use std::ffi::OsStr;
use std::fmt;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The step that failed and the reason.
#[derive(Debug)]
pub struct Failure {
    step: String,
    reason: String,
}

impl Failure {
    pub fn new(step: impl Into<String>, reason: impl Into<String>) -> Self {
        Self { step: step.into(), reason: reason.into() }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.step, self.reason)
    }
}

/// Prints one line to stderr; stdout is for the programs that are run.
pub fn say(message: impl fmt::Display) {
    eprintln!("xtask: {message}");
}

/// Runs `command` to its end; an exit status other than 0 is a failure of `step`.
pub fn run(step: &str, command: &mut Command) -> Result<(), Failure> {
    let line = command_line(command);
    say(format_args!("{step}: {line}"));
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(Failure::new(step, format!("`{line}` ended with {status}"))),
        Err(error) => Err(Failure::new(step, format!("`{line}` did not start: {error}"))),
    }
}

/// Runs `command` to its end as [`run`] does, and returns its standard output.
pub fn output_of(step: &str, command: &mut Command) -> Result<String, Failure> {
    let line = command_line(command);
    say(format_args!("{step}: {line}"));
    let output = command.stderr(Stdio::inherit()).output();
    let output = output.map_err(|error| Failure::new(step, format!("`{line}` did not start: {error}")))?;
    if !output.status.success() {
        return Err(Failure::new(step, format!("`{line}` ended with {}", output.status)));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// The standard output of a short query, or `None` if it did not succeed.
pub fn ask(program: impl AsRef<OsStr>, arguments: &[&str]) -> Option<String> {
    let output = Command::new(program).args(arguments).stdin(Stdio::null()).stderr(Stdio::null()).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).into_owned())
}

/// The first file called `name` in the folders of `PATH`.
pub fn find_on_path(name: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH")?;
    std::env::split_paths(&path).map(|folder| program_in(&folder, name)).find(|file| file.is_file())
}

/// Where the program `name` would be in `folder` (with `.exe` on Windows).
pub fn program_in(folder: &Path, name: &str) -> PathBuf {
    folder.join(format!("{name}{}", std::env::consts::EXE_SUFFIX))
}

fn command_line(command: &Command) -> String {
    let words = std::iter::once(command.get_program()).chain(command.get_args());
    words.map(|word| word.to_string_lossy()).collect::<Vec<_>>().join(" ")
}
