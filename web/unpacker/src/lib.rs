//! Unpacks the web app's program while it is downloaded: a small program of its own, which the page runs first.
//!
//! Browsers unpack gzip only; LZMA makes the app's program a quarter smaller. The format is that of a `.lzma` file with
//! the unpacked size in its header. A stream that is damaged or ends early is an error, never a shorter program; the
//! format has no checksum (the download's own protects it, and the browser checks the program).

use lzma_rust2::{Action, LzmaStream, Status};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

/// The most memory that a stream may ask for, in KiB: four times the packer's window.
const MEMORY: u32 = 64 << 10;
/// Bytes unpacked in one step.
const STEP: usize = 1 << 16;

/// A stream in the course of being unpacked.
#[wasm_bindgen]
pub struct Unpacker {
    stream: LzmaStream,
}

#[wasm_bindgen]
impl Unpacker {
    /// A stream of which nothing has arrived.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self { stream: LzmaStream::new_mem_limit(MEMORY, None) }
    }

    /// What the next packed bytes give.
    pub fn unpack(&mut self, packed: &[u8]) -> Result<Vec<u8>, JsError> {
        self.advance(packed, Action::Run).map_err(|reason| JsError::new(&reason))
    }

    /// What is left after the last packed bytes.
    pub fn finish(&mut self) -> Result<Vec<u8>, JsError> {
        self.advance(&[], Action::Finish).map_err(|reason| JsError::new(&reason))
    }
}

impl Default for Unpacker {
    fn default() -> Self {
        Self::new()
    }
}

impl Unpacker {
    fn advance(&mut self, mut packed: &[u8], action: Action) -> Result<Vec<u8>, String> {
        let mut whole = Vec::new();
        let mut step = vec![0; STEP];
        loop {
            let done = self
                .stream
                .process(packed, &mut step, action)
                .map_err(|error| format!("the program's download is damaged: {error}"))?;
            packed = packed.get(done.bytes_consumed..).unwrap_or_default();
            whole.extend_from_slice(step.get(..done.bytes_produced).unwrap_or_default());
            let waits = done.bytes_consumed == 0 && done.bytes_produced == 0;
            match done.status {
                Status::StreamEnd if packed.is_empty() => return Ok(whole),
                Status::StreamEnd => return Err(String::from("the program's download is longer than it says")),
                Status::Ok if waits && action == Action::Run => return Ok(whole),
                Status::Ok if waits => return Err(String::from("the program's download ended early")),
                Status::Ok => (),
            }
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::{Action, STEP, Unpacker};
    use lzma_rust2::{LzmaOptions, LzmaWriter};
    use std::io::Write;

    /// Bytes that repeat, but not at once: several steps of them.
    fn program() -> Vec<u8> {
        (0..3 * STEP as u32).map(|k| (k.wrapping_mul(k) >> 7) as u8).collect()
    }

    fn packed(bytes: &[u8]) -> Vec<u8> {
        let options = LzmaOptions::with_preset(6);
        let mut writer = LzmaWriter::new_use_header(Vec::new(), &options, Some(bytes.len() as u64)).unwrap();
        writer.write_all(bytes).unwrap();
        writer.finish().unwrap()
    }

    /// Unpacked from pieces of `length` bytes.
    fn unpacked(packed: &[u8], length: usize) -> Result<Vec<u8>, String> {
        let mut unpacker = Unpacker::new();
        let mut whole = Vec::new();
        for piece in packed.chunks(length) {
            whole.extend(unpacker.advance(piece, Action::Run)?);
        }
        whole.extend(unpacker.advance(&[], Action::Finish)?);
        Ok(whole)
    }

    #[test]
    fn pieces_of_every_length_give_the_program() {
        let program = program();
        let packed = packed(&program);
        for length in [1, 2, 13, 14, 1000, packed.len()] {
            assert!(unpacked(&packed, length).unwrap() == program, "pieces of {length} bytes");
        }
    }

    #[test]
    fn a_stream_that_ends_early_is_an_error() {
        let packed = packed(&program());
        for length in [0, 5, 13, packed.len() / 2, packed.len() - 6] {
            assert!(unpacked(&packed[..length], 1000).is_err(), "{length} of {} bytes", packed.len());
        }
    }

    #[test]
    fn what_is_not_a_packed_program_is_an_error() {
        assert!(unpacked(b"<!doctype html><title>404</title>", 1000).is_err());
        let mut longer = packed(&program());
        longer.extend([0; 100]);
        assert!(unpacked(&longer, 1000).is_err());
    }
}
