//! Finds the string literals in the program's sources and the code around them; for tests.

use std::path::Path;

/// A string literal outside of comments and tests.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Literal {
    /// The path of the file, starting with `src`.
    pub file: String,
    /// The code between the last `;`, `{` or `}` and the literal, without other literals.
    pub before: String,
    /// The value of the literal, with escapes resolved.
    pub text: String,
}

/// All literals of the program, file by file.
pub fn literals() -> Vec<Literal> {
    let mut found = Vec::new();
    read_folder(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), "src", &mut found);
    found
}

fn read_folder(folder: &Path, name: &str, found: &mut Vec<Literal>) {
    let mut entries: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    for path in entries {
        let own = path.file_name().unwrap().to_str().unwrap();
        let file = format!("{name}/{own}");
        if path.is_dir() && own.ends_with("tests") {
            // texts in tests are never shown
        } else if path.is_dir() {
            read_folder(&path, &file, found);
        } else if path.extension().is_some_and(|extension| extension == "rs")
            && !own.ends_with("tests.rs")
            && own != "literals.rs"
        {
            let source = std::fs::read_to_string(&path).unwrap();
            read_source(without_tests(&source), &file, found);
        }
    }
}

/// The source without its test modules, which are at the end of a file.
fn without_tests(source: &str) -> &str {
    let is_module = |at: &usize| {
        let mut lines = source[*at..].lines().skip(1).skip_while(|line| line.starts_with("#["));
        lines.next().is_some_and(|line| line.contains("mod ") && line.ends_with('{'))
    };
    let tests = source.match_indices("#[cfg(test)]\n").map(|(at, _)| at).find(is_module);
    &source[..tests.unwrap_or(source.len())]
}

fn read_source(source: &str, file: &str, found: &mut Vec<Literal>) {
    let (mut before, mut rest) = (String::new(), source);
    while let Some(letter) = rest.chars().next() {
        if rest.starts_with("//") {
            rest = rest.find('\n').map_or("", |end| &rest[end..]);
        } else if let Some((text, after)) = raw_text(rest, &before).or_else(|| text(rest)) {
            found.push(Literal { file: file.into(), before: before.clone(), text });
            before.push_str("\"\"");
            rest = after;
        } else if let Some(after) = character(rest) {
            rest = after;
        } else {
            match letter {
                ';' | '{' | '}' => before.clear(),
                _ if letter.is_whitespace() && before.ends_with(' ') => {}
                _ => before.push(if letter.is_whitespace() { ' ' } else { letter }),
            }
            rest = &rest[letter.len_utf8()..];
        }
    }
}

/// Parses a literal `"…"` at the start; returns its value and the rest.
fn text(rest: &str) -> Option<(String, &str)> {
    let mut rest = rest.strip_prefix('"')?;
    let mut text = String::new();
    loop {
        let letter = rest.chars().next()?;
        rest = &rest[letter.len_utf8()..];
        match letter {
            '"' => return Some((text, rest)),
            '\\' => rest = escape(rest, &mut text)?,
            _ => text.push(letter),
        }
    }
}

/// Parses what follows a backslash.
fn escape<'a>(rest: &'a str, text: &mut String) -> Option<&'a str> {
    if let Some(code) = rest.strip_prefix("u{") {
        let (digits, after) = code.split_once('}')?;
        text.push(char::from_u32(u32::from_str_radix(digits, 16).ok()?)?);
        return Some(after);
    }
    if rest.starts_with('\n') {
        return Some(rest.trim_start());
    }
    let letter = rest.chars().next()?;
    text.push(match letter {
        'n' => '\n',
        't' => '\t',
        'r' => '\r',
        other => other,
    });
    Some(&rest[letter.len_utf8()..])
}

/// Parses a raw literal `r"…"` or `r#"…"#` at the start; returns its value and the rest.
fn raw_text<'a>(rest: &'a str, before: &str) -> Option<(String, &'a str)> {
    let after = rest.strip_prefix('r').filter(|_| !before.ends_with(|c: char| c.is_alphanumeric() || c == '_'))?;
    let hashes = after.len() - after.trim_start_matches('#').len();
    let (text, after) = after[hashes..].strip_prefix('"')?.split_once(&format!("\"{}", "#".repeat(hashes)))?;
    Some((text.into(), after))
}

/// The rest after a character literal `'x'` or `'\n'` at the start; `None` for a lifetime.
fn character(rest: &str) -> Option<&str> {
    let inner = rest.strip_prefix('\'')?;
    let length = match inner.strip_prefix('\\') {
        Some(escaped) => 1 + escaped.chars().next()?.len_utf8() + escaped[1..].find('\'')?,
        None => inner.chars().next()?.len_utf8(),
    };
    inner.get(length..)?.strip_prefix('\'')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(source: &str) -> Vec<Literal> {
        let mut found = Vec::new();
        read_source(without_tests(source), "src/a.rs", &mut found);
        found
    }

    #[test]
    fn texts_are_found_outside_of_comments_and_tests() {
        let source = "// \"no\"\nfn a<'a>() { let c = ['\"', '\\'', '\\u{b9}']; say(\"yes, \\\n    \\\"\\u{b9}\\\"\", r#\"a\"b\"#); }\n\
                      #[cfg(test)]\nuse b;\n#[cfg(test)]\n#[allow(x)]\nmod tests {\n    \"no\"\n}\n";
        let found = read(source);
        let texts: Vec<&str> = found.iter().map(|literal| literal.text.as_str()).collect();
        assert_eq!(texts, ["yes, \"¹\"", "a\"b"]);
        assert_eq!([&found[0].before, &found[1].before], [" say(", " say(\"\", "]);
    }
}
