//! A file of strings in the format of GNU gettext (`.po`): `msgid "…"`, then `msgstr "…"`.
//!
//! Read are comments, texts over several lines and the escapes `\"`, `\\`, `\n`.
//! The file is part of the program, so that what is not well formed is found by
//! a test and not by a person: such lines are passed over here.

use super::template::Template;
use std::collections::HashMap;

/// The texts of one language, by the English ones.
#[derive(Debug, Default)]
pub struct Catalogue {
    texts: HashMap<String, String>,
    /// Those with placeholders that can be recognised, in the order in which they are tried.
    templates: Vec<Template>,
}

impl Catalogue {
    /// Reads a file.
    pub fn parse(file: &str) -> Self {
        let (mut texts, mut key, mut value) = (HashMap::new(), String::new(), String::new());
        let mut in_value = false;
        for line in file.lines().map(str::trim) {
            let (starts, rest) = match (line.strip_prefix("msgid "), line.strip_prefix("msgstr ")) {
                (Some(rest), _) => (Some(false), rest),
                (_, Some(rest)) => (Some(true), rest),
                _ => (None, line),
            };
            if starts == Some(false) && in_value {
                texts.insert(std::mem::take(&mut key), std::mem::take(&mut value));
            }
            in_value = starts.unwrap_or(in_value);
            if let Some(quoted) = rest.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')) {
                let text = if in_value { &mut value } else { &mut key };
                text.push_str(&unescaped(quoted));
            }
        }
        texts.insert(key, value);
        texts.retain(|key, value| !key.is_empty() && !value.is_empty());
        let mut templates: Vec<Template> = texts.iter().filter_map(|(key, value)| Template::new(key, value)).collect();
        templates.sort();
        Self { texts, templates }
    }

    /// The texts with placeholders, in the order in which they are tried.
    pub fn templates(&self) -> &[Template] {
        &self.templates
    }

    /// The text for an English one.
    pub fn get(&self, text: &str) -> Option<&str> {
        self.texts.get(text).map(String::as_str)
    }

    /// All pairs, in no order.
    #[cfg(test)]
    pub fn pairs(&self) -> impl Iterator<Item = (&str, &str)> {
        self.texts.iter().map(|(key, value)| (key.as_str(), value.as_str()))
    }
}

fn unescaped(text: &str) -> String {
    let mut result = String::with_capacity(text.len());
    let mut letters = text.chars();
    while let Some(letter) = letters.next() {
        match (letter, letter == '\\') {
            (_, true) => match letters.next() {
                Some('n') => result.push('\n'),
                Some(other) => result.push(other),
                None => {}
            },
            (letter, false) => result.push(letter),
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::Catalogue;

    #[test]
    fn pairs_comments_long_texts_and_escapes_are_read() {
        let file = "# a comment\nmsgid \"\"\nmsgstr \"Language: de\\n\"\n\nmsgid \"Open\"\nmsgstr \"Öffnen\"\n\n\
                    #. note\nmsgid \"\"\n\"two \"\n\"lines\"\nmsgstr \"\"\n\"\\\"zwei\\\"\\n\"\n\"Zeilen\\\\\"\n";
        let catalogue = Catalogue::parse(file);
        assert_eq!(catalogue.get("Open"), Some("Öffnen"));
        assert_eq!(catalogue.get("two lines"), Some("\"zwei\"\nZeilen\\"));
        assert_eq!(catalogue.pairs().count(), 2, "the head is no text");
    }

    #[test]
    fn a_text_that_is_not_translated_yet_has_no_entry() {
        assert_eq!(Catalogue::parse("msgid \"a\"\nmsgstr \"\"\n").get("a"), None);
    }
}
