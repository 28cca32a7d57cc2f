// What the tests of /recipes/ share.
import { openStrict } from "./site-pages.js";

/** Opens the page, once for the tests of a file, and brings a recipe into view; waits until its script has drawn. @param {string} name */
export async function openRecipe(t, name) {
  const page = await openStrict(t, "/recipes/", {
    viewport: { width: 1200, height: 900 },
    reducedMotion: "reduce",
    keep: true,
  });
  const figure = page.locator(`figure[data-recipe="${name}"]`);
  await figure.scrollIntoViewIfNeeded();
  const drawn = name === "text-along-path" ? figure.locator("g text") : figure.locator("output:not(:empty)");
  await drawn.first().waitFor({ state: "attached" });
  return { page, figure, output: figure.locator("output") };
}

/** What the picture shows: the SVG's text, or a canvas as a data URL. */
export const pictureOf = (figure) =>
  figure.evaluate((figure) => {
    const canvas = figure.querySelector("canvas");
    return canvas ? canvas.toDataURL() : figure.querySelector("svg").outerHTML;
  });

/** Draws again and counts the pixels that are drawn on: WebGL keeps its picture only until the frame is shown. @param {HTMLCanvasElement} canvas */
export function inkedAfterInput(canvas) {
  canvas.parentElement?.querySelector("form")?.dispatchEvent(new Event("input"));
  const copy = Object.assign(document.createElement("canvas"), { width: canvas.width, height: canvas.height });
  const context = /** @type {CanvasRenderingContext2D} */ (copy.getContext("2d", { willReadFrequently: true }));
  context.drawImage(canvas, 0, 0);
  const { data } = context.getImageData(0, 0, copy.width, copy.height);
  return data.filter((value, i) => i % 4 === 3 && value > 100).length;
}

/** The numbers of a text, without separators of thousands. */
export const numbersIn = (text) => (text.replaceAll(",", "").match(/\d+(\.\d+)?/g) ?? []).map(Number);
