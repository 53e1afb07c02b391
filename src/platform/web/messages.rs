//! Requests and responses as JavaScript values: flat arrays, which are transferred instead of copied.
//!
//! A request is `{ generation, task }`, whose `task` names the other fields: `points`, `form` and `settings` of an
//! outline, with `point` if its integral equation is requested, `points`, `fractions`, `coarse` and `settings` of a mesh,
//! `file` and `settings` of an outline file, `file` of a session file, `repair`, `outline_loop`, `settings` and either `preset` or
//! `file` of a surface. A file is `{ name, bytes }`.
//!
//! A response is `{ generation }` with `stage`, `failed`, `outline`, `taken`, `session`, `unread`, `refused`, or `floats`,
//! `indices`, `record` and, of a side, `notes`. An outline is `{ points, text }`, a session `{ outlines, text, surfaces, picture }` with
//! the loaded outlines of its undo steps and its files, a
//! failure to read `{ text, repaired }`. `{ rehearsal }` has no response; a study is `{ study }`, a finding `{ finding }`;
//! a panic is reported by `{ died }`, a worker that runs says `{ locked }`, whether it holds its lock. Small enums are JSON text in serde's form; what travels between
//! workers only is packed: `refused`, `record`, `study`, `finding`.

use crate::conformal::{PrepareSettings, Resampled};
use crate::geometry::{DVec2, SimplePolygon};
use crate::session::file::{Archive, Attachment};
use crate::worker::{
    Drawn, Failure, Finding, FlatArchive, FlatOutline, NamedFile, Request, Response, Study, SurfaceSource, Task,
    Transfer, Unread, packed, unpacked,
};
use js_sys::{Array, Float64Array, Object, Reflect, Uint8Array, Uint32Array};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::sync::Arc;
use wasm_bindgen::{JsCast, JsValue};

// The values of a request's field `task`.
const OUTLINE: &str = "outline";
const EQUATION: &str = "equation";
const MESH: &str = "mesh";
const OUTLINE_FILE: &str = "outline-file";
const SESSION_FILE: &str = "session-file";
const SURFACE: &str = "surface";

/// Encodes a request to a worker, and lists the buffers to transfer with it.
pub fn encode_request(request: &Request) -> (JsValue, Array) {
    let transfer = Array::new();
    let (kind, fields) = match &request.task {
        Task::Outline { outline, settings } => (OUTLINE, encode_drawn(outline, settings, &transfer)),
        Task::Equation { outline, settings, point } => {
            let mut fields = encode_drawn(outline, settings, &transfer);
            fields.push(("point", json(point)));
            (EQUATION, fields)
        }
        Task::Mesh { resampled, settings } => (MESH, encode_resampled(resampled, settings, &transfer)),
        Task::OutlineFile { file, part, settings } => {
            let file = ("file", encode_file(file, &transfer));
            (OUTLINE_FILE, vec![file, ("part", json(part)), ("settings", json(settings))])
        }
        Task::SessionFile(file) => (SESSION_FILE, vec![("file", encode_file(file, &transfer))]),
        Task::Surface { source, repair, outline_loop, settings } => {
            let source = match source {
                SurfaceSource::Preset { preset, boundary } => ("preset", json(&(preset, boundary))),
                SurfaceSource::File(file) => ("file", encode_file(file, &transfer)),
            };
            let outline_loop = ("outline_loop", json(outline_loop));
            (SURFACE, vec![source, ("repair", (*repair).into()), outline_loop, ("settings", json(settings))])
        }
    };
    let common = [("generation", JsValue::from(request.generation.to_string())), ("task", kind.into())];
    (object(&[&common[..], &fields].concat()), transfer)
}

fn encode_drawn(
    Drawn { polygon, form }: &Drawn,
    settings: &PrepareSettings,
    transfer: &Array,
) -> Vec<(&'static str, JsValue)> {
    let flat: Vec<f64> = polygon.vertices().iter().flat_map(DVec2::to_array).collect();
    let points = Float64Array::from(flat.as_slice());
    transfer.push(&points.buffer());
    vec![("points", points.into()), ("form", json(form)), ("settings", json(settings))]
}

/// An outline; its polygon is known to be simple: the page sends the vertices of a `SimplePolygon`.
fn decode_drawn(message: &JsValue) -> Option<Box<Drawn>> {
    let flat = Float64Array::from(get(message, "points")?).to_vec();
    let polygon = SimplePolygon::known_simple(flat.chunks_exact(2).map(DVec2::from_slice).collect());
    Some(Box::new(Drawn { polygon, form: parsed(message, "form")? }))
}

