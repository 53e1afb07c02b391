//! The program: without arguments the app, in a window or in the page's canvas.

use std::process::ExitCode;

fn main() -> ExitCode {
    // The headless subcommands will be dispatched here, natively, when there are arguments.
    match riemap::platform::start() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}
