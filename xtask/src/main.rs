//! The project's commands: `cargo xtask serve | dist | test | lint`.
//!
//! Each command installs what it needs and announces each step before it runs. After a failure it ends with
//! status 1 and the name of the failed step (2 for wrong usage). Only `serve` keeps running.

mod cargo_tool;
mod fields;
mod lint;
mod node;
mod package;
mod places;
mod report;
mod rooms;
mod rust;
mod shell;
mod system;
mod test;
mod web;

use places::Places;
use shell::Failure;
use std::process::ExitCode;

const USAGE: &str = "\
usage: cargo xtask <command>

  serve [--port N] [--open]  install what the web app needs, build it and serve it
  dist                       build the web app into dist/, ready to be hosted
  test                       every test: unit, images on lavapipe, real browsers
  lint                       rooms, fields, rustfmt, clippy, rustdoc, the core alone, cargo-deny";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let outcome = match words.as_slice() {
        ["serve", options @ ..] => match web::ServeOptions::parse(options) {
            Ok(options) => at_home(|places| web::serve(places, &options)),
            Err(message) => return misuse(&message),
        },
        ["dist"] => at_home(web::dist),
        ["test"] => at_home(test::everything),
        ["lint"] => at_home(lint::everything),
        [] | ["help" | "--help" | "-h"] => {
            println!("{USAGE}");
            return ExitCode::SUCCESS;
        }
        [other, ..] => return misuse(&format!("no such command, or too many words after it: {other}")),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("xtask: failed: {failure}");
            ExitCode::FAILURE
        }
    }
}

fn at_home(command: impl FnOnce(&Places) -> Result<(), Failure>) -> Result<(), Failure> {
    command(&Places::find()?)
}

fn misuse(message: &str) -> ExitCode {
    eprintln!("xtask: {message}\n{USAGE}");
    ExitCode::from(2)
}
