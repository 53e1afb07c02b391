//! The rows of a table, and what separates their fields.

use csv_core::{ReadFieldResult, Reader, ReaderBuilder};

use crate::outline::OutlineError;

/// What separates the fields of a row.
#[derive(Debug, Clone, Copy)]
enum Separator {
    /// One character, with fields in quotes, and with decimal commas unless it is a comma itself.
    Character(u8),
    /// Blanks, commas and semicolons, in one file as in several.
    Any,
}

/// In the order in which one is preferred that understands as many rows as another.
const SEPARATORS: [Separator; 4] =
    [Separator::Character(b';'), Separator::Character(b'\t'), Separator::Character(b','), Separator::Any];

/// A field, and its column in its line, from 1.
#[derive(Debug, Clone)]
pub(super) struct Field {
    column: usize,
    text: String,
}

/// A line with something in it.
#[derive(Debug, Clone)]
pub(super) struct Row<'a> {
    /// The number of the line, from 1.
    pub line: usize,
    /// Whether a line with `>` stands between it and the row before it.
    pub begins_part: bool,
    pub fields: Vec<Field>,
    /// Whether some fields are separated otherwise than others, as in "0,5 1,5" and "0,5, 1,5": more than two of them may be
    /// two numbers with decimal commas.
    pub is_mixed: bool,
    content: &'a str,
    has_decimal_commas: bool,
}

/// The rows, divided as most of them are understood.
pub(super) fn rows(text: &str) -> Vec<Row<'_>> {
    let lines = lines(text);
    let divided = |separator: Separator| -> Vec<Row<'_>> {
        let mut reader = Divider::new(separator);
        lines.iter().map(|&(line, begins_part, content)| reader.row(line, begins_part, content)).collect()
    };
    let mut best: (usize, Vec<Row<'_>>) = (0, Vec::new());
    for separator in SEPARATORS {
        let rows = divided(separator);
        let understood = rows.iter().filter(|row| row.fields.len() >= 2 && row.is_numeric()).count();
        if best.1.is_empty() || understood > best.0 {
            best = (understood, rows);
        }
    }
    // with nothing understood, the fields are those between blanks
    if best.0 == 0 { divided(Separator::Any) } else { best.1 }
}

/// The lines that are neither empty nor comments: number, whether it begins a part, content.
fn lines(text: &str) -> Vec<(usize, bool, &str)> {
    let mut begins_part = false;
    let mut lines = Vec::new();
    for (line, number) in text.lines().zip(1..) {
        let content = line.split('#').next().unwrap_or_default();
        // spreadsheets write empty rows as separators alone
        match content.trim_start_matches(|c: char| c.is_whitespace() || c == ',' || c == ';').chars().next() {
            None | Some('%') => {}
            Some('>') => begins_part = true,
            Some(_) => lines.push((number, std::mem::take(&mut begins_part), content)),
        }
    }
    lines
}

/// Divides lines into fields.
struct Divider {
    separator: Separator,
    reader: Reader,
    buffer: Vec<u8>,
}

impl Divider {
    fn new(separator: Separator) -> Self {
        let delimiter = if let Separator::Character(c) = separator { c } else { b',' };
        Self { separator, reader: ReaderBuilder::new().delimiter(delimiter).build(), buffer: Vec::new() }
    }

    fn row<'a>(&mut self, line: usize, begins_part: bool, content: &'a str) -> Row<'a> {
        let mut fields = match self.separator {
            Separator::Character(_) => self.fields(content),
            Separator::Any => between_blanks(content),
        };
        // a separator at the end of a line separates nothing
        if fields.len() > 2 {
            fields.pop_if(|last| last.text.is_empty());
        }
        let has_decimal_commas = matches!(self.separator, Separator::Character(b';' | b'\t'));
        let is_mixed = match self.separator {
            Separator::Any => {
                let [commas, semicolons] = [',', ';'].map(|separator| content.matches(separator).count());
                let separators = commas + semicolons;
                separators > 0 && (separators + 1 != fields.len() || commas.min(semicolons) > 0)
            }
            Separator::Character(b',') => {
                let [all, before_blanks] = [",", ", "].map(|separator| content.matches(separator).count());
                before_blanks > 0 && before_blanks < all
            }
            Separator::Character(_) => false,
        };
        Row { line, begins_part, fields, is_mixed, content, has_decimal_commas }
    }

    fn fields(&mut self, content: &str) -> Vec<Field> {
        let line = format!("{content}\n");
        self.reader.reset();
        self.buffer.resize(line.len(), 0);
        let mut fields = Vec::new();
        let (mut start, mut before) = (0, 0);
        loop {
            let (result, read, written) = self.reader.read_field(&line.as_bytes()[start..], &mut self.buffer);
            let field = &line[start..start + read];
            let blanks = field.chars().take_while(|&c| c == ' ').count();
            let column = before + blanks + 1;
            before += field.chars().count();
            let text = String::from_utf8_lossy(&self.buffer[..written]);
            fields.push(Field { column, text: text.trim().trim_matches(['"', '\'']).trim().to_owned() });
            start += read;
            // a quote that is not closed goes to the end
            if !matches!(result, ReadFieldResult::Field { record_end: false }) {
                return fields;
            }
        }
    }
}

