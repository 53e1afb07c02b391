//! The table of rooms: which folder of `src` may use which other ones, and the check that the code complies.
//!
//! The check reads the paths `crate::room` and, inside of `src/app`, `crate::app::room` and `super::room`, wherever
//! they appear in code, in `use` lines or elsewhere. It ignores comments and tests: a test may use every room. A row
//! names only rooms of rows above it, so that the table cannot contain a cycle.

use crate::places::Places;
use crate::shell::Failure;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// A room and the rooms that it may use, all from rows above.
type Row = (&'static str, &'static [&'static str]);

/// The rooms of `src`: folders and single files.
const ROOMS: &[Row] = &[
    ("counted", &[]),
    ("utf16", &[]),
    ("geometry", &["counted"]),
    ("exact", &["geometry"]),
    ("boundary_integral", &["counted", "geometry"]),
    ("cauchy_integral", &["geometry"]),
    ("outline", &["counted", "utf16", "geometry", "exact"]),
    ("mesh", &["counted", "geometry"]),
    ("drawing", &["counted", "geometry", "outline"]),
    ("tiling", &["geometry"]),
    ("projection", &["geometry", "mesh"]),
    ("surface", &["counted", "utf16", "geometry", "mesh", "outline"]),
    ("laplace", &["counted", "geometry", "mesh"]),
    ("zipper", &["geometry", "exact", "outline"]),
    (
        "conformal",
        &["counted", "geometry", "outline", "mesh", "boundary_integral", "cauchy_integral", "surface", "laplace"],
    ),
    ("rational", &["geometry", "conformal"]),
    ("optimization", &["geometry", "outline", "mesh", "laplace", "conformal"]),
    (
        "session",
        &["counted", "geometry", "outline", "mesh", "tiling", "surface", "laplace", "conformal", "optimization"],
    ),
    ("closed_form", &["geometry", "exact", "outline", "conformal", "session"]),
    ("family", &["geometry", "mesh", "outline", "conformal"]),
    ("export", &["geometry", "mesh", "outline", "tiling", "projection", "surface", "conformal", "rational"]),
    (
        "figures",
        &[
            "geometry",
            "exact",
            "outline",
            "mesh",
            "boundary_integral",
            "surface",
            "laplace",
            "zipper",
            "conformal",
            "session",
            "closed_form",
        ],
    ),
    (
        "language",
        &[
            "geometry",
            "outline",
            "tiling",
            "mesh",
            "boundary_integral",
            "drawing",
            "surface",
            "laplace",
            "zipper",
            "conformal",
            "projection",
            "rational",
            "optimization",
            "session",
            "figures",
        ],
    ),
    (
        "worker",
        &[
            "language",
            "counted",
            "geometry",
            "outline",
            "mesh",
            "boundary_integral",
            "projection",
            "surface",
            "conformal",
            "rational",
            "session",
            "export",
            "figures",
        ],
    ),
    ("render", &["counted", "geometry", "tiling", "language"]),
    (
        "model",
        &[
            "counted",
            "geometry",
            "outline",
            "tiling",
            "mesh",
            "drawing",
            "surface",
            "laplace",
            "zipper",
            "conformal",
            "rational",
            "optimization",
            "session",
            "closed_form",
            "family",
            "export",
            "figures",
            "language",
            "worker",
            "render",
        ],
    ),
    ("offscreen", &["geometry", "conformal", "family", "export", "language", "render", "model"]),
    ("platform", &["language", "geometry", "conformal", "session", "worker", "model"]),
    (
        "cli",
        &[
            "counted",
            "geometry",
            "boundary_integral",
            "outline",
            "projection",
            "tiling",
            "mesh",
            "surface",
            "laplace",
            "conformal",
            "rational",
            "optimization",
            "session",
            "family",
            "export",
            "figures",
            "worker",
            "render",
            "model",
            "offscreen",
        ],
    ),
    (
        "app",
        &[
            "counted",
            "geometry",
            "outline",
            "tiling",
            "mesh",
            "surface",
            "laplace",
            "conformal",
            "rational",
            "session",
            "closed_form",
            "family",
            "export",
            "figures",
            "language",
            "worker",
            "render",
            "model",
            "offscreen",
            "platform",
        ],
    ),
];

/// The rooms of `src/app`. The files directly in that folder are the room [`APP_ROOT`].
const APP_ROOMS: &[Row] = &[
    ("language", &[]),
    ("theme", &["language"]),
    ("input", &["language", "theme"]),
    ("plots", &["language", "theme", "input"]),
    ("viewport", &["language", "theme", "input", "plots"]),
    ("editing", &["language", "theme", "input", "viewport"]),
    ("overlays", &["language", "theme", "input", "plots", "viewport"]),
    ("status", &["language", "theme", "editing"]),
    ("panels", &["language", "theme", "input", "viewport", "editing", "overlays"]),
    ("menus", &["language", "theme", "input", "panels"]),
    ("windows", &["language", "theme", "input", "plots", "panels", "menus"]),
];

/// The room of the files directly in `src/app`: it may use every other room of the app, and none of them may use it,
/// neither its files nor what `src/app/mod.rs` defines or re-exports.
const APP_ROOT: &str = "app root";

/// The maximal number of files in a folder of `src/app`.
const MOST_FILES: usize = 20;

/// The crates that the model may not use, and the types of `render` that hold or take the GPU's device.
const NOT_IN_MODEL: [&str; 9] =
    ["egui", "eframe", "egui_wgpu", "wgpu", "Graphics", "Readback", "SceneRenderer", "Studio", "ViewportRenderer"];

/// Fails and lists every use that the tables do not allow.
pub fn check(places: &Places) -> Result<(), Failure> {
    let src = places.root.join("src");
    let mut wrong = Vec::new();
    for file in rust_files(&src)? {
        let relative = file.strip_prefix(&src).unwrap_or(&file);
        let names: Vec<String> = relative.iter().map(|part| part.to_string_lossy().replace(".rs", "")).collect();
        if names.iter().any(|name| name == "tests" || name.ends_with("_tests") || name.starts_with("test_")) {
            continue;
        }
        let text =
            fs::read_to_string(&file).map_err(|error| Failure::new(file.display().to_string(), error.to_string()))?;
        let code = code_of(&text);
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        wrong.extend(wrong_arrows(&names, &code).into_iter().map(|what| format!("src/{}: {what}", relative.display())));
    }
    wrong.extend(crowded(&src.join("app"))?);
    if wrong.is_empty() { Ok(()) } else { Err(Failure::new("rooms", format!("\n  {}", wrong.join("\n  ")))) }
}

/// The violations in a file, given the parts of its path.
fn wrong_arrows(names: &[&str], code: &str) -> Vec<String> {
    let mut wrong = Vec::new();
    let Some(&room) = names.first() else { return wrong };
    if let Some((_, allowed)) = ROOMS.iter().find(|(name, _)| *name == room) {
        let used = named_after(code, "crate::");
        wrong.extend(others(&used, room, allowed, ROOMS).map(|other| format!("{room} may not use {other}")));
    } else if !matches!(room, "lib" | "bin") {
        wrong.push(format!("the room {room} is not in the table of xtask/src/rooms.rs"));
    }
    if room == "model" {
        let mentioned = words(code);
        let foreign = NOT_IN_MODEL.iter().filter(|name| mentioned.contains(**name));
        wrong.extend(foreign.map(|name| format!("the model may not name {name}")));
    }
    if let ["app", inner, rest @ ..] = names
        && !rest.is_empty()
    {
        let Some((_, allowed)) = APP_ROOMS.iter().find(|(name, _)| name == inner) else {
            wrong.push(format!("the room app/{inner} is not in the table of xtask/src/rooms.rs"));
            return wrong;
        };
        let mut used = named_after(code, "crate::app::");
        // the number of folders between this file and the app
        let steps = names.len() - 1 - usize::from(names.last() == Some(&"mod"));
        used.extend(named_after(code, &"super::".repeat(steps)));
        wrong.extend(
            others(&used, inner, allowed, APP_ROOMS).map(|other| format!("app/{inner} may not use app/{other}")),
        );
        // what is no room is a file of the root or an item that the root defines
        let of_root = used.iter().filter(|name| APP_ROOMS.iter().all(|(room, _)| room != name));
        wrong.extend(of_root.map(|name| format!("app/{inner} may not use {name} of the {APP_ROOT}")));
    }
    wrong
}

/// The rooms of `table` among `used` that are neither `room` nor `allowed`.
fn others<'a>(
    used: &'a BTreeSet<String>,
    room: &'a str,
    allowed: &'a [&str],
    table: &'a [Row],
) -> impl Iterator<Item = &'a String> {
    used.iter()
        .filter(move |name| table.iter().any(|(known, _)| known == name))
        .filter(move |name| *name != room && !allowed.contains(&name.as_str()))
}

