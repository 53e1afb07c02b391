// The page shown where the app cannot run: it says what is missing and what to do.
import { words } from "./words.js";

/** Replaces the page's contents by this explanation; `lack`, a key of `words`, names what is missing. */
export function plainWords(lack) {
  const { title, missing, suggestions } = words[lack];
  const page = document.createElement("main");
  page.className = "plain";
  page.id = "plain-words";
  const add = (parent, tag, text) => {
    const child = parent.appendChild(document.createElement(tag));
    if (text) child.textContent = text;
    return child;
  };
  add(page, "h1", title);
  add(page, "p", missing);
  const list = add(page, "ul");
  for (const suggestion of suggestions) add(list, "li", suggestion);
  const reload = add(page, "button", words.reload);
  reload.addEventListener("click", () => location.reload());
  document.body.replaceChildren(page);
}
