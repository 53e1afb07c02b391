//! The kept session on the desktop: its parts as files in a folder beside `last.riemap`.
//!
//! A part is named by the length and a hash of its content and written once; the list of parts is written last and
//! replaces the former one as a whole, so that a crash leaves the former or the new state. Parts that the list does not
//! name any more are removed.

use super::native::kept_folder;
use super::{Event, Mailbox};
use crate::language::{Message, key};
use crate::model::persistence::visits::{Kept, Listed, Visit};
use crate::session::file::Part;
use std::collections::BTreeSet;
use std::fs;
use std::hash::{DefaultHasher, Hasher as _};
use std::io;
use std::path::Path;
use std::sync::Arc;

/// The list of parts: paths and names of files.
const LIST: &str = "list.json";

/// The session of the last run, once; the list of visits is empty, since there is one only.
pub fn first_kept() -> (Option<Kept>, Vec<Listed>) {
    (kept_folder().and_then(|folder| read(&folder.join("kept"))), Vec::new())
}

/// Stores the session; the result is posted to `mailbox`.
#[allow(clippy::needless_pass_by_value, reason = "in the browser it is stored later")]
pub fn keep(visit: Visit, mailbox: Mailbox) {
    let stored = kept_folder().ok_or_else(|| Message::from(key::no_folder())).and_then(|folder| {
        let folder = folder.join("kept");
        write(&folder, &visit.parts).map_err(|error| key::about(folder.display().to_string(), error.to_string()))
    });
    mailbox.post(Event::Kept(stored.map(|()| (Vec::new(), None))));
}

/// Posts that no other visit is kept.
#[allow(clippy::needless_pass_by_value, reason = "in the browser it is read later")]
pub fn load_visit(id: String, mailbox: Mailbox) {
    mailbox.post(Event::Visited { own: id.clone(), id, kept: None });
}

fn write(folder: &Path, parts: &[Part]) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    let mut list = Vec::new();
    for part in parts {
        let name = name_of(&part.bytes);
        let path = folder.join(&name);
        if fs::metadata(&path).is_ok_and(|known| known.len() == part.bytes.len() as u64) {
            list.push((part.path.as_str(), name));
            continue;
        }
        fs::write(&path, &*part.bytes)?;
        list.push((part.path.as_str(), name));
    }
    let text = serde_json::to_string(&list).map_err(io::Error::other)?;
    let next = folder.join("next");
    fs::write(&next, text)?;
    fs::rename(&next, folder.join(LIST))?;
    let used: BTreeSet<&str> = list.iter().map(|(_, name)| name.as_str()).chain([LIST]).collect();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        if entry.file_name().to_str().is_none_or(|name| !used.contains(name)) {
            fs::remove_file(entry.path())?;
        }
    }
    Ok(())
}

/// The parts that are there; the archive's own list says whether one is missing.
fn read(folder: &Path) -> Option<Kept> {
    let list: Vec<(String, String)> = serde_json::from_str(&fs::read_to_string(folder.join(LIST)).ok()?).ok()?;
    let read = |(path, name): (String, String)| {
        // a name is one of `name_of`, never a path
        let is_name = name.bytes().all(|byte| byte.is_ascii_hexdigit() || byte == b'-');
        let bytes = fs::read(folder.join(&name)).ok().filter(|_| is_name)?;
        Some(Part { path, bytes: Arc::new(bytes) })
    };
    Some(Kept { id: String::from("last"), parts: list.into_iter().filter_map(read).collect() })
}

fn name_of(bytes: &[u8]) -> String {
    let mut hasher = DefaultHasher::new();
    hasher.write(bytes);
    format!("{:x}-{:016x}", bytes.len(), hasher.finish())
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::session::file::{Archive, Attachment};
    use crate::session::{History, scaled};

    fn archive(scale: f64, surface: &[u8]) -> Archive {
        let mut history = History::new(scaled(4.0));
        history.settle(&scaled(scale));
        let surfaces = vec![Attachment { name: "../cow.obj".into(), bytes: Arc::new(surface.to_vec()) }];
        Archive { history, surfaces, picture: None }
    }

    #[test]
    fn what_is_kept_is_read_back_and_what_did_not_change_is_not_written_again() {
        let folder = std::env::temp_dir().join(format!("riemap-kept-{}", std::process::id()));
        let cow = vec![7; 10_000];
        write(&folder, &archive(2.0, &cow).parts().unwrap()).unwrap();
        let of_cow = folder.join(name_of(&cow));
        let written = fs::metadata(&of_cow).unwrap().modified().unwrap();
        write(&folder, &archive(3.0, &cow).parts().unwrap()).unwrap();
        assert_eq!(fs::metadata(&of_cow).unwrap().modified().unwrap(), written);
        let found = read(&folder).unwrap().archive().unwrap();
        assert_eq!((found.session(), found.history.past()), (&scaled(3.0), &[scaled(4.0)][..]));
        assert_eq!(*found.surfaces[0].bytes, cow);
        write(&folder, &archive(3.0, b"another").parts().unwrap()).unwrap();
        assert!(!of_cow.exists(), "a part that is not used any more is removed");
        fs::remove_file(folder.join(name_of(b"another"))).unwrap();
        let error = read(&folder).unwrap().archive().unwrap_err().to_string();
        assert!(error.contains("surfaces/../cow.obj"), "{error}");
        fs::remove_dir_all(&folder).unwrap();
    }
}
