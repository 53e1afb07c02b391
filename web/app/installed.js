// Keeps the app for use without a network, by the service worker, and offers a new version when one is ready.
import { words } from "./words.js";

/** Registers the service worker that `cargo xtask dist` has written for this build.
 *
 * `cargo xtask serve` writes none, and its folder has no version in its name: there the newest
 * build is what one wants to see. */
export async function installed() {
  const isVersioned = /\/app-[0-9a-f]+\/[^/]*$/.test(new URL(import.meta.url).pathname);
  const container = navigator.serviceWorker;
  if (!isVersioned || !container) return;
  const before = await container.getRegistration("./").catch(() => undefined);
  // a page that was loaded past the worker has no controller, and is an older version's all the same
  let controlled = Boolean(container.controller ?? before?.active);
  container.addEventListener("controllerchange", () => {
    if (controlled) location.reload();
    controlled = true;
  });
  try {
    // where the page is: the worker's scope is this folder, under whatever path it is hosted
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

/** A worker that waits while this page is under an older one has a newer version. */
function offer(waiting) {
  const notice = document.getElementById("update");
  if (!waiting || !navigator.serviceWorker.controller || !notice || window.parent !== window) return;
  document.getElementById("update-text").textContent = words.update;
  document.getElementById("update-reload").onclick = () => waiting.postMessage("take over");
  notice.hidden = false;
}
