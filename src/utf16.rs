//! Text in UTF-16, as spreadsheets and some editors of Windows write it.

/// The text in UTF-16: after its byte-order mark, or without one where every second one of the first bytes is 0, as in Latin
/// letters and digits; `None` for others. Units that are no characters become U+FFFD.
pub fn decoded(bytes: &[u8]) -> Option<String> {
    let (of, rest): (fn([u8; 2]) -> u16, _) = match bytes {
        [0xFF, 0xFE, rest @ ..] => (u16::from_le_bytes, rest),
        [0xFE, 0xFF, rest @ ..] => (u16::from_be_bytes, rest),
        _ if begins_with(bytes, |[low, high]| low != 0 && high == 0) => (u16::from_le_bytes, bytes),
        _ if begins_with(bytes, |[high, low]| low != 0 && high == 0) => (u16::from_be_bytes, bytes),
        _ => return None,
    };
    let units: Vec<u16> = rest.as_chunks().0.iter().map(|&unit| of(unit)).collect();
    Some(String::from_utf16_lossy(&units))
}

/// Whether the first units of a text are all like this.
fn begins_with(bytes: &[u8], is_like: impl Fn([u8; 2]) -> bool) -> bool {
    let first = bytes.as_chunks().0.get(..4);
    first.is_some_and(|first| first.iter().all(|&unit| is_like(unit)))
}
