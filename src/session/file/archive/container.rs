//! The container of session files: a zip (PKWARE's APPNOTE, with deflate or stored parts) read and written in memory.
//!
//! Guarantees for any input: a typed error or the parts, no panic; each part is unpacked only if the size that the
//! archive states, and the sum of all sizes, are within the limits, and never beyond the stated size, so that a small
//! file cannot fill the memory. Checksums are verified. Names of parts are not used as paths of any file system.

use super::Part;
use crate::session::file::FileError;
use miniz_oxide::deflate::compress_to_vec;
use miniz_oxide::inflate::decompress_to_vec_with_limit;
use rawzip::path::EntryPath;
use rawzip::{CompressionMethod, DataDescriptorOutput, ZipArchive, ZipArchiveWriter, crc32};
use std::io::Write as _;
use std::sync::Arc;

/// The first bytes of a zip with at least one part.
const MAGIC: &[u8] = b"PK\x03\x04";

/// The largest file that is read, and the most bytes of all its parts together: the files of surfaces that the app
/// keeps (256 MiB), a picture, and two outlines with the maximal number of points.
pub const MAX_BYTES: usize = 448 << 20;

/// The most parts: the outlines of 200 undo steps on both sides, and as many surfaces.
const MOST_PARTS: usize = 1024;

/// The level of deflate: a text of coordinates is 4 % larger than at level 9, and written four times as fast.
const LEVEL: u8 = 4;

/// Whether `bytes` begin like a zip.
pub fn is_zip(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC)
}

/// The bytes of a zip with these parts. Errors: two parts have the same path, or one that no zip can hold.
pub fn pack(parts: &[Part]) -> Result<Vec<u8>, FileError> {
    let mut bytes = Vec::new();
    let mut archive = ZipArchiveWriter::new(&mut bytes);
    for part in parts {
        append(&mut archive, part).map_err(|reason| FileError::BrokenPart { part: part.path.clone(), reason })?;
    }
    archive.finish().map_err(|error| FileError::Damaged(error.to_string()))?;
    Ok(bytes)
}

/// Appends a part: deflated where that is shorter, as it is not for a compressed picture.
fn append(archive: &mut ZipArchiveWriter<&mut Vec<u8>>, part: &Part) -> Result<(), String> {
    let deflated = compress_to_vec(&part.bytes, LEVEL);
    let is_shorter = deflated.len() < part.bytes.len();
    let method = if is_shorter { CompressionMethod::DEFLATE } else { CompressionMethod::STORE };
    let name = EntryPath::verbatim(part.path.as_bytes());
    let (mut entry, _) =
        archive.new_file(name).compression_method(method).start().map_err(|error| error.to_string())?;
    let stored = if is_shorter { &deflated } else { &*part.bytes };
    entry.write_all(stored).map_err(|error| error.to_string())?;
    let descriptor = DataDescriptorOutput::new(crc32(&part.bytes), part.bytes.len() as u64);
    entry.finish(descriptor).map_err(|error| error.to_string())?;
    Ok(())
}

/// The parts of a zip; `limit` says how many bytes the part of a path may have, 0 if it is not read.
pub fn unpack(bytes: &[u8], limit: impl Fn(&str) -> usize) -> Result<Vec<Part>, FileError> {
    let damaged = |error: rawzip::Error| FileError::Damaged(error.to_string());
    let archive = ZipArchive::from_slice(bytes).map_err(damaged)?;
    let (mut parts, mut total, mut count): (Vec<Part>, _, _) = (Vec::new(), 0, 0);
    let mut entries = archive.entries();
    while let Some(entry) = entries.next_entry().map_err(damaged)? {
        count += 1;
        if count > MOST_PARTS {
            return Err(FileError::TooManyParts { limit: MOST_PARTS });
        }
        let path = String::from_utf8_lossy(entry.file_path().as_bytes()).into_owned();
        let (size, most) = (entry.uncompressed_size_hint(), limit(&path));
        if most == 0 || entry.is_dir() {
            continue;
        }
        total += size.min(MAX_BYTES as u64 + 1);
        if size > most as u64 || total > MAX_BYTES as u64 {
            let limit = if size > most as u64 { most } else { MAX_BYTES };
            return Err(FileError::PartTooLarge { part: path, limit });
        }
        let broken = |reason: String| FileError::BrokenPart { part: path.clone(), reason };
        if parts.iter().any(|known| known.path == path) {
            return Err(broken(String::from("it is there twice")));
        }
        let found = archive.get_entry(entry.wayfinder()).map_err(|error| broken(error.to_string()))?;
        let unpacked = inflated(found.data(), entry.compression_method(), size as usize).map_err(broken)?;
        if crc32(&unpacked) != entry.crc32() {
            return Err(broken(String::from("its checksum is wrong")));
        }
        parts.push(Part { path, bytes: Arc::new(unpacked) });
    }
    Ok(parts)
}

