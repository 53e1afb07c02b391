// The messages between the app in a frame and the page around it (web/embedding.md), and the
// link that opens the same session in its own window.
//
// Only messages of the page around the frame are accepted and answered. No message can do more than
// `riemap.open_session`, which checks sessions as if they came from a file.
import { words } from "./words.js";

/** The version of the message format. */
const VERSION = 1;
/** The least time between two `session-changed` messages. */
const CHANGE_PAUSE_MS = 250;

/** Begins to listen for messages, if the app is in a frame. */
export function embedded() {
  const query = new URLSearchParams(location.search);
  if (query.has("embed")) openLink();
  if (window.parent === window) return;
  const tell = (type, fields) => window.parent.postMessage({ riemap: VERSION, type, ...fields }, "*");
  window.addEventListener("message", (event) => {
    if (event.source !== window.parent || !isRequest(event.data)) return;
    // a page with an opaque origin, such as a local file, can only be addressed by "*"
    const origin = event.origin === "null" ? "*" : event.origin;
    event.source.postMessage({ riemap: VERSION, id: event.data.id ?? null, ...answer(event.data) }, origin);
  });
  tellChanges(tell);
  window.addEventListener("riemap-ready", () => tell("ready", {}), { once: true });
}

const isRequest = (data) => typeof data === "object" && data !== null && "riemap" in data;

/** The answer: `ok` and, depending on the type of the request, the session or the error. */
function answer(request) {
  try {
    if (request.riemap !== VERSION) return refused(`this is version ${VERSION} of the messages`);
    const session = window.riemap?.session();
    if (session === undefined) return refused("the app is not there yet, or has stopped");
    if (request.type === "get-session") return { ok: true, session, link: window.riemap.link() };
    if (request.type === "set-session") return set(request);
    return refused(`there is no message of the type ${JSON.stringify(request.type)}`);
  } catch (error) {
    return refused(String(error));
  }
}

function set({ session, link }) {
  if ((session === undefined) === (link === undefined)) return refused("set-session takes a session or a link");
  const refusal = session === undefined ? window.riemap.open_link(String(link)) : window.riemap.open_session(session);
  if (refusal === undefined) return refused("the app has stopped");
  return refusal === null ? { ok: true } : refused(refusal);
}

const refused = (error) => ({ ok: false, error });

/** Passes the app's events on: an error at once, a change of the session at most every `CHANGE_PAUSE_MS`. */
function tellChanges(tell) {
  let due = null;
  window.addEventListener("riemap-session", () => {
    due ??= setTimeout(() => {
      due = null;
      tell("session-changed", { session: window.riemap.session(), link: window.riemap.link() });
    }, CHANGE_PAUSE_MS);
  });
  window.addEventListener("riemap-error", ({ detail }) => tell("error", { error: detail }));
}

/** The link to the same session, without the options that apply to the frame only. */
function openLink() {
  const link = document.getElementById("open-in-riemap");
  link.textContent = `${words.open} ↗`;
  const renew = () => {
    const address = new URL(location.href);
    for (const option of ["embed", "lock"]) address.searchParams.delete(option);
    link.href = address.href;
  };
  renew();
  window.addEventListener("riemap-session", renew);
  link.hidden = false;
}
