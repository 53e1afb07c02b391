// Keeps one build of the app for use without a network. `cargo xtask dist` puts `VERSION`, the name of
// the folder of this build, and `FILES`, everything that belongs to it, before these lines.
//
// A version is either there as a whole or not at all: its cache is filled before the worker may take
// over, the page is only taken with the folder that it names, and what is answered comes from one cache.

/* global VERSION, FILES */

/** Several copies of the app may live under one origin: each has caches of its own. */
const OURS = `riemap ${self.registration.scope} `;
const CACHE = OURS + VERSION;

const inScope = (path) => new URL(path, self.registration.scope).href;
/** Not by its name: some hosts send that elsewhere. */
const PAGE = inScope("");

async function install() {
  // before anything large, and while there is nothing to take back
  const page = await (await fetch(PAGE, { cache: "reload" })).text();
  if (!page.includes(`./${VERSION}/`)) throw new Error("the host has not changed over to this version yet");
  const cache = await caches.open(CACHE);
  await Promise.all(FILES.map((path) => fetchInto(cache, path)));
}

/** What has the version in its name never changes; the rest is asked for again. */
async function fetchInto(cache, path) {
  const fresh = path.startsWith(`${VERSION}/`) ? "default" : "reload";
  const response = await fetch(inScope(path), { cache: fresh });
  if (!response.ok) throw new Error(`${path}: ${response.status}`);
  const isPage = response.headers.get("content-type")?.startsWith("text/html");
  if (isPage && path.startsWith(`${VERSION}/`)) throw new Error(`${path}: there is a page in its place`);
  // a page may not be answered with what was redirected
  const plain = response.redirected ? new Response(await response.blob(), { headers: response.headers }) : response;
  await cache.put(inScope(path), plain);
}

async function activate() {
  const names = await caches.keys();
  const old = names.filter((name) => name.startsWith(OURS) && name !== CACHE);
  await Promise.all(old.map((name) => caches.delete(name)));
  await self.clients.claim();
}

/** The address of the kept file that a request means. */
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