fn encode_resampled(
    resampled: &Resampled,
    settings: &PrepareSettings,
    transfer: &Array,
) -> Vec<(&'static str, JsValue)> {
    let flat: Vec<f64> = resampled.samples().points().iter().flat_map(DVec2::to_array).collect();
    let [points, fractions] = [&flat, resampled.samples().fractions()].map(Float64Array::from);
    transfer.push(&points.buffer());
    transfer.push(&fractions.buffer());
    let fields = [("points", points.into()), ("fractions", fractions.into())];
    fields.into_iter().chain([("coarse", json(&resampled.coarse())), ("settings", json(settings))]).collect()
}

fn decode_resampled(message: &JsValue) -> Option<Box<Resampled>> {
    let flat = Float64Array::from(get(message, "points")?).to_vec();
    let points = flat.chunks_exact(2).map(DVec2::from_slice).collect();
    let fractions = Float64Array::from(get(message, "fractions")?).to_vec();
    Resampled::from_parts((points, fractions), parsed(message, "coarse")?).map(Box::new)
}

fn encode_file(NamedFile { name, bytes }: &NamedFile, transfer: &Array) -> JsValue {
    let bytes = Uint8Array::from(bytes.as_slice());
    transfer.push(&bytes.buffer());
    object(&[("name", name.into()), ("bytes", bytes.into())])
}

/// Decodes a request; `None` if [`encode_request`] did not make it.
pub fn decode_request(message: &JsValue) -> Option<Request> {
    let task = match get(message, "task")?.as_string()?.as_str() {
        OUTLINE => Task::Outline { outline: decode_drawn(message)?, settings: parsed(message, "settings")? },
        EQUATION => Task::Equation {
            outline: decode_drawn(message)?,
            settings: parsed(message, "settings")?,
            point: parsed(message, "point")?,
        },
        MESH => Task::Mesh { resampled: decode_resampled(message)?, settings: parsed(message, "settings")? },
        OUTLINE_FILE => Task::OutlineFile {
            file: decode_file(message)?,
            part: parsed(message, "part")?,
            settings: parsed(message, "settings")?,
        },
        SESSION_FILE => Task::SessionFile(decode_file(message)?),
        SURFACE => Task::Surface {
            source: decode_source(message)?,
            repair: get(message, "repair")?.as_bool()?,
            outline_loop: parsed(message, "outline_loop")?,
            settings: parsed(message, "settings")?,
        },
        _ => return None,
    };
    Some(Request { generation: generation_of(message)?, task })
}

fn decode_source(message: &JsValue) -> Option<SurfaceSource> {
    if get(message, "preset").is_some() {
        let (preset, boundary) = parsed(message, "preset")?;
        return Some(SurfaceSource::Preset { preset, boundary });
    }
    decode_file(message).map(SurfaceSource::File)
}

fn decode_file(message: &JsValue) -> Option<NamedFile> {
    let file = get(message, "file")?;
    let bytes = Uint8Array::from(get(&file, "bytes")?).to_vec();
    Some(NamedFile { name: get(&file, "name")?.as_string()?, bytes: Arc::new(bytes) })
}

/// Encodes a response, and lists the buffers to transfer with it.
pub fn encode_response(generation: u64, response: Response) -> (JsValue, Array) {
    let transfer = Array::new();
    let number = ("generation", JsValue::from(generation.to_string()));
    let message = match response {
        Response::Progress(stage) => object(&[number, ("stage", json(&stage))]),
        Response::Failed(failure) => object(&[number, ("failed", json(&failure))]),
        Response::Outline(outline, parts) => {
            let outline = encode_outline(&FlatOutline::from(&*outline), &transfer);
            object(&[number, ("outline", outline), ("parts", bytes(&parts))])
        }
        Response::Taken(taken) => object(&[number, ("taken", json(&taken))]),
        Response::Session(session) => object(&[number, ("session", encode_session(*session, &transfer))]),
        Response::Unread(unread) => object(&[number, ("unread", encode_unread(&unread, &transfer))]),
        Response::Equation(equation) => match *equation {
            Ok(equation) => object(&[&[number], &encode_buffers(equation, &transfer)[..]].concat()),
            Err(reason) => object(&[number, ("refused", bytes(&reason))]),
        },
        Response::Prepared(side, notes) => {
            let buffers = match Transfer::try_from(&*side) {
                Ok(buffers) => buffers,
                Err(error) => {
                    return (object(&[number, ("failed", json(&Failure::new(&error)))]), transfer);
                }
            };
            drop(side);
            object(&[&[number, ("notes", json(&notes))], &encode_buffers(buffers, &transfer)[..]].concat())
        }
    };
    (message, transfer)
}

