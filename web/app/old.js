// Says in words that the app could not begin: in browsers that cannot even read its scripts, and where one of them is
// missing. It runs in every browser, and so is written in the JavaScript of 2009, in both languages.
(function () {
  "use strict";
  var ENGLISH = "riemap could not begin. Reload the page; if that does not help, bring the browser up to date: " +
    "Firefox 114, Chrome or Edge 91, Safari 16.4 or later.";
  var GERMAN = "riemap konnte nicht beginnen. Seite neu laden; hilft das nicht, den Browser aktualisieren: " +
    "Firefox 114, Chrome oder Edge 91, Safari 16.4 oder neuer.";
  var language = String(navigator.language || "").slice(0, 2).toLowerCase();

  window.addEventListener("load", function () {
    var text = document.getElementById("loading-text");
    // modules run before the page has loaded; `start.js` says that it has
    if (text && !window.riemapBegins) text.textContent = language === "de" ? GERMAN : ENGLISH;
  });
})();