/// The unpacked content, of exactly `size` bytes.
fn inflated(data: &[u8], method: CompressionMethod, size: usize) -> Result<Vec<u8>, String> {
    let unpacked = match method {
        CompressionMethod::STORE if data.len() == size => data.to_vec(),
        CompressionMethod::DEFLATE => decompress_to_vec_with_limit(data, size)
            .map_err(|error| format!("it cannot be unpacked: {:?}", error.status))?,
        CompressionMethod::STORE => return Err(String::from("its length is not the stated one")),
        _ => return Err(String::from("it is packed by another method than deflate")),
    };
    if unpacked.len() == size { Ok(unpacked) } else { Err(String::from("its length is not the stated one")) }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    fn part(path: &str, bytes: &[u8]) -> Part {
        Part { path: path.into(), bytes: Arc::new(bytes.to_vec()) }
    }

    fn all(_: &str) -> usize {
        1 << 20
    }

    #[test]
    fn unpacking_inverts_packing_whatever_the_names() {
        let parts = [
            part("session.json", &[b'a'; 5000]),
            part("surfaces/K\u{e4}se \\ : .. head (2).obj", b"short"),
            part("picture/\u{1f40b}.png", &[]),
        ];
        let packed = pack(&parts).unwrap();
        assert!(is_zip(&packed) && packed.len() < 1000, "{} bytes", packed.len());
        assert_eq!(unpack(&packed, all).unwrap(), parts);
        assert_eq!(unpack(&packed, |path| if path.ends_with("json") { 5000 } else { 0 }).unwrap(), parts[..1]);
    }

    #[test]
    fn a_part_above_its_limit_is_refused_before_it_is_unpacked() {
        let packed = pack(&[part("a", &vec![0; 1 << 16])]).unwrap();
        let found = unpack(&packed, |_| 100);
        assert_eq!(found, Err(FileError::PartTooLarge { part: "a".into(), limit: 100 }));
    }

    /// A bomb states a small size: no more than that is unpacked.
    #[test]
    fn a_part_that_unpacks_to_more_than_it_states_is_refused() {
        let mut packed = pack(&[part("a", &vec![0; 1 << 20])]).unwrap();
        let size = (1u32 << 20).to_le_bytes();
        for at in 0..packed.len() - 4 {
            if packed[at..at + 4] == size {
                packed[at..at + 4].copy_from_slice(&1000u32.to_le_bytes());
            }
        }
        assert!(matches!(unpack(&packed, all), Err(FileError::BrokenPart { .. })), "{:?}", unpack(&packed, all));
    }

    #[test]
    fn any_change_or_cut_gives_an_error_or_the_same_parts() {
        let parts = [part("a", &[7; 300]), part("b", b"0123456789 a text")];
        let packed = pack(&parts).unwrap();
        for end in 0..packed.len() {
            assert!(unpack(&packed[..end], all).is_err(), "cut at {end}");
        }
        let mut refused = 0;
        for at in 0..packed.len() {
            let mut changed = packed.clone();
            changed[at] ^= 0x55;
            match unpack(&changed, all) {
                Err(_) => refused += 1,
                Ok(found) => assert!(
                    found.iter().all(|found| parts.iter().any(|part| part.bytes == found.bytes)),
                    "changed at {at}"
                ),
            }
        }
        assert!(refused > packed.len() / 3, "{refused} of {}", packed.len());
    }
}