/// The fields between blanks, commas and semicolons; empty ones where a comma or semicolon has none before or after it.
fn between_blanks(content: &str) -> Vec<Field> {
    let mut fields: Vec<Field> = Vec::new();
    // whether a separator was read and its next field is still missing
    let mut open = true;
    let mut start = None;
    let empty = |column| Field { column, text: String::new() };
    let columns = content.char_indices().chain([(content.len(), ' ')]);
    for ((offset, c), column) in columns.zip(1..) {
        let separates = c.is_whitespace() || c == ',' || c == ';';
        match start {
            None if !separates => start = Some((offset, column)),
            Some((from, at)) if separates => {
                fields.push(Field { column: at, text: content[from..offset].trim_matches(['"', '\'']).to_owned() });
                (start, open) = (None, false);
            }
            _ => {}
        }
        if c == ',' || c == ';' {
            if open {
                fields.push(empty(column));
            }
            open = true;
        }
    }
    if open {
        fields.push(empty(content.chars().count() + 1));
    }
    fields
}

impl Row<'_> {
    /// Whether all fields are numbers, of which there are at least two or which is a whole one, as a count is.
    pub fn is_numeric(&self) -> bool {
        let whole = || self.single().is_some_and(|count| count.fract() == 0.0);
        self.fields.iter().all(|field| self.value(field).is_some()) && (self.fields.len() >= 2 || whole())
    }

    /// The number that stands alone.
    pub fn single(&self) -> Option<f64> {
        if let [field] = &*self.fields { self.value(field) } else { None }
    }

    /// Whether it is text, which says something about the table: its first field is no number and does not begin as one.
    fn is_remark(&self) -> bool {
        let begins_number = |text: &str| text.starts_with(|c: char| c.is_ascii_digit() || "+-.−".contains(c));
        let is_text = |field: &Field| !field.text.is_empty() && self.value(field).is_none();
        self.fields.first().is_some_and(|field| is_text(field) && !begins_number(&field.text))
    }

    /// Whether it is a remark after rows of so many numbers, and not one of them with a fault in its first field.
    pub fn is_remark_after(&self, columns: usize) -> bool {
        let others = self.fields.iter().skip(1).all(|field| self.value(field).is_some());
        self.is_remark() && !(columns >= 2 && self.fields.len() == columns && others)
    }

    /// Whether these are the names of columns 0, 1, … beside an index without one.
    fn counts_columns(&self) -> bool {
        let mut fields = self.fields.iter().zip(0..);
        let is_unnamed = fields.next().is_some_and(|(field, _)| field.text.is_empty());
        is_unnamed && self.fields.len() > 2 && fields.all(|(field, k)| field.text == (k - 1).to_string())
    }

    /// Whether the numbers may be halves of two with decimal commas: four whole ones with nothing but commas between them, of
    /// which the fractions have as many digits as these.
    pub fn halves(&self, digits: &mut Option<usize>) -> bool {
        let is_whole = |field: &Field| {
            !field.text.is_empty() && field.text.trim_start_matches('-').chars().all(|c| c.is_ascii_digit())
        };
        let content = self.content.trim();
        self.fields.len() == 4
            && content.matches(',').count() == 3
            && !content.contains(|c: char| c == ';' || c.is_whitespace())
            && self.fields.iter().all(is_whole)
            && [1, 3].iter().all(|&k| {
                let length = self.fields[k].text.len();
                length > 1 && !self.fields[k].text.starts_with('-') && *digits.get_or_insert(length) == length
            })
    }

    /// Errors: a row before the first one of numbers that is no title but one of these with a fault.
    pub fn check_title(&self) -> Result<(), OutlineError> {
        if self.counts_columns() {
            return Ok(());
        }

        let is_word = |field: &Field| field.text.starts_with(char::is_alphabetic) && self.value(field).is_none();
        if self.is_remark() || self.fields.iter().any(is_word) { Ok(()) } else { self.numbers().map(|_| ()) }
    }

    /// The column whose header is one of `names` before a unit, in any case: "x", "X [mm]", "x(m)".
    pub fn position_of(&self, names: &[&str]) -> Option<usize> {
        let title = |field: &Field| {
            let end = field.text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(field.text.len());
            field.text[..end].to_lowercase()
        };
        self.fields.iter().position(|field| names.contains(&&*title(field)))
    }

    /// The numbers of the fields. Errors: the first field that is none.
    pub fn numbers(&self) -> Result<Vec<f64>, OutlineError> {
        if self.is_remark() && self.fields.len() != 2 {
            let text = self.content.trim().chars().take(40).collect();
            return Err(OutlineError::NotUnderstood { line: self.line, text });
        }
        let value = |field: &Field| {
            let text = self.plain(field);
            number((field.column, &text), self.line)
        };
        self.fields.iter().map(value).collect()
    }

    /// The number in a field, also NaN and infinity.
    fn value(&self, field: &Field) -> Option<f64> {
        self.plain(field).parse().ok()
    }

    /// The text of a field, a decimal comma as a point, and Fortran's exponent "1.5D+02" with an e.
    fn plain(&self, field: &Field) -> String {
        let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
        if let Some((number, exponent)) = field.text.split_once(['d', 'D'])
            && number.parse::<f64>().is_ok()
            && exponent.parse::<i32>().is_ok()
        {
            return format!("{number}e{exponent}");
        }
        match field.text.split_once(',') {
            Some((whole, part))
                if self.has_decimal_commas && digit(whole.chars().last()) && digit(part.chars().next()) =>
            {
                format!("{whole}.{part}")
            }
            _ => field.text.clone(),
        }
    }
}

/// The number in a field, which is given with its column.
pub(in super::super) fn number((column, field): (usize, &str), line: usize) -> Result<f64, OutlineError> {
    match field.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(number) if number.is_nan() => Err(OutlineError::NotANumber { line, column, found: "NaN".to_owned() }),
        Ok(_) => Err(OutlineError::NumberOutOfRange { line, column }),
        Err(_) if field.is_empty() => Err(OutlineError::MissingNumber { line, column }),
        Err(_) => Err(OutlineError::NotANumber { line, column, found: field.chars().take(20).collect() }),
    }
}