/// The names that follow `prefix` in code, also in braces: for `crate::{a::B, c}` both `a` and `c`.
fn named_after(code: &str, prefix: &str) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for (at, _) in code.match_indices(prefix) {
        if code[..at].ends_with(|before: char| before.is_alphanumeric() || before == '_' || before == ':') {
            continue; // part of a longer path
        }
        let rest = &code[at + prefix.len()..];
        match rest.strip_prefix('{') {
            Some(list) => names.extend(first_names(list)),
            None => names.extend(identifier(rest)),
        }
    }
    names
}

/// The first names of the entries of a list, up to its closing brace.
fn first_names(list: &str) -> Vec<String> {
    let (mut depth, mut begins, mut names) = (0_u32, true, Vec::new());
    for (at, character) in list.char_indices() {
        match character {
            '{' => depth += 1,
            '}' if depth == 0 => break,
            '}' => depth -= 1,
            ',' if depth == 0 => begins = true,
            _ if begins && !character.is_whitespace() => {
                names.extend(identifier(&list[at..]));
                begins = false;
            }
            _ => {}
        }
    }
    names
}

fn identifier(text: &str) -> Option<String> {
    let end = text.find(|character: char| !(character.is_alphanumeric() || character == '_')).unwrap_or(text.len());
    (end > 0).then(|| text[..end].to_owned())
}

