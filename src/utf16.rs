//! Text in UTF-16, as spreadsheets and some editors of Windows write it.

/// The text after a byte-order mark of UTF-16; `None` without one. Units that are no characters become U+FFFD.
pub fn decoded(bytes: &[u8]) -> Option<String> {
    let (of, rest): (fn([u8; 2]) -> u16, _) = match bytes {
        [0xFF, 0xFE, rest @ ..] => (u16::from_le_bytes, rest),
        [0xFE, 0xFF, rest @ ..] => (u16::from_be_bytes, rest),
        _ => return None,
    };
    let units: Vec<u16> = rest.as_chunks().0.iter().map(|&unit| of(unit)).collect();
    Some(String::from_utf16_lossy(&units))
}
