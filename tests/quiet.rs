//! Commands that draw write nothing to stderr if there is no display.

#![cfg(feature = "app")]
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use riemap::session::{Session, link};
use std::path::Path;
use std::process::Command;
use support::program::notes;

/// The variables that tell a process where a display is.
const DISPLAYS: [&str; 4] = ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET", "XDG_RUNTIME_DIR"];

/// Runs a command that draws into the file `name`, without a display, as in a container or a service.
fn draws_quietly(name: &str, arguments: &[&str]) {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_file(&out);
    let mut command = Command::new(env!("CARGO_BIN_EXE_riemap"));
    command.args(arguments).arg("--out").arg(&out);
    for variable in DISPLAYS {
        command.env_remove(variable);
    }
    let output = command.output().unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{arguments:?}: {stderr}");
    assert!(out.exists(), "{arguments:?} draws nothing");
    assert_eq!(notes(&stderr), [""; 0], "{arguments:?}");
}

#[test]
fn a_missing_display_is_not_mentioned() {
    let link = link::encode(&Session::default()).unwrap().fragment;
    draws_quietly("quiet-render.png", &["render", &link, "--size", "160x90"]);
    draws_quietly("quiet-animate.png", &["animate", &link, "--size", "120x80", "--frames", "4"]);
    draws_quietly("quiet-map.png", &["map", "preset:disk", "preset:square", "--source-samples", "100"]);
    let flatten = ["flatten", "preset:hemisphere:40", "preset:disk", "--samples", "80", "--size", "160x80"];
    draws_quietly("quiet-flatten.png", &flatten);
    draws_quietly("quiet-figure", &["figure", "12", "--quick"]);
}