fn words(code: &str) -> BTreeSet<&str> {
    code.split(|character: char| !(character.is_alphanumeric() || character == '_')).collect()
}

/// The code of a file up to its tests, without whole-line comments.
fn code_of(text: &str) -> String {
    let is_of_tests = |line: &&str| line.starts_with("mod tests {") || line.starts_with("pub(crate) mod tests {");
    let code = text.lines().take_while(|line| !is_of_tests(line)).filter(|line| !line.trim_start().starts_with("//"));
    code.collect::<Vec<_>>().join("\n")
}

/// The folders of the app that contain too many files.
fn crowded(folder: &Path) -> Result<Vec<String>, Failure> {
    let (mut crowded, mut count) = (Vec::new(), 0);
    for entry in entries(folder)? {
        if entry.is_dir() {
            crowded.extend(self::crowded(&entry)?);
        } else {
            count += usize::from(entry.extension().is_some_and(|ending| ending == "rs"));
        }
    }
    if count > MOST_FILES {
        crowded.push(format!("{}: {count} files, more than {MOST_FILES}", folder.display()));
    }
    Ok(crowded)
}

/// All Rust files in a folder and its folders.
pub fn rust_files(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let mut files = Vec::new();
    for entry in entries(folder)? {
        if entry.is_dir() {
            files.extend(rust_files(&entry)?);
        } else if entry.extension().is_some_and(|ending| ending == "rs") {
            files.push(entry);
        }
    }
    Ok(files)
}

/// The entries of a folder, sorted by name.
fn entries(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let failed = |error: std::io::Error| Failure::new(folder.display().to_string(), error.to_string());
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder).map_err(failed)? {
        paths.push(entry.map_err(failed)?.path());
    }
    paths.sort();
    Ok(paths)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tables_have_no_circle() {
        for table in [ROOMS, APP_ROOMS] {
            for (k, (room, allowed)) in table.iter().enumerate() {
                for other in *allowed {
                    assert!(
                        table[..k].iter().any(|(above, _)| above == other),
                        "{room} uses {other}, which is not above it"
                    );
                }
            }
        }
    }

    #[test]
    fn arrows_are_found_in_use_lines_in_braces_and_in_code() {
        let code = "use crate::{app::RiemapApp, geometry};\nlet x = crate::cli::run();\nuse other_crate::app::X;";
        let found = wrong_arrows(&["model", "mod"], code);
        assert_eq!(found, ["model may not use app", "model may not use cli"]);
        assert!(wrong_arrows(&["model", "mod"], "use crate::worker::Request;").is_empty());
        assert_eq!(wrong_arrows(&["model", "mod"], "fn f(x: egui::Ui) {}"), ["the model may not name egui"]);
    }

    #[test]
    fn rooms_of_the_app_may_not_know_what_stands_above_them() {
        let code = "use super::super::panels::header;\nuse crate::app::theme;\nuse super::menus;";
        assert_eq!(wrong_arrows(&["app", "theme", "widgets"], code), ["app/theme may not use app/panels"]);
        let whole = wrong_arrows(&["app", "menus", "top_bar"], "use crate::app::RiemapApp;");
        assert_eq!(whole, ["app/menus may not use RiemapApp of the app root"]);
        let constant = wrong_arrows(&["app", "panels", "shapes"], "fn f() -> bool { 1.0 < crate::app::PHONE_WIDTH }");
        assert_eq!(constant, ["app/panels may not use PHONE_WIDTH of the app root"]);
        let relative = wrong_arrows(&["app", "panels", "mod"], "use super::{messages, theme};");
        assert_eq!(relative, ["app/panels may not use messages of the app root"]);
        assert!(wrong_arrows(&["app", "frame"], "use super::menus::top_bar;").is_empty());
        assert_eq!(wrong_arrows(&["app", "attic", "mod"], "").len(), 1, "a room that is not in the table");
    }

    #[test]
    fn comments_and_tests_are_not_read() {
        let text = "// crate::app\n/// crate::app\nfn f() {}\n#[cfg(test)]\nmod tests {\n    use crate::app::X;\n}\n";
        assert!(wrong_arrows(&["geometry", "mod"], &code_of(text)).is_empty());
    }
}
