//! Packages trunk's output as a folder for any host: the program without its names section and packed, the small
//! program that unpacks it, all files of one build in a folder named after its version, the service worker that stores
//! them for offline use, and the size of the download.

use crate::shell::{Failure, say};
use lzma_rust2::{LzmaOptions, LzmaWriter};
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// The folder of a build as written by trunk; the version is appended later.
const APP: &str = "app";
/// The compiled program in it.
const PROGRAM: &str = "riemap_bg.wasm";
/// The packed program. No host knows this extension, so that none compresses the file again.
const PACKED_PROGRAM: &str = "riemap_bg.wasm.packed";
/// The program that unpacks it, which hosts compress by themselves.
const UNPACKER: &str = "unpacker_bg.wasm";
/// The packer's window in bytes: the whole program.
const WINDOW: u32 = 16 << 20;
const PAGE: &str = "index.html";
const SERVICE_WORKER: &str = "service-worker.js";

/// The compression level by which downloads are estimated, the highest.
const LEVEL: u8 = 9;
/// The size of the header and the trailer of a gzip file.
const GZIP_FRAME: usize = 18;

/// A built folder.
pub struct Package<'a> {
    folder: &'a Path,
}

impl<'a> Package<'a> {
    /// The package of trunk's output in `folder`.
    pub fn new(folder: &'a Path) -> Self {
        Self { folder }
    }

    /// The compiled program, before [`Self::finish`].
    pub fn program(&self) -> PathBuf {
        self.folder.join(APP).join(PROGRAM)
    }

    /// Packs the program by LZMA: a quarter smaller than the hosts' own compression, and some hosts do not compress.
    fn pack(&self) -> Result<usize, Failure> {
        let program = self.program();
        let packed = packed(&stripped(&program)?).map_err(|error| failure(&program, error))?;
        let length = packed.len();
        write(&program.with_file_name(PACKED_PROGRAM), packed)?;
        fs::remove_file(&program).map_err(|error| failure(&program, error))?;
        let unpacker = program.with_file_name(UNPACKER);
        write(&unpacker, stripped(&unpacker)?)?;
        Ok(length)
    }

    /// Packs the program, names the build after its version, writes the service worker's list of files,
    /// and returns the size of the first visit's download.
    pub fn finish(&self, service_worker: &Path) -> Result<usize, Failure> {
        let program = self.pack()?;
        let version = format!("{APP}-{:016x}", self.digest()?);
        let (old, new) = (self.folder.join(APP), self.folder.join(&version));
        fs::rename(&old, &new).map_err(|error| failure(&old, error))?;
        let page = self.folder.join(PAGE);
        let text = text_of(&page)?
            .replace(&format!("./{APP}/"), &format!("./{version}/"))
            .replace("data-bytes=\"0\"", &format!("data-bytes=\"{program}\""));
        write(&page, text)?;
        self.write_service_worker(service_worker, &version)?;
        self.weigh(&version)
    }

    /// A hash of the names and contents of all files.
    fn digest(&self) -> Result<u64, Failure> {
        let mut hasher = DefaultHasher::new();
        for name in self.files()? {
            read(&self.folder.join(&name))?.hash(&mut hasher);
            name.hash(&mut hasher);
        }
        Ok(hasher.finish())
    }

    fn write_service_worker(&self, source: &Path, version: &str) -> Result<(), Failure> {
        // the page is requested by the address of its folder
        let files = self.files()?.into_iter().map(|name| if name == PAGE { String::new() } else { name });
        let list: Vec<String> = files.map(|name| format!("  {name:?},\n")).collect();
        let head = format!("const VERSION = {version:?};\nconst FILES = [\n{}];\n\n", list.concat());
        write(&self.folder.join(SERVICE_WORKER), head + &text_of(source)?)
    }

    /// The sorted paths of the files, with `/` between folders.
    fn files(&self) -> Result<Vec<String>, Failure> {
        let mut names = Vec::new();
        self.collect("", &mut names)?;
        names.sort();
        Ok(names)
    }

    fn collect(&self, below: &str, names: &mut Vec<String>) -> Result<(), Failure> {
        let folder = self.folder.join(below);
        for entry in fs::read_dir(&folder).map_err(|error| failure(&folder, error))? {
            let entry = entry.map_err(|error| failure(&folder, error))?;
            let name = format!("{below}{}", entry.file_name().to_string_lossy());
            if entry.path().is_dir() {
                self.collect(&format!("{name}/"), names)?;
            } else if name != SERVICE_WORKER {
                names.push(name);
            }
        }
        Ok(())
    }