fn encode_outline(FlatOutline { points, text }: &FlatOutline, transfer: &Array) -> JsValue {
    let array = Float64Array::from(points.as_slice());
    transfer.push(&array.buffer());
    object(&[("points", array.into()), ("text", text.into())])
}

fn decode_outline(message: &JsValue) -> Option<FlatOutline> {
    let points = Float64Array::from(get(message, "points")?).to_vec();
    Some(FlatOutline { points, text: get(message, "text")?.as_string()? })
}

/// Encodes a session; every session that was read has a flat form, any other becomes an object that is not decodable.
fn encode_session(archive: Archive, transfer: &Array) -> JsValue {
    let Some(FlatArchive { outlines, text, surfaces, picture }) = FlatArchive::of(archive) else { return object(&[]) };
    let outlines: Array = outlines.iter().map(|outline| encode_outline(outline, transfer)).collect();
    let surfaces: Array = surfaces.iter().map(|file| encode_attachment(file, transfer)).collect();
    let picture = picture.iter().map(|file| ("picture", encode_attachment(file, transfer)));
    let fields = [("text", JsValue::from(text)), ("outlines", outlines.into()), ("surfaces", surfaces.into())];
    object(&fields.into_iter().chain(picture).collect::<Vec<_>>())
}

fn decode_session(message: &JsValue) -> Option<Archive> {
    let list = |name| get(message, name)?.dyn_into::<Array>().ok();
    let outlines = list("outlines")?.iter().map(|outline| decode_outline(&outline)).collect::<Option<_>>()?;
    let surfaces = list("surfaces")?.iter().map(|file| decode_attachment(&file)).collect::<Option<_>>()?;
    let picture = get(message, "picture").and_then(|file| decode_attachment(&file));
    FlatArchive { outlines, text: get(message, "text")?.as_string()?, surfaces, picture }.archive()
}

fn encode_attachment(Attachment { name, bytes }: &Attachment, transfer: &Array) -> JsValue {
    let bytes = Uint8Array::from(bytes.as_slice());
    transfer.push(&bytes.buffer());
    object(&[("name", name.into()), ("bytes", bytes.into())])
}

fn decode_attachment(file: &JsValue) -> Option<Attachment> {
    let bytes = Uint8Array::from(get(file, "bytes")?).to_vec();
    Some(Attachment { name: get(file, "name")?.as_string()?, bytes: Arc::new(bytes) })
}

fn encode_unread(Unread { text, repaired }: &Unread, transfer: &Array) -> JsValue {
    let repaired =
        repaired.iter().map(|outline| ("repaired", encode_outline(&FlatOutline::from(&**outline), transfer)));
    let fields: Vec<_> = [("text", json(text))].into_iter().chain(repaired).collect();
    object(&fields)
}

fn decode_unread(message: &JsValue) -> Option<Unread> {
    let repaired = get(message, "repaired").and_then(|outline| decode_outline(&outline)?.outline()).map(Box::new);
    Some(Unread { text: parsed(message, "text")?, repaired })
}

