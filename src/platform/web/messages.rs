//! Requests and answers as JavaScript values: flat arrays, transferred, not copied.
//!
//! A request is `{ generation, settings }` with `points`, or with `repair` and one of `preset` and
//! `name` and `bytes`; an answer `{ generation }` with one of `stage`, `failed`, or `floats`, `indices`
//! `text` and `notes`; `{ rehearsal }` is answered by nothing; a study is `{ study }`, what it found `{ study, finding }`;
//! a panic's last word is `{ died }`. Small enums travel as JSON text in the form that serde gives them.

use crate::conformal::{FlatBuffers, PreparedSide};
use crate::geometry::{DVec2, SimplePolygon};
use crate::worker::{Finding, Request, Response, Study, SurfaceSource, Task};
use js_sys::{Array, Float64Array, Object, Reflect, Uint8Array, Uint32Array};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::sync::Arc;
use wasm_bindgen::{JsCast, JsValue};

/// What a worker is sent.
pub fn encode_request(request: &Request) -> JsValue {
    let number = ("generation", JsValue::from(request.generation.to_string()));
    match &request.task {
        Task::Outline { polygon, settings } => {
            let flat: Vec<f64> = polygon.vertices().iter().flat_map(DVec2::to_array).collect();
            object(&[number, ("points", Float64Array::from(flat.as_slice()).into()), ("settings", json(settings))])
        }
        Task::Surface { source, repair, settings } => {
            let common = [number, ("settings", json(settings)), ("repair", (*repair).into())];
            let shape = match source {
                SurfaceSource::Preset { preset, boundary } => vec![("preset", json(&(preset, boundary)))],
                SurfaceSource::File { name, bytes } => {
                    vec![("name", name.into()), ("bytes", Uint8Array::from(bytes.as_slice()).into())]
                }
            };
            object(&[&common[..], &shape].concat())
        }
    }
}

/// What it reads; `None` if it is not what [`encode_request`] makes.
pub fn decode_request(message: &JsValue) -> Option<Request> {
    let task = if let Some(points) = get(message, "points") {
        let flat = Float64Array::from(points).to_vec();
        let points: Vec<DVec2> = flat.chunks_exact(2).map(DVec2::from_slice).collect();
        // checked where it was read: these are the vertices of a simple polygon
        Task::Outline { polygon: SimplePolygon::known_simple(points), settings: parsed(message, "settings")? }
    } else {
        let repair = get(message, "repair")?.as_bool()?;
        Task::Surface { source: decode_source(message)?, repair, settings: parsed(message, "settings")? }
    };
    Some(Request { generation: generation_of(message)?, task })
}

fn decode_source(message: &JsValue) -> Option<SurfaceSource> {
    if let Some((preset, boundary)) = parsed(message, "preset") {
        return Some(SurfaceSource::Preset { preset, boundary });
    }
    let bytes = Uint8Array::from(get(message, "bytes")?).to_vec();
    Some(SurfaceSource::File { name: get(message, "name")?.as_string()?, bytes: Arc::new(bytes) })
}

/// What a worker answers, and the buffers that go over with it.
pub fn encode_response(generation: u64, response: Response) -> (JsValue, Array) {
    let transfer = Array::new();
    let number = ("generation", JsValue::from(generation.to_string()));
    let message = match response {
        Response::Progress(stage) => object(&[number, ("stage", json(&stage))]),
        Response::Failed(failure) => object(&[number, ("failed", json(&failure))]),
        Response::Prepared(side, notes) => {
            let buffers = side.to_buffers();
            drop(side);
            object(&[&[number, ("notes", json(&notes))], &encode_buffers(buffers, &transfer)[..]].concat())
        }
    };
    (message, transfer)
}

/// Each array is freed as soon as it is copied: a large surface is there once and a half, not twice.
fn encode_buffers(buffers: FlatBuffers, transfer: &Array) -> [(&'static str, JsValue); 3] {
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
    [("floats", floats.into()), ("indices", indices.into()), ("text", buffers.text.into())]
}

fn decode_buffers(message: &JsValue) -> Option<FlatBuffers> {
    let floats = get(message, "floats")?.dyn_into::<Array>().ok()?;
    let indices = get(message, "indices")?.dyn_into::<Array>().ok()?;
    Some(FlatBuffers {
        floats: floats.iter().map(|array| Float64Array::from(array).to_vec()).collect(),
        indices: indices.iter().map(|array| Uint32Array::from(array).to_vec()).collect(),
        text: get(message, "text")?.as_string()?,
    })
}

/// What a worker is sent while nobody waits for it.
pub fn encode_rehearsal() -> JsValue {
    object(&[("rehearsal", true.into())])
}

/// Whether it reads that.
pub fn is_rehearsal(message: &JsValue) -> bool {
    get(message, "rehearsal").is_some()
}

/// What the worker of studies is sent.
pub fn encode_study(study: Study) -> JsValue {
    object(&[("study", json(&study))])
}

/// What it reads; `None` if it is not what [`encode_study`] makes.
pub fn decode_study(message: &JsValue) -> Option<Study> {
    parsed(message, "study")
}

/// What it answers.
pub fn encode_finding(study: Study, finding: &Finding) -> JsValue {
    object(&[("study", json(&study)), ("finding", json(finding))])
}

/// What the page reads; `None` if it is not what [`encode_finding`] makes.
pub fn decode_finding(message: &JsValue) -> Option<(Study, Finding)> {
    Some((decode_study(message)?, parsed(message, "finding")?))
}

/// What a worker says when it panics.
pub fn encode_death(reason: &str) -> JsValue {
    object(&[("died", reason.into())])
}

/// Why the worker died, if this message says so.
pub fn decode_death(message: &JsValue) -> Option<String> {
    get(message, "died")?.as_string()
}

/// What the page reads; `None` if it is not what [`encode_response`] makes.
pub fn decode_response(message: &JsValue) -> Option<(u64, Response)> {
    let generation = generation_of(message)?;
    let response = if let Some(stage) = parsed(message, "stage") {
        Response::Progress(stage)
    } else if let Some(failure) = parsed(message, "failed") {
        Response::Failed(failure)
    } else {
        let side = PreparedSide::from_buffers(decode_buffers(message)?)?;
        Response::Prepared(Box::new(side), parsed(message, "notes")?)
    };
    Some((generation, response))
}

fn generation_of(message: &JsValue) -> Option<u64> {
    get(message, "generation")?.as_string()?.parse().ok()
}

fn get(message: &JsValue, key: &str) -> Option<JsValue> {
    Reflect::get(message, &key.into()).ok().filter(|value| !value.is_undefined())
}

/// Plain data: it always has a form as text.
fn json(value: &impl Serialize) -> JsValue {
    serde_json::to_string(value).unwrap_or_default().into()
}

fn parsed<T: DeserializeOwned>(message: &JsValue, key: &str) -> Option<T> {
    serde_json::from_str(&get(message, key)?.as_string()?).ok()
}

fn object(fields: &[(&str, JsValue)]) -> JsValue {
    let object = Object::new();
    for (key, value) in fields {
        // Setting a plain property of a fresh object does not fail.
        let _ = Reflect::set(&object, &(*key).into(), value);
    }
    object.into()
}
