// An example of a page that shows riemap in a frame and talks to it. Free to copy.

const frame = document.getElementById("map");
const keep = document.getElementById("keep");
const back = document.getElementById("back");
const done = document.getElementById("done");
const heard = document.getElementById("heard");

// The origin of the app; if another host serves it, that host's, such as "https://maps.example.org".
const APP = new URL(frame.src).origin;

const waiting = new Map();
let last = 0;

/** Sends a request to the frame; resolves with its answer, or rejects with the reason why it was refused. */
function ask(type, fields = {}) {
  const id = ++last;
  frame.contentWindow.postMessage({ riemap: 1, type, id, ...fields }, APP);
  return new Promise((resolve, reject) => waiting.set(id, { resolve, reject }));
}

window.addEventListener("message", ({ source, origin, data }) => {
  if (source !== frame.contentWindow || origin !== APP || data?.riemap !== 1) return;
  const asked = waiting.get(data.id);
  if (asked) {
    waiting.delete(data.id);
    if (data.ok) asked.resolve(data);
    else asked.reject(new Error(data.error));
  } else {
    heard.textContent = data.type === "error" ? `error: ${data.error}` : data.type;
  }
});

let kept = null;

keep.addEventListener("click", async () => {
  ({ session: kept } = await ask("get-session"));
  back.disabled = false;
  done.textContent = "the map is kept";
});

back.addEventListener("click", async () => {
  await ask("set-session", { session: kept });
  done.textContent = "the map is back";
});
