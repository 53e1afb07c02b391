//! The page's side of the two workers.
//!
//! A request to a busy worker supersedes what it is doing: the worker is
//! terminated and another one takes its place (the module is compiled already).
//! A worker that dies is reported and replaced with the next request.

use super::messages;
use crate::conformal::Side;
use crate::platform::{Event, Mailbox};
use crate::worker::{Request, Response};
use js_sys::{Object, Reflect};
use std::cell::Cell;
use std::rc::Rc;
use wasm_bindgen::prelude::{Closure, wasm_bindgen};
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{ErrorEvent, MessageEvent, Worker, WorkerOptions, WorkerType};

#[wasm_bindgen]
extern "C" {
    /// The address of the glue that runs this module.
    #[wasm_bindgen(thread_local_v2, js_namespace = ["import", "meta"], js_name = url)]
    static GLUE_URL: String;
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    Idle,
    Busy,
    Dead,
}

struct Engine {
    worker: Worker,
    state: Rc<Cell<State>>,
    _on_message: Closure<dyn FnMut(MessageEvent)>,
    _on_error: Closure<dyn FnMut(ErrorEvent)>,
}

/// Runs preparations in two workers, one per side.
pub struct Preparer {
    mailbox: Mailbox,
    engines: [Option<Engine>; 2],
}

impl Preparer {
    /// Answers go to `mailbox`. The workers start at once, to be ready for the first request.
    pub fn new(mailbox: Mailbox) -> Self {
        let mut preparer = Self { mailbox, engines: [None, None] };
        for side in [Side::Source, Side::Target] {
            preparer.ensure_idle(side);
        }
        preparer
    }

    /// Starts to carry out `request`, in place of what the side's worker may be doing.
    #[allow(clippy::needless_pass_by_value, reason = "on the desktop it goes into a thread")]
    pub fn request(&mut self, side: Side, request: Request) {
        let Some(engine) = self.ensure_idle(side) else { return };
        engine.state.set(State::Busy);
        if let Err(error) = engine.worker.post_message(&messages::encode_request(&request)) {
            engine.state.set(State::Dead);
            self.mailbox.post(Event::WorkerDied { side, reason: describe(&error) });
        }
    }

    fn ensure_idle(&mut self, side: Side) -> Option<&Engine> {
        let slot = &mut self.engines[side as usize];
        if let Some(engine) = slot.take_if(|engine| engine.state.get() != State::Idle) {
            engine.worker.terminate();
        }
        if slot.is_none() {
            match Engine::start(side, &self.mailbox) {
                Ok(engine) => *slot = Some(engine),
                Err(error) => self.mailbox.post(Event::WorkerDied { side, reason: describe(&error) }),
            }
        }
        slot.as_ref()
    }
}

impl Engine {
    fn start(side: Side, mailbox: &Mailbox) -> Result<Self, JsValue> {
        let options = WorkerOptions::new();
        options.set_type(WorkerType::Module);
        let worker = Worker::new_with_options("./worker.js", &options)?;
        let state = Rc::new(Cell::new(State::Idle));
        let on_message = listen(side, mailbox.clone(), Rc::clone(&state));
        let on_error = watch(side, mailbox.clone(), Rc::clone(&state));
        worker.set_onmessage(Some(on_message.as_ref().unchecked_ref()));
        worker.set_onerror(Some(on_error.as_ref().unchecked_ref()));
        worker.post_message(&bootstrap()?)?;
        Ok(Self { worker, state, _on_message: on_message, _on_error: on_error })
    }
}

fn listen(side: Side, mailbox: Mailbox, state: Rc<Cell<State>>) -> Closure<dyn FnMut(MessageEvent)> {
    Closure::new(move |event: MessageEvent| {
        let message = event.data();
        let Some((generation, response)) = messages::decode_response(&message) else {
            let unreadable = || String::from("its answer could not be read");
            state.set(State::Dead);
            let reason = messages::decode_death(&message).unwrap_or_else(unreadable);
            mailbox.post(Event::WorkerDied { side, reason });
            return;
        };
        if !matches!(response, Response::Progress(_)) {
            state.set(State::Idle);
        }
        mailbox.post(Event::Worker { side, generation, response });
    })
}

fn watch(side: Side, mailbox: Mailbox, state: Rc<Cell<State>>) -> Closure<dyn FnMut(ErrorEvent)> {
    Closure::new(move |event: ErrorEvent| {
        event.prevent_default();
        state.set(State::Dead);
        let message = event.message();
        let reason = if message.is_empty() { String::from("its script could not be loaded") } else { message };
        mailbox.post(Event::WorkerDied { side, reason });
    })
}

fn bootstrap() -> Result<JsValue, JsValue> {
    let message = Object::new();
    Reflect::set(&message, &"glue".into(), &GLUE_URL.with(String::clone).into())?;
    Reflect::set(&message, &"module".into(), &wasm_bindgen::module())?;
    Ok(message.into())
}

fn describe(error: &JsValue) -> String {
    error.dyn_ref::<js_sys::Error>().map_or_else(|| format!("{error:?}"), |error| String::from(error.message()))
}
