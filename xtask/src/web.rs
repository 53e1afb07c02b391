//! The web app: trunk compiles it, runs wasm-bindgen, and writes or serves `dist/`.

use crate::cargo_tool::{CargoTool, Optimization, Source, path_with};
use crate::package::Package;
use crate::places::Places;
use crate::rust::{ensure_web_target, locked_version};
use crate::shell::{Failure, program_in, run, say};
use std::process::Command;

/// The newest trunk that rustc 1.95 compiles; 0.22 needs 1.96.1.
const TRUNK_VERSION: &str = "0.21.14";

const DEFAULT_PORT: u16 = 8080;

/// The options of `serve`.
#[derive(Debug, PartialEq)]
pub struct ServeOptions {
    port: u16,
    open: bool,
}

impl ServeOptions {
    pub fn parse(words: &[&str]) -> Result<Self, String> {
        let mut options = Self { port: DEFAULT_PORT, open: false };
        let mut words = words.iter();
        while let Some(&word) = words.next() {
            match word {
                "--open" => options.open = true,
                "--port" => {
                    let number = words.next().ok_or("--port needs a number")?;
                    options.port = number.parse().map_err(|_| format!("not a port number: {number}"))?;
                }
                other => return Err(format!("serve does not know {other}")),
            }
        }
        Ok(options)
    }
}

/// Builds the app with the profile `serve` and serves it until interrupted; rebuilds it after changes.
pub fn serve(places: &Places, options: &ServeOptions) -> Result<(), Failure> {
    let mut trunk = trunk(places, "serve")?;
    trunk.args(["--port", &options.port.to_string()]);
    if options.open {
        trunk.arg("--open");
    }
    say(format_args!("the first build takes minutes; then open http://localhost:{}/", options.port));
    run("serving the web app", &mut trunk)
}

/// The maximal download of the first visit, in bytes.
const MOST_TO_DOWNLOAD: usize = 2_900_000;

/// Builds the release app into `dist/`, ready for any host. Fails if the download is too large.
///
/// wasm-opt is not used: after the program was optimized for size (the profile `web`) it takes
/// minutes and saves 0.6 % of the download (measured, -Oz).
pub fn dist(places: &Places) -> Result<(), Failure> {
    run("building the web app", trunk(places, "build")?.arg("--release"))?;
    let (folder, web) = (places.dist(), places.root.join("web"));
    let whole = Package::new(&folder).finish(&web.join("service-worker.js"))?;
    if whole > MOST_TO_DOWNLOAD {
        let excess = format!("{whole} bytes for the first visit, at most {MOST_TO_DOWNLOAD}");
        return Err(Failure::new("weighing the web app", excess));
    }
    Ok(())
}

/// `trunk <subcommand>` with all tools that it needs on its `PATH`. The page names the cargo profiles: `web` for a
/// release, otherwise `serve`.
fn trunk(places: &Places, subcommand: &str) -> Result<Command, Failure> {
    ensure_web_target()?;
    let bindgen = wasm_bindgen(locked_version(places, "wasm-bindgen")?).ensure(places)?;
    let trunk = trunk_itself().ensure(places)?;
    let mut command = Command::new(program_in(&trunk, "trunk"));
    command.env("PATH", path_with(&[trunk, bindgen])?).current_dir(&places.root);
    command.args([subcommand, "--locked", "--skip-version-check"]);
    // trunk reads NO_COLOR as a boolean and fails for the usual `NO_COLOR=1`
    command.env_remove("NO_COLOR");
    Ok(command)
}

/// trunk without its default features, which download tools and check for updates; so it needs no TLS.
fn trunk_itself() -> CargoTool {
    CargoTool {
        program: "trunk",
        version: TRUNK_VERSION.to_owned(),
        source: Source::Registry { package: "trunk", arguments: &["--no-default-features"] },
        optimization: Optimization::None,
        purpose: "which builds and serves the web app",
    }
}

/// Built from xtask: the published program takes twice as long to compile, since it includes a test runner.
fn wasm_bindgen(version: String) -> CargoTool {
    CargoTool {
        program: "wasm-bindgen",
        version,
        source: Source::Xtask { source: "xtask/src/wasm_bindgen.rs" },
        optimization: Optimization::Basic,
        purpose: "which writes the JavaScript around the compiled app",
    }
}

#[cfg(test)]
mod tests {
    use super::ServeOptions;

    #[test]
    fn serve_takes_a_port_and_open() {
        assert_eq!(ServeOptions::parse(&["--port", "9000", "--open"]), Ok(ServeOptions { port: 9000, open: true }));
        assert_eq!(ServeOptions::parse(&[]), Ok(ServeOptions { port: 8080, open: false }));
    }

    #[test]
    fn serve_names_what_it_does_not_understand() {
        assert_eq!(ServeOptions::parse(&["--port", "eighty"]), Err("not a port number: eighty".to_owned()));
        assert_eq!(ServeOptions::parse(&["--prot"]), Err("serve does not know --prot".to_owned()));
    }
}
