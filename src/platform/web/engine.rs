//! The worker's side: receives requests and posts responses, one request at a time.

use super::messages;
use crate::language::{Message, key};
use crate::worker::{self, Advance, Finding, Study};
use wasm_bindgen::prelude::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{DedicatedWorkerGlobalScope, MessageEvent};

/// Responds to every request posted to this worker until it is terminated.
pub fn listen(scope: &DedicatedWorkerGlobalScope) {
    std::panic::set_hook(Box::new(|info| {
        console_error_panic_hook::hook(info);
        if let Ok(scope) = js_sys::global().dyn_into::<DedicatedWorkerGlobalScope>() {
            // the page also gets an error event for the trap that follows, but without the cause
            let _ = scope.post_message(&messages::encode_death(&info.to_string()));
        }
    }));
    let on_message = {
        let scope = scope.clone();
        Closure::<dyn FnMut(MessageEvent)>::new(move |event: MessageEvent| {
            if let Some(study) = messages::decode_study(&event.data()) {
                run(&scope, &study);
                return;
            }
            if messages::is_rehearsal(&event.data()) {
                worker::run(&worker::rehearsal(), &mut |generation, response| {
                    // encoding the response is part of the rehearsal
                    messages::encode_response(generation, response);
                });
                return;
            }
            answer(&scope, &event.data());
        })
    };
    scope.set_onmessage(Some(on_message.as_ref().unchecked_ref()));
    on_message.forget();
}

/// Runs a study and posts its findings. It is cancelled by terminating the worker.
fn run(scope: &DedicatedWorkerGlobalScope, study: &Study) {
    let post = |finding: &Finding| {
        if let Err(error) = scope.post_message(&messages::encode_finding(finding)) {
            wasm_bindgen::throw_val(error);
        }
    };
    let mut advance = Advance::default();
    let finding = study.run(&mut |done| {
        if advance.selects(done) {
            post(&Finding::Progress(done));
        }
        true
    });
    finding.iter().for_each(post);
}

/// Responds to a request; to one that cannot be read, as a panic does: the page waits no longer and starts another
/// worker.
fn answer(scope: &DedicatedWorkerGlobalScope, message: &JsValue) {
    let Some(request) = messages::decode_request(message) else {
        let reason = Message::from(key::request_unreadable()).english();
        if let Err(error) = scope.post_message(&messages::encode_death(&reason)) {
            wasm_bindgen::throw_val(error);
        }
        return;
    };
    worker::run(&request, &mut |generation, response| {
        let (message, transfer) = messages::encode_response(generation, response);
        if let Err(error) = scope.post_message_with_transfer(&message, &transfer) {
            // thrown out of the message handler, the error reaches the page as the worker's error event
            wasm_bindgen::throw_val(error);
        }
    });
}
