// The grid of pictures at the beginning of /recipes/ and /figures/: a picture for each section, drawn while the site is built.
import { figurePicture } from "./figure-pictures.js";
import { recipePicture } from "./recipe-pictures.js";

/** Where a page has `<nav data-gallery></nav>`. */
const PLACE = /(<nav [^>]*\bdata-gallery\b[^>]*>)\s*(<\/nav>)/;
/** A section with a recipe or a figure: its id, its title, and what follows. */
const SECTION =
  /<section id="([^"]+)"[^>]*>\s*<h2[^>]*>(.*?) <a class="permalink".*?<\/h2>(.*?)(?=<section |<\/main>)/gs;

/** The picture of what a section has. @param {string} html */
async function pictureIn(html) {
  const recipe = /data-recipe="([^"]+)"/.exec(html)?.[1];
  if (recipe) return recipePicture(recipe);
  const figure = /<(fig-[\w-]+)>/.exec(html)?.[1];
  return figure && figurePicture(figure);
}

/** Writes the grid into a page that has a place for it. @param {string} html */
export async function addGallery(html) {
  if (!PLACE.test(html)) return html;
  const cards = await Promise.all(
    Array.from(html.matchAll(SECTION), async ([, id, title, content]) => {
      const picture = await pictureIn(content);
      return picture ? `<li><a href="#${id}">${picture}<span>${title}</span></a></li>` : "";
    }),
  );
  return html.replace(
    PLACE,
    (_, open, close) => `${open}<ul class="gallery">\n${cards.filter(Boolean).join("\n")}\n</ul>${close}`,
  );
}
