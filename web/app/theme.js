// The theme of the page before the app has started: that of `?theme=…`, else the one chosen in the app, else the
// system's. Runs before the page is drawn for the first time, so that nothing flashes.
{
  const THEMES = ["light", "dark"];
  const chosen = () => {
    try {
      return JSON.parse(localStorage.getItem("riemap preferences"))?.appearance;
    } catch {
      return null; // no storage, or nothing readable in it: as if nothing were chosen
    }
  };
  const wanted = [new URLSearchParams(location.search).get("theme"), chosen()].find((theme) => THEMES.includes(theme));
  const system = matchMedia("(prefers-color-scheme: light)");
  const show = () => {
    document.documentElement.dataset.theme = wanted ?? (system.matches ? "light" : "dark");
  };
  system.addEventListener("change", show);
  show();
}
