//! `wasm-bindgen` as called by trunk: writes a compiled program for a page, and its JavaScript.
//!
//! Accepts `--target=web --out-dir=FOLDER --out-name=NAME FILE` and `--no-typescript`, in any order, and
//! `--version`. Everything else is an error, so that an option of trunk's that is unknown here is not ignored.

use std::process::ExitCode;
use wasm_bindgen_cli_support::Bindgen;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let outcome = match words.as_slice() {
        ["--version"] => {
            println!("wasm-bindgen {}", wasm_bindgen_shared::version());
            Ok(())
        }
        words => Call::parse(words).and_then(|call| call.generate()),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("wasm-bindgen: {message}");
            ExitCode::FAILURE
        }
    }
}

/// The parsed arguments.
#[derive(Debug, PartialEq)]
struct Call<'a> {
    program: &'a str,
    folder: &'a str,
    name: &'a str,
}

impl<'a> Call<'a> {
    fn parse(words: &[&'a str]) -> Result<Self, String> {
        let [mut program, mut folder, mut name] = [None; 3];
        for &word in words {
            match word.split_once('=') {
                Some(("--out-dir", value)) => folder = Some(value),
                Some(("--out-name", value)) => name = Some(value),
                _ if word == "--target=web" || word == "--no-typescript" => (),
                _ if word.starts_with('-') || program.is_some() => return Err(format!("not known here: {word}")),
                _ => program = Some(word),
            }
        }
        let missing = |what: &str| format!("{what} is missing");
        Ok(Self {
            program: program.ok_or_else(|| missing("the compiled program"))?,
            folder: folder.ok_or_else(|| missing("--out-dir"))?,
            name: name.ok_or_else(|| missing("--out-name"))?,
        })
    }

    fn generate(&self) -> Result<(), String> {
        let mut bindgen = Bindgen::new();
        bindgen.web(true).map_err(|error| format!("{error:#}"))?;
        // as the published program does without further options
        bindgen.omit_default_module_path(false);
        bindgen.input_path(self.program).out_name(self.name).typescript(false);
        bindgen.generate(self.folder).map_err(|error| format!("{}: {error:#}", self.program))
    }
}

#[cfg(test)]
mod tests {
    use super::Call;

    #[test]
    fn trunks_call_is_understood() {
        let words = ["--target=web", "--out-dir=out", "--out-name=riemap", "a=b/riemap.wasm", "--no-typescript"];
        let call = Call { program: "a=b/riemap.wasm", folder: "out", name: "riemap" };
        assert_eq!(Call::parse(&words), Ok(call));
    }

    #[test]
    fn an_option_that_is_not_known_is_refused() {
        let refused = |word| Call::parse(&["riemap.wasm", "--out-dir=out", "--out-name=riemap", word]);
        assert_eq!(refused("--keep-debug"), Err(String::from("not known here: --keep-debug")));
        assert_eq!(refused("--target=nodejs"), Err(String::from("not known here: --target=nodejs")));
        assert_eq!(refused("another.wasm"), Err(String::from("not known here: another.wasm")));
        assert_eq!(
            Call::parse(&["--out-dir=out", "--out-name=a"]),
            Err(String::from("the compiled program is missing"))
        );
    }
}
