//! Embeds the neighboring files of a glTF document's buffers in it, so that one file is the whole surface.

use super::gltf_buffers::{BASE64, unescaped};
use base64::Engine as _;
use serde_json::Value;

/// The document with the buffers that are among `files`, each a name without folders and its bytes, as `data:` URIs (glTF
/// 2.0, section 3.6.1); and the indices of those files. `None` if it names none of them.
pub fn embedded(document: &[u8], files: &[(&str, &[u8])]) -> Option<(Vec<u8>, Vec<usize>)> {
    let mut value: Value = serde_json::from_slice(document.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(document)).ok()?;
    let mut used = Vec::new();
    for buffer in value.get_mut("buffers")?.as_array_mut()? {
        let Some(uri) = buffer.get_mut("uri") else { continue };
        let name = unescaped(uri.as_str()?);
        let leaf = name.rsplit(['/', '\\']).next().unwrap_or(&name);
        if let Some(k) = files.iter().position(|(file, _)| *file == leaf) {
            let data = BASE64.encode(files[k].1);
            *uri = format!("data:application/octet-stream;base64,{data}").into();
            used.push(k);
        }
    }
    if used.is_empty() { None } else { Some((serde_json::to_vec(&value).ok()?, used)) }
}
