// Makes the app available offline, with the service worker, and offers a new version when one is ready.
import { words } from "./words.js";

/** Registers the service worker that `cargo xtask dist` has written for this build.
 *
 * `cargo xtask serve` writes none, and its folder has no version in its name, so that a developer
 * always sees the newest build. */
export async function installed() {
  const isVersioned = /\/app-[0-9a-f]+\/[^/]*$/.test(new URL(import.meta.url).pathname);
  const container = navigator.serviceWorker;
  if (!isVersioned || !container) return;
  const before = await container.getRegistration("./").catch(() => undefined);
  // a page reloaded without the worker has no controller, but a worker of an older version may exist
  let controlled = Boolean(container.controller ?? before?.active);
  container.addEventListener("controllerchange", () => {
    if (controlled) location.reload();
    controlled = true;
  });
  try {
    // relative to the page: the worker's scope is this folder, under any path of a host
    const registration = await container.register("./service-worker.js", { updateViaCache: "none" });
    offer(registration.waiting);
    registration.addEventListener("updatefound", () => {
      const worker = registration.installing;
      worker?.addEventListener("statechange", () => worker.state === "installed" && offer(registration.waiting));
    });
  } catch (error) {
    // storage may be forbidden here, as in private windows and frames: the app works, but not offline
    console.info(`riemap is not kept for offline use: ${error}`);
  }
}

/** Offers the version of a waiting worker, if an older worker controls this page. */
function offer(waiting) {
  const notice = document.getElementById("update");
  if (!waiting || !navigator.serviceWorker.controller || !notice || window.parent !== window) return;
  document.getElementById("update-text").textContent = words.update;
  document.getElementById("update-reload").onclick = () => waiting.postMessage("take over");
  notice.hidden = false;
}
