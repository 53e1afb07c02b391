//! The limit on the number of fields of a struct.
//!
//! The check reads the text of each file in `src` and `xtask/src`, formatted by rustfmt, without comments and
//! attributes. It counts the fields of structs with named fields, and those of tuple structs.

use crate::places::Places;
use crate::rooms::rust_files;
use crate::shell::Failure;
use std::fs;

/// A struct with more fields is divided into types with invariants of their own.
const MOST_FIELDS: usize = 15;

/// Fails and lists every struct with more than [`MOST_FIELDS`] fields.
pub fn check(places: &Places) -> Result<(), Failure> {
    let mut wrong = Vec::new();
    for folder in ["src", "xtask/src"] {
        for file in rust_files(&places.root.join(folder))? {
            let text = fs::read_to_string(&file)
                .map_err(|error| Failure::new(file.display().to_string(), error.to_string()))?;
            let large = structs(&text).into_iter().filter(|(_, fields)| *fields > MOST_FIELDS);
            let shown = file.strip_prefix(&places.root).unwrap_or(&file).display();
            wrong.extend(large.map(|(name, fields)| format!("{shown}: {name} has {fields} fields")));
        }
    }
    if wrong.is_empty() {
        return Ok(());
    }
    Err(Failure::new("fields", format!("more than {MOST_FIELDS} fields\n  {}", wrong.join("\n  "))))
}

/// The structs of a file: their names and the numbers of their fields.
fn structs(text: &str) -> Vec<(String, usize)> {
    let code = without_attributes(&without_comments(text));
    let mut found = Vec::new();
    for (k, line) in code.lines().enumerate() {
        if let Some(name) = name_of_struct(line) {
            let declaration = code.lines().skip(k).collect::<Vec<_>>().join("\n");
            let after_name = declaration.split_once("struct ").map_or("", |(_, after)| after);
            found.push((name, fields(after_name)));
        }
    }
    found
}

/// The name of the struct whose declaration begins on this line.
fn name_of_struct(line: &str) -> Option<String> {
    let line = line.trim_start();
    let line = match line.strip_prefix("pub") {
        Some(visible) if visible.starts_with('(') => visible.split_once(')')?.1,
        Some(visible) => visible,
        None => line,
    };
    let name: String =
        line.trim_start().strip_prefix("struct ")?.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
    (!name.is_empty()).then_some(name)
}

/// The number of fields of a struct whose name `declaration` begins with: those in the first braces, or in the first
/// parentheses outside of generics and bounds.
fn fields(declaration: &str) -> usize {
    let (mut depth, mut before) = (0_i32, ' ');
    for (at, character) in declaration.char_indices() {
        match character {
            ';' if depth == 0 => return 0,
            '{' => return entries(&declaration[at + 1..]),
            '(' if depth == 0 && !declaration[..at].contains("where") => return entries(&declaration[at + 1..]),
            '<' | '(' | '[' => depth += 1,
            '>' if before == '-' => {}
            '>' | ')' | ']' => depth -= 1,
            _ => {}
        }
        before = character;
    }
    0
}

/// The number of entries of a list separated by commas, up to its closing bracket.
fn entries(list: &str) -> usize {
    let (mut depth, mut count, mut is_empty, mut before) = (0_i32, 0, true, ' ');
    for character in list.chars() {
        match character {
            '}' | ')' if depth == 0 => break,
            ',' if depth == 0 => is_empty = true,
            '<' | '(' | '[' | '{' => depth += 1,
            '>' if before == '-' => {}
            '>' | ')' | ']' | '}' => depth -= 1,
            _ => {}
        }
        if is_empty && character != ',' && !character.is_whitespace() {
            is_empty = false;
            count += 1;
        }
        before = character;
    }
    count
}

/// Without comments up to the end of a line that follow nothing or a space.
fn without_comments(text: &str) -> String {
    let code = text.lines().map(|line| match line.find("//") {
        Some(at) if line[..at].trim_end().len() < at || at == 0 => &line[..at],
        _ => line,
    });
    code.collect::<Vec<_>>().join("\n")
}

/// Without `#[…]` and `#![…]`, whose text may contain commas and brackets, also in string literals.
fn without_attributes(code: &str) -> String {
    let (mut kept, mut rest) = (String::new(), code);
    while let Some(at) = rest.find('#') {
        kept.push_str(&rest[..at]);
        let after = rest[at + 1..].strip_prefix('!').unwrap_or(&rest[at + 1..]);
        let Some(attribute) = after.strip_prefix('[') else {
            kept.push('#');
            rest = &rest[at + 1..];
            continue;
        };
        rest = attribute.get(end_of_attribute(attribute)..).unwrap_or_default();
    }
    kept + rest
}

/// The position after the bracket that closes an attribute.
fn end_of_attribute(attribute: &str) -> usize {
    let (mut depth, mut is_text, mut is_escaped) = (0_u32, false, false);
    for (at, character) in attribute.char_indices() {
        match character {
            _ if is_escaped => is_escaped = false,
            '\\' if is_text => is_escaped = true,
            '"' => is_text = !is_text,
            _ if is_text => {}
            '[' => depth += 1,
            ']' if depth == 0 => return at + 1,
            ']' => depth -= 1,
            _ => {}
        }
    }
    attribute.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counted(text: &str) -> Vec<usize> {
        structs(text).into_iter().map(|(_, fields)| fields).collect()
    }

    #[test]
    fn fields_are_counted_with_their_types_comments_and_attributes() {
        let text = "/// A, b, c\n#[derive(A, B)]\npub(super) struct X<'a, T: Fn(u8, u8) -> u8> {\n    \
                    #[serde(rename = \"a,]b\", default)]\n    /// one, two\n    pub a: HashMap<u32, (u8, u8)>,\n    \
                    // c: u8,\n    b: Box<dyn Fn(u8, u8) -> u8>, // not, here\n    c: &'a [T; 3],\n}\n";
        assert_eq!(structs(text), [("X".to_owned(), 3)]);
    }

    #[test]
    fn every_form_of_a_struct_is_read() {
        assert_eq!(
            counted("struct A;\nstruct B {}\npub struct C(u8, pub (u8, u8));\nstruct D { a: u8, b: u8 }"),
            [0, 0, 2, 2]
        );
        assert_eq!(counted("struct E<F>\nwhere\n    F: Fn(u8, u8),\n{\n    f: F,\n}"), [1]);
        assert!(structs("// struct A {\nlet structure = 1;\nuse x::structs;").is_empty());
    }

    #[test]
    fn a_struct_of_sixteen_fields_is_found() {
        let of = |count: usize| format!("struct A {{\n{}}}\n", "    field: u8,\n".repeat(count));
        assert_eq!(counted(&of(MOST_FIELDS)), [MOST_FIELDS]);
        assert_eq!(counted(&of(MOST_FIELDS + 1)), [MOST_FIELDS + 1]);
    }
}
