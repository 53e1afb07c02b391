// Starts the app: checks whether the browser can run it before anything large is fetched,
// shows the progress of the download, and explains what is missing if it cannot run.
import { installed } from "./installed.js";
import { embedded } from "./embedded.js";
import { locks } from "./locks.js";
import { plainWords } from "./plain.js";
import { store } from "./store.js";
import { words } from "./words.js";

globalThis.riemapBegins = true; // for `old.js`

const element = (id) => document.getElementById(id);

/** A module of one function that returns a vector: the app is compiled with SIMD instructions. */
const VECTORS = Uint8Array.of(
  0, 97, 115, 109, 1, 0, 0, 0, // magic, version
  1, 5, 1, 96, 0, 1, 123, // types: () → v128
  3, 2, 1, 0, // functions: one of the first type
  10, 8, 1, 6, 0, 65, 0, 253, 15, 11, // code: i32.const 0, i8x16.splat
);

/** Whether the download can be counted and unpacked while it arrives. */
const hasStreams = () =>
  typeof TransformStream === "function" && typeof ReadableStream === "function" && "pipeThrough" in ReadableStream.prototype;

/** Whether workers can be modules: such a browser asks for their type first, and then starts none. */
function hasModuleWorkers() {
  let asked = false;
  const options = { get type() { asked = true; throw new Error("asked"); } };
  try {
    new Worker(new URL("worker.js", import.meta.url), options).terminate();
  } catch { /* it has asked, or there are no workers */ }
  return asked;
}

/** What the browser lacks, as a key of `words`, or null. */
async function missing() {
  if (typeof WebAssembly !== "object" || !WebAssembly.validate(VECTORS)) return "program";
  if (!hasStreams() || !hasModuleWorkers()) return "program";
  const context = document.createElement("canvas").getContext("webgl2");
  // released at once: browsers allow few contexts at a time
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  if (context) return null;
  const adapter = await navigator.gpu?.requestAdapter().catch(() => null);
  return adapter ? null : "graphics";
}

/** The program as a response; `cargo xtask dist` packs it and notes its packed length. */
async function program() {
  const bar = element("loading-bar");
  const packed = Number(bar?.dataset.bytes);
  const name = packed ? "riemap_bg.wasm.packed" : "riemap_bg.wasm";
  const response = await fetch(new URL(name, import.meta.url));
  if (!response.ok) throw new Error(`${response.url}: ${response.status} ${response.statusText}`);
  const counted = response.body.pipeThrough(counter(bar, packed));
  const body = packed ? counted.pipeThrough(await unpacking()) : counted;
  return new Response(body, { headers: { "content-type": "application/wasm" } });
}

/** Unpacks what passes, while the rest is on its way. */
async function unpacking() {
  const [{ default: init, Unpacker }, program] = await Promise.all([
    import("./unpacker.js"),
    fetch(new URL("unpacker_bg.wasm", import.meta.url)),
  ]);
  // its bytes, not the response: some hosts do not know the type of the file
  await init({ module_or_path: program.arrayBuffer() });
  const unpacker = new Unpacker();
  return new TransformStream({
    transform: (chunk, controller) => controller.enqueue(unpacker.unpack(chunk)),
    flush: (controller) => controller.enqueue(unpacker.finish()),
  });
}

/** Shows the progress of the download; `total` is its length in bytes, 0 if unknown. */
function counter(bar, total) {
  let current = 0;
  return new TransformStream({
    transform(chunk, controller) {
      current += chunk.byteLength;
      if (total && bar) bar.value = Math.min(current / total, 1);
      const text = element("loading-text");
      if (text) text.textContent = `${words.loading} ${megabytes(current)}${total ? ` / ${megabytes(total)}` : ""} MB`;
      controller.enqueue(chunk);
    },
    flush() {
      const text = element("loading-text");
      if (text) text.textContent = words.starting;
    },
  });
}

const digits = { minimumFractionDigits: 1, maximumFractionDigits: 1 };
const megabytes = (bytes) => (bytes / 1e6).toLocaleString(words.language, digits);

function fail(text) {
  element("loading")?.remove();
  element("failure-text").textContent = text;
  element("failure").hidden = false;
}

// In Chromium's device emulation an element's size in device pixels lacks the
// emulated pixel ratio: the app would be drawn too large and touched in the
// wrong places. Without that property, size and ratio are used instead.
function distrustEmulatedPixels() {
  const name = "devicePixelContentBoxSize";
  if (!(globalThis.ResizeObserverEntry && name in ResizeObserverEntry.prototype)) return;
  const observer = new ResizeObserver(([entry]) => {
    observer.disconnect();
    const reported = entry[name][0].inlineSize;
    const expected = entry.contentBoxSize[0].inlineSize * devicePixelRatio;
    if (Math.abs(reported - expected) > 2) delete ResizeObserverEntry.prototype[name];
  });
  observer.observe(document.documentElement, { box: "device-pixel-content-box" });
}

async function start() {
  document.documentElement.lang = words.language;
  document.title = words.title;
  element("loading-text").textContent = words.loading;
  for (const id of ["failure-reload", "update-reload"]) element(id).textContent = words.reload;
  element("failure-reload").addEventListener("click", () => location.reload());
  const lack = await missing();
  if (lack) {
    plainWords(lack);
    return;
  }
  distrustEmulatedPixels();
  const [glue, compiled] = await Promise.all([import("./riemap.js"), program()]);
  embedded();
  globalThis.riemapStore = store;
  globalThis.riemapLocks = locks;
  await glue.default({ module_or_path: compiled });
  await installed();
}

start().catch((error) => fail(`${words.notLoaded} (${error})`));
