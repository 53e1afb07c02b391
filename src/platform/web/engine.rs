//! The worker's side: requests in, answers out, one at a time.

use super::messages;
use crate::worker;
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::Closure;
use web_sys::{DedicatedWorkerGlobalScope, MessageEvent};

/// Answers every request that is posted to this worker, until it is terminated.
pub fn listen(scope: &DedicatedWorkerGlobalScope) {
    std::panic::set_hook(Box::new(|info| {
        console_error_panic_hook::hook(info);
        if let Ok(scope) = js_sys::global().dyn_into::<DedicatedWorkerGlobalScope>() {
            // The page also hears of the trap that follows, but not of its cause.
            let _ = scope.post_message(&messages::encode_death(&info.to_string()));
        }
    }));
    let answer = {
        let scope = scope.clone();
        Closure::<dyn FnMut(MessageEvent)>::new(move |event: MessageEvent| {
            if let Some(study) = messages::decode_study(&event.data()) {
                if let Err(error) = scope.post_message(&messages::encode_finding(study, &study.run())) {
                    wasm_bindgen::throw_val(error);
                }
                return;
            }
            if messages::is_rehearsal(&event.data()) {
                worker::run(&worker::rehearsal(), &mut |generation, response| {
                    // the way of the answer is rehearsed too
                    messages::encode_response(generation, response);
                });
                return;
            }
            let Some(request) = messages::decode_request(&event.data()) else {
                log::error!("a request of an unknown form was dropped");
                return;
            };
            worker::run(&request, &mut |generation, response| {
                let (message, transfer) = messages::encode_response(generation, response);
                if let Err(error) = scope.post_message_with_transfer(&message, &transfer) {
                    // Thrown out of the message handler it reaches the page as the worker's error.
                    wasm_bindgen::throw_val(error);
                }
            });
        })
    };
    scope.set_onmessage(Some(answer.as_ref().unchecked_ref()));
    answer.forget();
}
