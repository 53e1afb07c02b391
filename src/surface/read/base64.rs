//! Base 64 (RFC 4648, section 4), as glTF embeds its buffers.

/// The bytes, or the position of the first character that does not belong. `=` may only end the text.
pub(super) fn decode(text: &str) -> Result<Vec<u8>, usize> {
    let body = text.trim_end_matches('=');
    if text.len() - body.len() > 2 || body.len() % 4 == 1 {
        return Err(body.len());
    }
    let mut bytes = Vec::with_capacity(body.len() / 4 * 3 + 2);
    let (mut bits, mut held) = (0_u32, 0);
    for (k, character) in body.bytes().enumerate() {
        bits = bits << 6 | u32::from(value_of(character).ok_or(k)?);
        held += 6;
        if held >= 8 {
            held -= 8;
            bytes.push((bits >> held) as u8);
            bits &= (1 << held) - 1;
        }
    }
    Ok(bytes)
}

fn value_of(character: u8) -> Option<u8> {
    Some(match character {
        b'A'..=b'Z' => character - b'A',
        b'a'..=b'z' => character - b'a' + 26,
        b'0'..=b'9' => character - b'0' + 52,
        b'+' => 62,
        b'/' => 63,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_standard_s_examples() {
        let pairs = [("", ""), ("Zg==", "f"), ("Zm8=", "fo"), ("Zm9v", "foo"), ("Zm9vYmFy", "foobar"), ("Zm8", "fo")];
        for (text, expected) in pairs {
            assert_eq!(decode(text), Ok(expected.as_bytes().to_vec()), "{text}");
        }
        assert_eq!(decode("+/+/"), Ok(vec![0xfb, 0xff, 0xbf]));
        assert_eq!(decode("Zm9v!mFy"), Err(4));
        assert_eq!(decode("Zm9vY"), Err(5));
        assert_eq!(decode("Z==="), Err(1));
    }
}
