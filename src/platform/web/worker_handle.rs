//! The page's handle of a web worker, which runs the page's module and is terminated when the handle is dropped.

use super::messages;
use crate::language::{Message, key};
use crate::platform::{Event, Mailbox};
use js_sys::{Array, Object, Promise, Reflect};
use std::cell::Cell;
use std::rc::Rc;
use wasm_bindgen::prelude::{Closure, wasm_bindgen};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;
use web_sys::{ErrorEvent, MessageEvent, Worker, WorkerOptions, WorkerType};

#[wasm_bindgen]
extern "C" {
    /// The address of the glue that runs this module.
    #[wasm_bindgen(thread_local_v2, js_namespace = ["import", "meta"], js_name = url)]
    static GLUE_URL: String;

    /// A promise that is kept when no worker holds the lock of this name any more.
    #[wasm_bindgen(catch, js_namespace = riemapLocks, js_name = released)]
    fn released(name: &str) -> Result<Promise, JsValue>;
}

/// The state of a worker.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum State {
    /// Waiting for a request.
    Idle,
    /// Working on a request.
    Busy,
    /// Stopped; the handle can no longer be used.
    Dead,
}

/// A decoded message of a worker.
pub struct Heard {
    /// The event for the app.
    pub event: Event,
    /// Whether the worker is still working on the same request.
    pub goes_on: bool,
}

/// A handle of a running worker.
pub struct WorkerHandle {
    worker: Worker,
    state: Rc<Cell<State>>,
    has_started: Rc<Cell<bool>>,
    _on_message: Closure<dyn FnMut(MessageEvent)>,
    _on_error: Closure<dyn FnMut(ErrorEvent)>,
}

impl WorkerHandle {
    /// Starts a worker. `read` decodes its messages, `died` makes an event when it stops; both go to `mailbox`.
    pub fn start(
        mailbox: &Mailbox,
        read: impl Fn(&JsValue) -> Option<Heard> + 'static,
        died: impl Fn(Message) -> Event + Clone + 'static,
    ) -> Result<Self, JsValue> {
        let options = WorkerOptions::new();
        options.set_type(WorkerType::Module);
        let script = web_sys::Url::new_with_base("./worker.js", &GLUE_URL.with(String::clone))?.href();
        let worker = Worker::new_with_options(&script, &options)?;
        let state = Rc::new(Cell::new(State::Idle));
        let lock =
            format!("riemap-worker-{:x}-{:x}", js_sys::Date::now() as u64, (js_sys::Math::random() * 1e9) as u64);
        let has_started = Rc::new(Cell::new(false));
        let starts = {
            let (mailbox, state, died, lock) = (mailbox.clone(), Rc::clone(&state), died.clone(), lock.clone());
            let has_started = Rc::clone(&has_started);
            move |is_locked| {
                has_started.set(true);
                let died = died.clone();
                let death = move || died(key::worker_ended().into());
                if is_locked {
                    report_end(mailbox.clone(), Rc::clone(&state), death, lock.clone());
                }
            }
        };
        let on_message = listen(mailbox.clone(), Rc::clone(&state), (read, starts), died.clone());
        let on_error = watch(mailbox.clone(), Rc::clone(&state), died);
        worker.set_onmessage(Some(on_message.as_ref().unchecked_ref()));
        worker.set_onerror(Some(on_error.as_ref().unchecked_ref()));
        worker.post_message(&bootstrap(&lock)?)?;
        Ok(Self { worker, state, has_started, _on_message: on_message, _on_error: on_error })
    }

    /// Whether it has said that it runs.
    pub fn has_started(&self) -> bool {
        self.has_started.get()
    }

    /// The state of the worker.
    pub fn state(&self) -> State {
        self.state.get()
    }

    /// Sends a rehearsal. A failure is ignored: the next request would only be slower.
    pub fn rehearse(&self) {
        let _ = self.worker.post_message(&messages::encode_rehearsal());
    }

    /// Sends a request, and transfers the buffers of `transfer` with it. The error is the reason why the message could
    /// not be posted.
    pub fn post(&self, message: &JsValue, transfer: &Array) -> Result<(), String> {
        self.state.set(State::Busy);
        self.worker.post_message_with_transfer(message, transfer).map_err(|error| {
            self.state.set(State::Dead);
            describe(&error)
        })
    }
}

impl Drop for WorkerHandle {
    fn drop(&mut self) {
        // its end is not reported then
        self.state.set(State::Dead);
        self.worker.terminate();
    }
}

/// Reports the end of a worker that does not say so itself, because the browser or a person has terminated it: a worker
/// holds a lock as long as it lives. Browsers without locks leave it to the app to notice the silence.
fn report_end(mailbox: Mailbox, state: Rc<Cell<State>>, death: impl Fn() -> Event + 'static, lock: String) {
    wasm_bindgen_futures::spawn_local(async move {
        let Ok(released) = released(&lock) else { return };
        let is_released = JsFuture::from(released).await.is_ok();
        // an idle worker is replaced with the next request
        if is_released && state.replace(State::Dead) == State::Busy {
            mailbox.post(death());
        }
    });
}

fn listen(
    mailbox: Mailbox,
    state: Rc<Cell<State>>,
    (read, starts): (impl Fn(&JsValue) -> Option<Heard> + 'static, impl Fn(bool) + 'static),
    died: impl Fn(Message) -> Event + 'static,
) -> Closure<dyn FnMut(MessageEvent)> {
    Closure::new(move |event: MessageEvent| {
        let message = event.data();
        if let Some(is_locked) = messages::decode_start(&message) {
            starts(is_locked);
            return;
        }
        let Some(Heard { event, goes_on }) = read(&message) else {
            let reason =
                messages::decode_death(&message).map_or_else(|| key::answer_unreadable().into(), Message::from);
            state.set(State::Dead);
            mailbox.post(died(reason));
            return;
        };
        if !goes_on {
            state.set(State::Idle);
        }
        mailbox.post(event);
    })
}

fn watch(
    mailbox: Mailbox,
    state: Rc<Cell<State>>,
    died: impl Fn(Message) -> Event + 'static,
) -> Closure<dyn FnMut(ErrorEvent)> {
    Closure::new(move |event: ErrorEvent| {
        event.prevent_default();
        state.set(State::Dead);
        let message = event.message();
        mailbox.post(died(if message.is_empty() { key::script_not_loaded().into() } else { message.into() }));
    })
}

fn bootstrap(lock: &str) -> Result<JsValue, JsValue> {
    let message = Object::new();
    Reflect::set(&message, &"lock".into(), &lock.into())?;
    Reflect::set(&message, &"glue".into(), &GLUE_URL.with(String::clone).into())?;
    Reflect::set(&message, &"module".into(), &wasm_bindgen::module())?;
    Ok(message.into())
}

/// The browser's description of an error.
impl From<JsValue> for Message {
    fn from(error: JsValue) -> Self {
        describe(&error).into()
    }
}

/// The message of a JavaScript error, or the text that riemap threw itself.
pub fn describe(error: &JsValue) -> String {
    let message = error.dyn_ref::<js_sys::Error>().map(|error| String::from(error.message()));
    message.or_else(|| error.as_string()).unwrap_or_else(|| format!("{error:?}"))
}
