// Runs a recipe when its picture comes near the window: the same script as the page shows.
import "../parts/contents.js";
import { whenNear } from "../parts/when-near.js";

const recipes = /** @type {Record<string, () => Promise<unknown>>} */ (
  import.meta.glob(["./code/*.js", "!./code/draggable.js"])
);

for (const figure of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("[data-recipe]"))) {
  whenNear(figure, () => run(figure));
}

/** @param {HTMLElement} figure */
async function run(figure) {
  try {
    await recipes[`./code/${figure.dataset.recipe}.js`]();
  } catch (error) {
    const message = Object.assign(document.createElement("p"), { className: "state-message" });
    message.textContent = `This picture could not be drawn: ${error instanceof Error ? error.message : error}`;
    message.setAttribute("role", "status");
    figure.append(message);
  }
}
