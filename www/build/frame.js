// What all pages have alike: what a browser must know, the way to the text, the names of the pages above it and the line below.
// Written in while the site is built, where a page says `<!-- head -->`, `<!-- header -->` and `<!-- footer -->`.

/** The pages that every page names, by their folders. */
const PAGES = {
  curves: "Curves",
  surfaces: "Surfaces",
  easing: "Easing",
  camera: "Camera",
  glyph: "Glyphs",
  elements: "Elements",
  texts: "Texts",
  errata: "Errata",
};

/** @param {string} up the way from the page to the first one: "" or "../" */
const head = (up) => `<meta charset="utf-8">
    <meta name="viewport" content="width=device-width">
    <meta name="color-scheme" content="light dark">
    <link rel="icon" href="data:,">
    <link rel="stylesheet" href="${up}site.css">`;

/**
 * @param {string} up
 * @param {string} here the page's folder
 */
function header(up, here) {
  const current = (/** @type {string} */ folder) => (folder === here ? ' aria-current="page"' : "");
  const items = Object.entries(PAGES).map(
    ([folder, name]) => `          <li><a href="${up}${folder}/"${current(folder)}>${name}</a></li>`,
  );
  return `<a class="skip" href="#main">Skip to the text</a>
    <header class="site">
      <a class="brand" href="${up || "./"}">casteljau</a>
      <nav aria-label="Site">
        <ul>
${items.join("\n")}
        </ul>
      </nav>
    </header>`;
}

const FOOTER = `<footer class="site-end">
      <p>casteljau: one core in Rust, for Rust and the web. MIT or Apache-2.0. What runs on these pages is the package itself.</p>
    </footer>`;

/** Vite's plugin. */
export const siteFrame = {
  name: "site-frame",
  transformIndexHtml: {
    order: /** @type {const} */ ("pre"),
    handler: (/** @type {string} */ html, /** @type {{ path: string }} */ { path }) => {
      const folders = path.split("/").slice(1, -1);
      const up = "../".repeat(folders.length);
      return html
        .replace("<!-- head -->", head(up))
        .replace("<!-- header -->", header(up, folders[0]))
        .replace("<!-- footer -->", FOOTER);
    },
  },
};
