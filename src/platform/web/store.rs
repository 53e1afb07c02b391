//! Sessions kept in the browser's database, by `store.js`: what was kept last, and one record for each visit.
//!
//! A part that has been written or read is not sent to the database again; a large one is hashed once.

use super::address;
use crate::language::{Message, key};
use crate::model::persistence::visits::{Kept, Listed, Visit};
use crate::platform::{Event, Mailbox};
use crate::session::file::Part;
use js_sys::{Array, Map, Object, Promise, Reflect, Uint8Array};
use std::cell::RefCell;
use std::collections::BTreeSet;
use std::hash::{DefaultHasher, Hasher as _};
use std::sync::Arc;
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(catch, js_namespace = riemapStore, js_name = first)]
    fn store_first(id: JsValue, link: JsValue) -> Result<Promise, JsValue>;
    #[wasm_bindgen(catch, js_namespace = riemapStore, js_name = hold)]
    fn store_hold(id: &str) -> Result<Promise, JsValue>;
    #[wasm_bindgen(catch, js_namespace = riemapStore, js_name = own)]
    fn store_own(id: &str, fresh: &str) -> Result<Promise, JsValue>;
    #[wasm_bindgen(catch, js_namespace = riemapStore, js_name = keep)]
    fn store_keep(visit: JsValue, contents: Map) -> Result<Promise, JsValue>;
    #[wasm_bindgen(catch, js_namespace = riemapStore, js_name = load)]
    fn store_load(id: &str) -> Result<Promise, JsValue>;
}

/// Parts with at least this many bytes are hashed once and then recognized by their address.
const LARGE_BYTES: usize = 1 << 16;

/// What is known of the database.
#[derive(Default)]
struct Known {
    /// The keys of parts that are in the database.
    stored: BTreeSet<String>,
    /// The keys of large parts.
    large: Vec<(Arc<Vec<u8>>, String)>,
    /// What the app starts with.
    first: Option<Kept>,
    listed: Vec<Listed>,
}

thread_local! {
    static KNOWN: RefCell<Known> = RefCell::default();
}

/// Reads what the app starts with, before the app is created. Without a database there is nothing.
pub async fn read_first() {
    if !address::keeps_sessions() {
        return;
    }
    let text = |text: Option<String>| text.map_or(JsValue::NULL, JsValue::from);
    let link = address::link().map(|link| link.trim_start_matches('#').to_owned());
    let id = match address::visit() {
        Some(id) => Some(own_id(id).await),
        None => None,
    };
    match awaited(store_first(text(id), text(link))).await {
        Ok(found) => {
            let visit = get(&found, "visit").filter(JsValue::is_object).and_then(|visit| decode(&visit));
            let listed = get(&found, "visits").map(|list| decode_list(&list)).unwrap_or_default();
            KNOWN.with_borrow_mut(|known| (known.first, known.listed) = (visit, listed));
        }
        Err(reason) => log::warn!("no session was read: {}", reason.english()),
    }
}

/// The id under which this tab goes on with a visit of its history. If another tab has that visit, of which this tab may
/// be a duplicate, it is a new one, with a copy of what is kept.
async fn own_id(id: String) -> String {
    let Some(fresh) = address::new_visit() else { return id };
    let own = awaited(store_own(&id, &fresh)).await.ok().and_then(|own| own.as_string()).unwrap_or_else(|| id.clone());
    if own != id && address::visit().as_ref() == Some(&id) {
        address::rename_visit(&own);
    }
    own
}

/// Takes a visit for this tab, so that a duplicate of the tab finds it taken.
pub fn hold(id: &str) {
    if store_hold(id).is_err() {
        log::warn!("visit {id} could not be held");
    }
}

/// What the app starts with, once, and the list of visits.
pub fn first_kept() -> (Option<Kept>, Vec<Listed>) {
    KNOWN.with_borrow_mut(|known| (known.first.take(), std::mem::take(&mut known.listed)))
}

/// Stores a visit; the result is posted to `mailbox`. If it does not fit with its files, it is stored without them.
pub fn keep(visit: Visit, mailbox: Mailbox) {
    if !address::keeps_sessions() {
        return;
    }
    wasm_bindgen_futures::spawn_local(async move {
        let result = match store(&visit, false).await {
            Err(reason) if reason.english().contains("missing-part") => store(&visit, true).await,
            other => other,
        };
        let result = match result {
            Err(reason) if visit.has_files() => {
                let listed = store(&visit.clone().without_files(), true).await;
                listed.map_err(|_| reason.clone()).map(|listed| (listed, Some(reason)))
            }
            other => other.map(|listed| (listed, None)),
        };
        mailbox.post(Event::Kept(result));
    });
}

