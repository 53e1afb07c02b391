// Starts the engine in a worker. The first message contains the address of the
// page's glue and its compiled module; messages that arrive before the engine
// listens are stored and delivered in order.
const early = [];
const keep = (event) => early.push(event.data);

// A lock is held until the worker ends: the page notices by it that a worker was terminated. Where there are no locks,
// the page only hears that the worker runs.
function hold(name) {
  const { locks } = globalThis.navigator ?? {};
  if (!locks) return self.postMessage({ locked: false });
  locks.request(name, () => {
    self.postMessage({ locked: true });
    return new Promise(() => {});
  }).catch(() => self.postMessage({ locked: false }));
}

async function boot({ data: { glue, module, lock } }) {
  hold(lock);
  self.addEventListener("message", keep);
  const { default: init } = await import(glue);
  await init({ module_or_path: module });
  self.removeEventListener("message", keep);
  for (const data of early) self.dispatchEvent(new MessageEvent("message", { data }));
}

self.addEventListener(
  "message",
  // A rejected promise would not reach the page; a thrown error does.
  (event) => boot(event).catch((error) => setTimeout(() => { throw error; })),
  { once: true },
);
