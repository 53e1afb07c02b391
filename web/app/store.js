// Keeps sessions in the browser's database: each visit (an opened session) is a record that lists its parts; the parts
// (documents, files of surfaces, pictures) are stored once under a key made of their content.
//
// The program calls these functions as `riemapStore`. Every change is one transaction: after a crash the former or the
// new state is there, never a mixture.

const NAME = "riemap";
/** The visits that are kept, the newest; older ones and the parts that only they use are removed. */
const MOST_VISITS = 12;
/** How long the database may take to open, in ms: without it the app starts with what the address says. */
const OPENS_WITHIN = 3000;

/** How long a lock may take that another tab holds, in ms: that of a page that is being reloaded is released late. */
const RELEASED_WITHIN = 300;

let opened = null;
/** Visits that this tab holds, or is asking for, with the promise of the answer. */
const held = new Map();

/** The result of a request, as a promise. */
const result = (request) => new Promise((resolve, reject) => {
  request.onsuccess = () => resolve(request.result);
  request.onerror = () => reject(request.error);
});

function database() {
  opened ??= new Promise((resolve, reject) => {
    if (!globalThis.indexedDB) throw new Error("no-database");
    setTimeout(() => reject(new Error("no-database")), OPENS_WITHIN);
    const request = indexedDB.open(NAME, 1);
    request.onupgradeneeded = () => {
      request.result.createObjectStore("visits", { keyPath: "id" });
      request.result.createObjectStore("parts");
    };
    request.onsuccess = () => {
      // another tab with a newer version of the app can then change the database
      request.result.onversionchange = () => request.result.close();
      resolve(request.result);
    };
    request.onerror = () => reject(request.error);
  });
  return opened;
}

/** Takes a visit for this tab while it is open. Resolves to whether no other tab has it; without locks, to true. */
function hold(id) {
  const ask = () => new Promise((resolve) => {
    if (!navigator.locks) return resolve(true);
    const late = new AbortController();
    setTimeout(() => late.abort(), RELEASED_WITHIN);
    const keep = () => {
      resolve(true);
      return new Promise(() => {});
    };
    return navigator.locks.request(`riemap visit ${id}`, { signal: late.signal }, keep).catch(() => resolve(false));
  });
  if (held.has(id)) return held.get(id);
  const asked = ask();
  held.set(id, asked);
  // the other tab may be closed meanwhile: the next one who asks asks again
  asked.then((has) => has || held.delete(id));
  return asked;
}

/** The visits in a transaction, the newest first. */
const all = async (transaction) =>
  (await result(transaction.objectStore("visits").getAll())).sort((a, b) => b.at - a.at);

/** Removes old visits, and the parts that no visit uses. */
async function tidy(transaction) {
  const visits = await all(transaction);
  for (const { id } of visits.splice(MOST_VISITS)) transaction.objectStore("visits").delete(id);
  const used = new Set(visits.flatMap(({ parts }) => parts.map(({ key }) => key)));
  for (const key of await result(transaction.objectStore("parts").getAllKeys())) {
    if (!used.has(key)) transaction.objectStore("parts").delete(key);
  }
  return visits;
}

/** The visits without their parts, for a list. */
const listed = (visits) => visits.map(({ id, title, at }) => ({ id, title, at }));

/**
 * Stores a visit `{ id, link, title, parts: [{ path, key }] }`. `contents` has the bytes of the parts that may not be
 * stored yet, by key. Resolves to the list of visits; rejects with "missing-part" if a part is neither here nor stored.
 */
async function keep(visit, contents) {
  const transaction = (await database()).transaction(["visits", "parts"], "readwrite");
  const done = new Promise((resolve, reject) => {
    transaction.oncomplete = resolve;
    transaction.onabort = () => reject(transaction.error ?? new Error("aborted"));
  });
  done.catch(() => {});
  const parts = transaction.objectStore("parts");
  try {
    for (const { key } of visit.parts) {
      if ((await result(parts.getKey(key))) !== undefined) continue;
      if (!contents.has(key)) throw new Error("missing-part");
      parts.put(contents.get(key), key);
    }
    transaction.objectStore("visits").put({ ...visit, at: Date.now() });
    const visits = await tidy(transaction);
    await done;
    return listed(visits);
  } catch (error) {
    try { transaction.abort(); } catch { /* it has ended already */ }
    throw transaction.error ?? error;
  }
}

/** The visit with its parts' bytes; parts that are not there are left out. */
async function complete(transaction, visit) {
  const parts = [];
  for (const { path, key } of visit.parts) {
    const bytes = await result(transaction.objectStore("parts").get(key));
    if (bytes) parts.push({ path, key, bytes });
  }
  return { id: visit.id, link: visit.link, parts };
}

/** A visit by its id, or null. */
async function load(id) {
  const transaction = (await database()).transaction(["visits", "parts"]);
  const visit = await result(transaction.objectStore("visits").get(id));
  return visit ? complete(transaction, visit) : null;
}

/**
 * The id under which this tab goes on with a visit: its own, or `fresh` with a copy of the record if another tab has it.
 * A duplicated tab has the entries of the other one's history, and would overwrite what that stores.
 */
async function own(id, fresh) {
  if (await hold(id)) return id;
  hold(fresh);
  const transaction = (await database()).transaction("visits", "readwrite");
  const visit = await result(transaction.objectStore("visits").get(id));
  if (visit) await result(transaction.objectStore("visits").put({ ...visit, id: fresh }));
  return fresh;
}

/**
 * What the app starts with: the visit of this entry of the browser's history, else the newest one of this link, else,
 * without a link, the newest; null if there is none. With the list of all visits.
 */
async function first(id, link) {
  const transaction = (await database()).transaction(["visits", "parts"]);
  const visits = await all(transaction);
  const own = visits.find((visit) => visit.id === id);
  const found = own ?? (link ? visits.find((visit) => visit.link === link) : visits[0]);
  return { visit: found ? await complete(transaction, found) : null, visits: listed(visits) };
}

export const store = { first, hold, keep, load, own };
