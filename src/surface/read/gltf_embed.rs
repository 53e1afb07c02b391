//! Embeds the neighboring files of a glTF document's buffers in it, so that one file is the whole surface.

use super::gltf_buffers::{BASE64, unescaped};
use base64::Engine as _;
use serde_json::Value;

/// The document with the buffers that are among `files`, each a name without folders and its bytes, as `data:` URIs (glTF
/// 2.0, section 3.6.1); and the indices of those files. `None` if it names none of them.
pub fn embedded(document: &[u8], files: &[(&str, &[u8])]) -> Option<(Vec<u8>, Vec<usize>)> {
    let mut value: Value = serde_json::from_slice(document.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(document)).ok()?;
    let mut used: Vec<usize> = Vec::new();
    for buffer in value.get_mut("buffers")?.as_array_mut()? {
        let named = buffer.get("uri").and_then(Value::as_str).filter(|uri| !uri.starts_with("data:"));
        let Some(name) = named.map(unescaped) else { continue };
        let leaf = name.rsplit(['/', '\\']).next().unwrap_or(&name);
        let mut found = (0..files.len()).filter(|&k| files[k].0 == leaf);
        if let (Some(k), None) = (found.next(), found.next()) {
            // two buffers of one name are in two folders, of which a drop does not tell
            if used.contains(&k) {
                return None;
            }
            let data = BASE64.encode(files[k].1);
            buffer["uri"] = format!("data:application/octet-stream;base64,{data}").into();
            used.push(k);
        }
    }
    if used.is_empty() { None } else { Some((serde_json::to_vec(&value).ok()?, used)) }
}