/// Each array is freed as soon as it is copied, so that a large surface takes 1.5 times its memory, not twice.
fn encode_buffers(buffers: Transfer, transfer: &Array) -> [(&'static str, JsValue); 3] {
    let (floats, indices) = (Array::new(), Array::new());
    for values in buffers.floats {
        let array = Float64Array::from(values.as_slice());
        transfer.push(&array.buffer());
        floats.push(&array);
    }
    for values in buffers.indices {
        let array = Uint32Array::from(values.as_slice());
        transfer.push(&array.buffer());
        indices.push(&array);
    }
    [
        ("floats", floats.into()),
        ("indices", indices.into()),
        ("record", Uint8Array::from(buffers.record.as_slice()).into()),
    ]
}

fn decode_buffers(message: &JsValue) -> Option<Transfer> {
    let floats = get(message, "floats")?.dyn_into::<Array>().ok()?;
    let indices = get(message, "indices")?.dyn_into::<Array>().ok()?;
    Some(Transfer {
        floats: floats.iter().map(|array| Float64Array::from(array).to_vec()).collect(),
        indices: indices.iter().map(|array| Uint32Array::from(array).to_vec()).collect(),
        record: Uint8Array::from(get(message, "record")?).to_vec(),
    })
}

/// Encodes a rehearsal, sent to an idle worker.
pub fn encode_rehearsal() -> JsValue {
    object(&[("rehearsal", true.into())])
}

/// Whether the message is a rehearsal.
pub fn is_rehearsal(message: &JsValue) -> bool {
    get(message, "rehearsal").is_some()
}

/// Encodes a study for its worker.
pub fn encode_study(study: &Study) -> JsValue {
    object(&[("study", bytes(study))])
}

/// Decodes a study; `None` if [`encode_study`] did not make it.
pub fn decode_study(message: &JsValue) -> Option<Study> {
    taken(message, "study")
}

/// Encodes a finding of the study that was posted last.
pub fn encode_finding(finding: &Finding) -> JsValue {
    object(&[("finding", bytes(finding))])
}

/// Decodes a finding; `None` if [`encode_finding`] did not make it.
pub fn decode_finding(message: &JsValue) -> Option<Finding> {
    taken(message, "finding")
}

/// A worker's message that it runs: whether it holds the lock by which its end is noticed. `None` for other messages.
pub fn decode_start(message: &JsValue) -> Option<bool> {
    get(message, "locked")?.as_bool()
}

/// Encodes the report of a panic.
pub fn encode_death(reason: &str) -> JsValue {
    object(&[("died", reason.into())])
}

/// The reason of a panic; `None` for other messages.
pub fn decode_death(message: &JsValue) -> Option<String> {
    get(message, "died")?.as_string()
}

/// Decodes a response; `None` if [`encode_response`] did not make it.
pub fn decode_response(message: &JsValue) -> Option<(u64, Response)> {
    let generation = generation_of(message)?;
    let response = if let Some(stage) = parsed(message, "stage") {
        Response::Progress(stage)
    } else if let Some(failure) = parsed(message, "failed") {
        Response::Failed(failure)
    } else if let Some(outline) = get(message, "outline") {
        Response::Outline(Box::new(decode_outline(&outline)?.outline()?), taken(message, "parts")?)
    } else if let Some(taken) = parsed(message, "taken") {
        Response::Taken(taken)
    } else if let Some(session) = get(message, "session") {
        Response::Session(Box::new(decode_session(&session)?))
    } else if let Some(unread) = get(message, "unread") {
        Response::Unread(decode_unread(&unread)?)
    } else if let Some(reason) = taken(message, "refused") {
        Response::Equation(Box::new(Err(reason)))
    } else if let Some(notes) = parsed(message, "notes") {
        Response::Prepared(Box::new(decode_buffers(message)?.into_side()?), notes)
    } else {
        Response::Equation(Box::new(Ok(decode_buffers(message)?)))
    };
    Some((generation, response))
}

fn generation_of(message: &JsValue) -> Option<u64> {
    get(message, "generation")?.as_string()?.parse().ok()
}

fn get(message: &JsValue, key: &str) -> Option<JsValue> {
    Reflect::get(message, &key.into()).ok().filter(|value| !value.is_undefined())
}

/// The value as JSON text; plain data can always be serialized.
fn json(value: &impl Serialize) -> JsValue {
    serde_json::to_string(value).unwrap_or_default().into()
}

fn parsed<T: DeserializeOwned>(message: &JsValue, key: &str) -> Option<T> {
    serde_json::from_str(&get(message, key)?.as_string()?).ok()
}

/// The value as packed bytes.
fn bytes(value: &impl Serialize) -> JsValue {
    Uint8Array::from(packed(value).as_slice()).into()
}

fn taken<T: DeserializeOwned>(message: &JsValue, key: &str) -> Option<T> {
    unpacked(&Uint8Array::from(get(message, key)?).to_vec())
}

fn object(fields: &[(&str, JsValue)]) -> JsValue {
    let object = Object::new();
    for (key, value) in fields {
        // setting a plain property of a new object does not fail
        let _ = Reflect::set(&object, &(*key).into(), value);
    }
    object.into()
}
