// The bar above every page: its name, three menus, the search.
import { pathToRoot } from "./layout.js";
import { NAVIGATION } from "./navigation.js";

const LOGO =
  '<svg viewBox="0 0 32 32" aria-hidden="true"><path d="M4 26C7 3 25 3 28 26"/><circle cx="16" cy="8.8" r="4"/></svg>';

/** @param {string} url of the page, from the first page */
export function siteBar(url) {
  const root = pathToRoot(url);
  const item = (/** @type {import("./navigation.js").Entry} */ { path, name, about }) =>
    `<li><a href="${root}${path}"${url === `/${path}` ? ' aria-current="page"' : ""}><b>${name}</b><span>${about}</span></a></li>`;
  const groups = NAVIGATION.map(
    ({ id, name, entries }) => `
        <div class="group${entries.some(({ path }) => url.startsWith(`/${path}`)) ? " current" : ""}">
          <button type="button" class="button plain" aria-expanded="false" aria-controls="nav-${id}">${name}</button>
          <ul id="nav-${id}" hidden>
            ${entries.map(item).join("\n            ")}
          </ul>
        </div>`,
  );
  return `<a class="skip" href="#main">Skip to the text</a>
    <header class="site-bar">
      <a class="brand" href="${root || "./"}">${LOGO}casteljau</a>
      <nav id="site-nav" aria-label="Site">${groups.join("")}
      </nav>
      <div class="tools">
        <button type="button" class="button plain search-button" data-search="${root}" disabled>Search <kbd>/</kbd></button>
        <button type="button" class="button plain menu-button" aria-expanded="false" aria-controls="site-nav">Menu</button>
      </div>
    </header>`;
}
