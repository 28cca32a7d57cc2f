// A ring and a leaf: their union, difference or intersection follows the leaf.
import { append, find, makeDraggable, setAttributes, whenWanted } from "../picture.js";
import { LEAF, LEAF_AT, ringOf } from "./ring.js";

/** @typedef {"union" | "subtract" | "intersect"} Operation */

const [MIN_X, MAX_X, MIN_Y, MAX_Y] = [10, 310, 10, 190];

const box = find('[data-thing="shapes"]');
/** @type {SVGSVGElement} */
const svg = find("svg", box);
const result = find(".letter", svg);
const leaf = find(".grip", svg);
const crossings = find(".crossings", svg);
/** @type {HTMLButtonElement[]} */
const buttons = [...box.querySelectorAll("button")];
const at = [...LEAF_AT];
/** @type {Operation} */
let operation = "union";

const load = async () => {
  const { Path } = await import("casteljau");
  return { ring: ringOf(Path), leaf: Path.fromSVG(LEAF) };
};
/** @type {ReturnType<typeof load> | undefined} */
let loading;

async function draw() {
  loading ??= load();
  const shapes = await loading;
  const moved = shapes.leaf.transform([1, 0, 0, 1, at[0], at[1]]);
  result.setAttribute("d", shapes.ring[operation](moved).toSVG({ precision: 1 }));
  crossings.replaceChildren();
  for (const { point } of shapes.ring.intersections(moved))
    append(crossings, "circle", { cx: point.x.toFixed(1), cy: point.y.toFixed(1), r: 4 });
}

for (const button of buttons) {
  button.disabled = false;
  button.addEventListener("click", () => {
    operation = /** @type {Operation} */ (button.dataset.operation);
    for (const each of buttons) each.setAttribute("aria-pressed", String(each === button));
    void draw();
  });
}
makeDraggable(svg, leaf, {
  label: "Leaf, the second shape",
  position: () => at,
  move(x, y) {
    at[0] = Math.min(MAX_X, Math.max(MIN_X, x));
    at[1] = Math.min(MAX_Y, Math.max(MIN_Y, y));
    setAttributes(leaf, { transform: `translate(${at.map((value) => value.toFixed(1)).join(" ")})` });
    void draw();
  },
});
whenWanted(svg, draw);
