//! The text encoding of a link: deflate with a checksum (RFC 1951 in RFC 1950), then base 64 for URLs
//! (RFC 4648, section 5) without padding.
//!
//! The checksum takes 8 characters. Without it, 2 % of the links with a wrong character decoded to another session.
//!
//! Guarantees: unpacking any input takes time and memory in proportion to the limits here.
//! Not guaranteed: that packing gives the same text in every version of the program.

use super::{LinkError, MAX_LENGTH};
use base64::Engine as _;
use base64::prelude::BASE64_URL_SAFE_NO_PAD;
use miniz_oxide::deflate::compress_to_vec_zlib;
use miniz_oxide::inflate::{TINFLStatus, decompress_to_vec_zlib_with_limit};

/// The largest input of deflate: no link short enough to be sent needs 100,000 bytes, and the steps of 16,000 points
/// need half of this limit.
pub(super) const MAX_BYTES: usize = 64 << 10;

/// Deflate's highest level whose search time is bounded.
const LEVEL: u8 = 9;

/// Encodes `bytes`; `None` if there are more than [`MAX_BYTES`].
pub(in crate::session) fn pack(bytes: &[u8]) -> Option<String> {
    (bytes.len() <= MAX_BYTES).then(|| BASE64_URL_SAFE_NO_PAD.encode(compress_to_vec_zlib(bytes, LEVEL)))
}

/// Decodes a text. Errors: too long, not base 64, not deflated, or more than [`MAX_BYTES`].
pub(in crate::session) fn unpack(text: &str) -> Result<Vec<u8>, LinkError> {
    if text.len() > MAX_LENGTH {
        return Err(LinkError::TooLong { length: text.len() });
    }
    let deflated = BASE64_URL_SAFE_NO_PAD.decode(text).map_err(|_| LinkError::Damaged)?;
    decompress_to_vec_zlib_with_limit(&deflated, MAX_BYTES).map_err(|error| match error.status {
        TINFLStatus::HasMoreOutput => LinkError::TooMuch,
        _ => LinkError::Damaged,
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn unpacking_inverts_packing() {
        for bytes in [&b""[..], b"a", &[0; 1000], &vec![255; MAX_BYTES]] {
            assert_eq!(unpack(&pack(bytes).unwrap()).as_deref(), Ok(bytes));
        }
        assert_eq!(pack(&vec![0; MAX_BYTES + 1]), None);
    }

    /// Both special characters of RFC 4648's alphabet for URLs; RFC 1950's header, RFC 1951's empty block of fixed
    /// codes, and the checksum of no bytes, 1.
    #[test]
    fn the_encoding_follows_the_rfcs() {
        assert_eq!(BASE64_URL_SAFE_NO_PAD.encode([0xfb, 0xff, 0xbf]), "-_-_");
        assert_eq!(unpack("eJwDAAAAAAE"), Ok(Vec::new()), "78 9c, 03 00, 00 00 00 01");
    }

    #[test]
    fn damaged_and_hostile_texts_are_refused() {
        let packed = pack(b"the quick brown fox jumps over the lazy dog").unwrap();
        assert_eq!(unpack(&packed[..packed.len() - 8]), Err(LinkError::Damaged), "cut off");
        assert_eq!(unpack("not base 64"), Err(LinkError::Damaged));
        assert_eq!(unpack("____"), Err(LinkError::Damaged), "block type 3 does not exist");
        let bomb = BASE64_URL_SAFE_NO_PAD.encode(compress_to_vec_zlib(&vec![0; 4 << 20], LEVEL));
        assert!(bomb.len() <= MAX_LENGTH, "{} characters", bomb.len());
        assert_eq!(unpack(&bomb), Err(LinkError::TooMuch), "4 MiB of zeros in {} characters", bomb.len());
        assert_eq!(unpack(&"A".repeat(MAX_LENGTH + 1)), Err(LinkError::TooLong { length: MAX_LENGTH + 1 }));
    }
}