/// Stores a visit with the parts that are not known to be stored, or with all.
async fn store(visit: &Visit, all: bool) -> Result<Vec<Listed>, Message> {
    let (parts, contents, keys) = (Array::new(), Map::new(), KNOWN.with_borrow_mut(|known| known.keys(&visit.parts)));
    for (part, key) in visit.parts.iter().zip(&keys) {
        parts.push(&object(&[("path", part.path.as_str().into()), ("key", key.as_str().into())]));
        if all || KNOWN.with_borrow(|known| !known.stored.contains(key)) {
            contents.set(&key.as_str().into(), &Uint8Array::from(part.bytes.as_slice()));
        }
    }
    let link = visit.link.as_deref().map_or(JsValue::NULL, JsValue::from);
    let fields = [
        ("id", visit.id.as_str().into()),
        ("link", link),
        ("title", visit.title.as_str().into()),
        ("parts", parts.into()),
    ];
    let listed = awaited(store_keep(object(&fields), contents)).await?;
    KNOWN.with_borrow_mut(|known| known.stored.extend(keys));
    Ok(decode_list(&listed))
}

/// Reads a visit; it is posted to `mailbox`, with an id of its own if another tab has it.
pub fn load_visit(id: String, mailbox: Mailbox) {
    wasm_bindgen_futures::spawn_local(async move {
        let own = own_id(id.clone()).await;
        let found = awaited(store_load(&own)).await;
        let kept = found.ok().filter(JsValue::is_object).and_then(|visit| decode(&visit));
        mailbox.post(Event::Visited { id, own, kept });
    });
}

async fn awaited(promise: Result<Promise, JsValue>) -> Result<JsValue, Message> {
    let promise = promise.map_err(|_| Message::from(key::browser_stores_nothing()))?;
    JsFuture::from(promise).await.map_err(|error| match Message::from(error) {
        reason if reason.english() == "no-database" => key::browser_stores_nothing().into(),
        reason => reason,
    })
}

impl Known {
    /// The keys of parts: length and hash of the content.
    fn keys(&mut self, parts: &[Part]) -> Vec<String> {
        self.large.retain(|(bytes, _)| parts.iter().any(|part| Arc::ptr_eq(&part.bytes, bytes)));
        parts.iter().map(|part| self.key(&part.bytes)).collect()
    }

    fn key(&mut self, bytes: &Arc<Vec<u8>>) -> String {
        if let Some((_, key)) = self.large.iter().find(|(known, _)| Arc::ptr_eq(known, bytes)) {
            return key.clone();
        }
        let mut hasher = DefaultHasher::new();
        hasher.write(bytes);
        let key = format!("{:x}-{:016x}", bytes.len(), hasher.finish());
        if bytes.len() >= LARGE_BYTES {
            self.large.push((Arc::clone(bytes), key.clone()));
        }
        key
    }
}

fn decode(visit: &JsValue) -> Option<Kept> {
    let mut parts = Vec::new();
    for part in get(visit, "parts")?.dyn_into::<Array>().ok()?.iter() {
        let bytes = Uint8Array::from(get(&part, "bytes")?).to_vec();
        let key = get(&part, "key")?.as_string()?;
        KNOWN.with_borrow_mut(|known| known.stored.insert(key));
        parts.push(Part { path: get(&part, "path")?.as_string()?, bytes: Arc::new(bytes) });
    }
    Some(Kept { id: get(visit, "id")?.as_string()?, parts })
}

fn decode_list(list: &JsValue) -> Vec<Listed> {
    let listed = |visit: JsValue| {
        let text = |name| get(&visit, name)?.as_string();
        Some(Listed { id: text("id")?, title: text("title")?, at_ms: get(&visit, "at")?.as_f64()? })
    };
    list.dyn_ref::<Array>().map(|list| list.iter().filter_map(listed).collect()).unwrap_or_default()
}

fn get(value: &JsValue, key: &str) -> Option<JsValue> {
    Reflect::get(value, &key.into()).ok().filter(|value| !value.is_undefined())
}

fn object(fields: &[(&str, JsValue)]) -> JsValue {
    let object = Object::new();
    for (key, value) in fields {
        // setting a plain property of a new object does not fail
        let _ = Reflect::set(&object, &(*key).into(), value);
    }
    object.into()
}
