// The texts of the page before the app has started, in English and German.
// The language is that of `?lang=…`, else the one chosen in the app, else the browser's.

const WORDS = {
  en: {
    language: "en",
    title: "riemap: real-time conformal maps",
    loading: "Loading…",
    starting: "Starting the graphics…",
    reload: "Reload",
    notLoaded: "riemap could not be loaded. Reload the page to try again.",
    update: "A new version is ready.",
    open: "open in riemap",
    graphics: {
      title: "riemap cannot draw here",
      missing: "riemap draws with WebGPU or WebGL 2, and this browser offers neither of them here.",
      suggestions: [
        "Open this page in a current Firefox, Chrome, Edge or Safari.",
        "Turn on hardware acceleration (or “graphics acceleration”) in the browser's settings, and start the browser again.",
        "In a virtual machine or on a remote desktop, open the page on the computer itself.",
      ],
    },
    program: {
      title: "riemap cannot run here",
      missing: "riemap computes in the browser, with WebAssembly and its vector instructions, in workers that are modules, and this browser does not have all of them.",
      suggestions: [
        "Bring the browser up to date: Firefox from 114, Chrome and Edge from 91, Safari from 16.4 on will do.",
        "If WebAssembly was turned off (as in Safari's lockdown mode), allow it for this page.",
      ],
    },
  },
  de: {
    language: "de",
    title: "riemap: konforme Abbildungen in Echtzeit",
    loading: "Wird geladen …",
    starting: "Grafik wird gestartet …",
    reload: "Neu laden",
    notLoaded: "riemap konnte nicht geladen werden. Seite neu laden, um es noch einmal zu versuchen.",
    update: "Eine neue Version liegt bereit.",
    open: "in riemap öffnen",
    graphics: {
      title: "riemap kann hier nicht zeichnen",
      missing: "riemap zeichnet mit WebGPU oder WebGL 2, und dieser Browser bietet hier keines von beiden.",
      suggestions: [
        "Diese Seite in einem aktuellen Firefox, Chrome, Edge oder Safari öffnen.",
        "In den Einstellungen des Browsers die Hardwarebeschleunigung („Grafikbeschleunigung“) einschalten und den Browser neu starten.",
        "In einer virtuellen Maschine oder über eine Fernverbindung: die Seite auf dem Rechner selbst öffnen.",
      ],
    },
    program: {
      title: "riemap kann hier nicht laufen",
      missing: "riemap rechnet im Browser, mit WebAssembly und dessen Vektorbefehlen, in Workern, die Module sind; dieser Browser kennt nicht alle davon.",
      suggestions: [
        "Den Browser aktualisieren: Firefox ab 114, Chrome und Edge ab 91, Safari ab 16.4 genügen.",
        "Wurde WebAssembly abgeschaltet (wie im Blockierungsmodus von Safari), es für diese Seite erlauben.",
      ],
    },
  },
};

/** The language chosen in the app, if any, from the app's preferences (src/platform/web/address.rs). */
function chosen() {
  try {
    return JSON.parse(localStorage.getItem("riemap preferences"))?.language;
  } catch {
    return null; // storage may be forbidden here, as in frames
  }
}

const languages = navigator.languages ?? [navigator.language];
const wanted = [new URLSearchParams(location.search).get("lang"), chosen(), ...languages];
const known = wanted.filter(Boolean).map((language) => language.slice(0, 2).toLowerCase());

/** The texts in the language of this page. */
export const words = WORDS[known.find((language) => language in WORDS) ?? "en"];
