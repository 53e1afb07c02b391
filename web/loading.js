// Shows how far the download is, and says so if it fails.
export default function loading() {
  distrustEmulatedPixels();
  const bar = document.getElementById("loading-bar");
  const text = document.getElementById("loading-text");
  const megabytes = (bytes) => (bytes / 1e6).toFixed(1);
  return {
    onStart() {},
    onProgress({ current, total }) {
      if (!bar || !text) return;
      // A compressed response is counted unpacked; its announced length is not.
      if (total && current <= total) bar.value = current / total;
      else bar.removeAttribute("value");
      text.textContent = `Loading… ${megabytes(current)} MB`;
    },
    onComplete() {},
    onSuccess() {
      if (text) text.textContent = "Starting the graphics…";
    },
    onFailure(error) {
      document.getElementById("loading")?.remove();
      const failure = document.getElementById("failure");
      if (!failure) return;
      failure.textContent = `riemap could not be loaded: ${error}. Reload the page to try again.`;
      failure.hidden = false;
    },
  };
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