    /// Prints and returns the size of the first visit's download.
    fn weigh(&self, version: &str) -> Result<usize, Failure> {
        let mut whole = 0;
        for name in self.files()?.iter().filter(|name| *name == PAGE || name.starts_with(version)) {
            let bytes = read(&self.folder.join(name))?;
            let packed = if name.ends_with(PACKED_PROGRAM) {
                bytes.len()
            } else {
                miniz_oxide::deflate::compress_to_vec(&bytes, LEVEL).len() + GZIP_FRAME
            };
            whole += packed;
            say(format_args!("{:>9} bytes, {packed:>8} compressed: {name}", bytes.len()));
        }
        say(format_args!("the first visit downloads {whole} bytes"));
        Ok(whole)
    }
}

/// The program without its functions' names, a tenth of its size.
fn stripped(program: &Path) -> Result<Vec<u8>, Failure> {
    without_names(&read(program)?).ok_or_else(|| failure(program, "it is no WebAssembly"))
}

/// The bytes as a `.lzma` file.
fn packed(bytes: &[u8]) -> io::Result<Vec<u8>> {
    // four bits of context: 0.2 % smaller for WebAssembly than the usual three and the position
    let options = LzmaOptions {
        dict_size: WINDOW,
        lc: 4,
        pb: 0,
        nice_len: 273,
        depth_limit: 1000,
        ..LzmaOptions::with_preset(9)
    };
    let mut writer = LzmaWriter::new_use_header(Vec::new(), &options, Some(bytes.len() as u64))?;
    writer.write_all(bytes)?;
    writer.finish()
}

/// The module without its sections `name` and `producers`; `None` if the bytes are not a module.
fn without_names(module: &[u8]) -> Option<Vec<u8>> {
    const HEADER: usize = 8;
    const CUSTOM: u8 = 0;
    let mut kept = module.get(..HEADER).filter(|header| header.starts_with(b"\0asm"))?.to_vec();
    let mut rest = module.get(HEADER..)?;
    while let Some((&kind, after)) = rest.split_first() {
        let (size, content) = leb128(after)?;
        let body = content.get(..size)?;
        let length = rest.len() - content.len() + size;
        let is_named = |name: &[u8]| leb128(body).is_some_and(|(n, text)| n == name.len() && text.starts_with(name));
        if kind != CUSTOM || !(is_named(b"name") || is_named(b"producers")) {
            kept.extend_from_slice(rest.get(..length)?);
        }
        rest = rest.get(length..)?;
    }
    Some(kept)
}

/// Decodes an unsigned LEB128 number; returns it and the remaining bytes.
fn leb128(bytes: &[u8]) -> Option<(usize, &[u8])> {
    let mut number = 0;
    for (k, &byte) in bytes.iter().take(5).enumerate() {
        number |= usize::from(byte & 0x7f) << (7 * k);
        if byte < 0x80 {
            return Some((number, &bytes[k + 1..]));
        }
    }
    None
}

fn read(file: &Path) -> Result<Vec<u8>, Failure> {
    fs::read(file).map_err(|error| failure(file, error))
}

fn text_of(file: &Path) -> Result<String, Failure> {
    fs::read_to_string(file).map_err(|error| failure(file, error))
}

fn write(file: &Path, content: impl AsRef<[u8]>) -> Result<(), Failure> {
    fs::write(file, content).map_err(|error| failure(file, error))
}

fn failure(file: &Path, reason: impl std::fmt::Display) -> Failure {
    Failure::new("packing the web app", format!("{}: {reason}", file.display()))
}

#[cfg(test)]
mod tests {
    use super::{leb128, without_names};

    fn section(kind: u8, body: &[u8]) -> Vec<u8> {
        [&[kind, body.len() as u8], body].concat()
    }

    #[test]
    fn only_the_name_sections_are_removed() {
        let header = b"\0asm\x01\0\0\0".to_vec();
        let [types, names, other] = [section(1, &[0]), section(0, b"\x04name\x01\x00"), section(0, b"\x05names")];
        let module = [header.clone(), types.clone(), names, other.clone()].concat();
        assert_eq!(without_names(&module), Some([header, types, other].concat()));
    }

    #[test]
    fn bytes_that_are_no_module_are_refused() {
        assert_eq!(without_names(b"<!doctype html>"), None);
        assert_eq!(without_names(b"\0asm\x01\0\0\0\x01\x7f"), None);
    }

    #[test]
    fn numbers_have_seven_bits_a_byte() {
        assert_eq!(leb128(&[0xe5, 0x8e, 0x26, 7]), Some((624_485, &[7][..])));
        assert_eq!(leb128(&[0x80; 9]), None);
    }
}
