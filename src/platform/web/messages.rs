//! Requests and answers as JavaScript values: flat arrays, transferred, not copied.
//!
//! A request is `{ generation, points, settings }`, an answer `{ generation }`
//! with one of `stage`, `failed`, or `floats` and `indices`; a study is `{ study }`,
//! what it found `{ study, finding }`; a panic's last word
//! is `{ died }`. Small enums travel as JSON text in the form that serde gives them.

use crate::conformal::{DomainBuffers, PreparedDomain};
use crate::geometry::{DVec2, SimplePolygon};
use crate::worker::{Finding, Request, Response, Study};
use js_sys::{Array, Float64Array, Object, Reflect, Uint32Array};
use wasm_bindgen::{JsCast, JsValue};

/// What a worker is sent.
pub fn encode_request(request: &Request) -> JsValue {
    let flat: Vec<f64> = request.polygon.vertices().iter().flat_map(DVec2::to_array).collect();
    let settings = serde_json::to_string(&request.settings).unwrap_or_default();
    object(&[
        ("generation", request.generation.to_string().into()),
        ("points", Float64Array::from(flat.as_slice()).into()),
        ("settings", settings.into()),
    ])
}

/// What it reads; `None` if it is not what [`encode_request`] makes.
pub fn decode_request(message: &JsValue) -> Option<Request> {
    let flat = Float64Array::from(get(message, "points")?).to_vec();
    let points: Vec<DVec2> = flat.chunks_exact(2).map(DVec2::from_slice).collect();
    Some(Request {
        generation: generation_of(message)?,
        polygon: SimplePolygon::try_from(points).ok()?,
        settings: serde_json::from_str(&get(message, "settings")?.as_string()?).ok()?,
    })
}

/// What a worker answers, and the buffers that go over with it.
pub fn encode_response(generation: u64, response: Response) -> (JsValue, Array) {
    let transfer = Array::new();
    let number = ("generation", JsValue::from(generation.to_string()));
    let message = match response {
        Response::Progress(stage) => {
            object(&[number, ("stage", serde_json::to_string(&stage).unwrap_or_default().into())])
        }
        Response::Failed(reason) => object(&[number, ("failed", reason.into())]),
        Response::Prepared(domain) => {
            let buffers = domain.to_buffers();
            let floats = Array::new();
            for values in &buffers.floats {
                let array = Float64Array::from(values.as_slice());
                transfer.push(&array.buffer());
                floats.push(&array);
            }
            let indices = Array::new();
            for values in &buffers.indices {
                let array = Uint32Array::from(values.as_slice());
                transfer.push(&array.buffer());
                indices.push(&array);
            }
            object(&[number, ("floats", floats.into()), ("indices", indices.into())])
        }
    };
    (message, transfer)
}

/// What the laboratory's worker is sent.
pub fn encode_study(study: Study) -> JsValue {
    object(&[("study", serde_json::to_string(&study).unwrap_or_default().into())])
}

/// What it reads; `None` if it is not what [`encode_study`] makes.
pub fn decode_study(message: &JsValue) -> Option<Study> {
    serde_json::from_str(&get(message, "study")?.as_string()?).ok()
}

/// What it answers.
pub fn encode_finding(study: Study, finding: &Finding) -> JsValue {
    let finding = serde_json::to_string(finding).unwrap_or_default();
    object(&[("study", serde_json::to_string(&study).unwrap_or_default().into()), ("finding", finding.into())])
}

/// What the page reads; `None` if it is not what [`encode_finding`] makes.
pub fn decode_finding(message: &JsValue) -> Option<(Study, Finding)> {
    Some((decode_study(message)?, serde_json::from_str(&get(message, "finding")?.as_string()?).ok()?))
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
    if let Some(stage) = get(message, "stage") {
        return Some((generation, Response::Progress(serde_json::from_str(&stage.as_string()?).ok()?)));
    }
    if let Some(reason) = get(message, "failed") {
        return Some((generation, Response::Failed(reason.as_string()?)));
    }
    let floats = get(message, "floats")?.dyn_into::<Array>().ok()?;
    let indices = get(message, "indices")?.dyn_into::<Array>().ok()?;
    let buffers = DomainBuffers {
        floats: floats.iter().map(|array| Float64Array::from(array).to_vec()).collect(),
        indices: indices.iter().map(|array| Uint32Array::from(array).to_vec()).collect(),
    };
    Some((generation, Response::Prepared(Box::new(PreparedDomain::from_buffers(buffers)?))))
}

fn generation_of(message: &JsValue) -> Option<u64> {
    get(message, "generation")?.as_string()?.parse().ok()
}

fn get(message: &JsValue, key: &str) -> Option<JsValue> {
    Reflect::get(message, &key.into()).ok().filter(|value| !value.is_undefined())
}

fn object(fields: &[(&str, JsValue)]) -> JsValue {
    let object = Object::new();
    for (key, value) in fields {
        // Setting a plain property of a fresh object does not fail.
        let _ = Reflect::set(&object, &(*key).into(), value);
    }
    object.into()
}
