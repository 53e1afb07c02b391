//! The program: without arguments the app, in a window or in the page's canvas;
//! with a subcommand (natively) the command line.

use std::process::ExitCode;

#[cfg(not(target_arch = "wasm32"))]
fn main() -> ExitCode {
    match <riemap::cli::Arguments as clap::Parser>::parse().command {
        Some(command) => {
            riemap::cli::silence_display(&command);
            riemap::cli::run(&command)
        }
        None => start(),
    }
}

#[cfg(target_arch = "wasm32")]
fn main() -> ExitCode {
    start()
}

fn start() -> ExitCode {
    match riemap::app::start() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}
