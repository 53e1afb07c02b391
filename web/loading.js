// Shows how far the download is, and says so if it fails.
export default function loading() {
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
