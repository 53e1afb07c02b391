// The page in plain words, where the app cannot run: what is missing, and what to do.
import { words } from "./words.js";

/** Shows it in place of everything else; `lack` is what is missing, a key of the words. */
export function plainWords(lack) {
  const { title, missing, remedies } = words[lack];
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
  for (const remedy of remedies) add(list, "li", remedy);
  const reload = add(page, "button", words.reload);
  reload.addEventListener("click", () => location.reload());
  document.body.replaceChildren(page);
}
