// Caches one build of the app for offline use. `cargo xtask dist` inserts `VERSION`, the name of
// the folder of this build, and `FILES`, the list of its files, before these lines.
//
// A version is cached completely or not at all: its cache is filled before the worker may take over,
// the page is accepted only if it names the folder of this version, and all answers come from one cache.

/* global VERSION, FILES */

/** One origin may host several copies of the app: each has its own caches. */
const OURS = `riemap ${self.registration.scope} `;
const CACHE = OURS + VERSION;

const inScope = (path) => new URL(path, self.registration.scope).href;
/** The folder's address, not `index.html`: some hosts redirect the latter. */
const PAGE = inScope("");

async function install() {
  // checked first: nothing large has been fetched, and nothing needs to be undone
  const page = await (await fetch(PAGE, { cache: "reload" })).text();
  if (!page.includes(`./${VERSION}/`)) throw new Error("the host has not changed over to this version yet");
  const cache = await caches.open(CACHE);
  await Promise.all(FILES.map((path) => fetchInto(cache, path)));
}

/** Files under the version's name never change; all others are fetched again. */
async function fetchInto(cache, path) {
  const fresh = path.startsWith(`${VERSION}/`) ? "default" : "reload";
  const response = await fetch(inScope(path), { cache: fresh });
  if (!response.ok) throw new Error(`${path}: ${response.status}`);
  const isPage = response.headers.get("content-type")?.startsWith("text/html");
  if (isPage && path.startsWith(`${VERSION}/`)) throw new Error(`${path}: there is a page in its place`);
  // browsers refuse a redirected response as the answer to a page request
  const plain = response.redirected ? new Response(await response.blob(), { headers: response.headers }) : response;
  await cache.put(inScope(path), plain);
}

async function activate() {
  const names = await caches.keys();
  const old = names.filter((name) => name.startsWith(OURS) && name !== CACHE);
  await Promise.all(old.map((name) => caches.delete(name)));
  await self.clients.claim();
}

/** The address of the cached file for a request: without query and fragment. */
function kept(request) {
  const address = new URL(request.url);
  address.search = "";
  address.hash = "";
  return address.href === inScope("index.html") ? PAGE : address.href;
}

async function answer(request) {
  return (await caches.match(kept(request), { cacheName: CACHE })) ?? fetch(request);
}

self.addEventListener("install", (event) => event.waitUntil(install()));
self.addEventListener("activate", (event) => event.waitUntil(activate()));
self.addEventListener("message", (event) => event.data === "take over" && self.skipWaiting());
self.addEventListener("fetch", (event) => {
  if (event.request.method === "GET" && event.request.url.startsWith(self.registration.scope)) {
    event.respondWith(answer(event.request));
  }
});
