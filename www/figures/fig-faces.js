// Three overlapping shapes and the faces into which their outlines divide the plane: the face under the pointer is highlighted, and
// faces can be selected.
import { html, svg } from "lit";
import { Figure } from "./lib/figure.js";
import { decimal } from "./lib/numbers.js";
import { drawn, handles, planeOf } from "./lib/plane.js";
import { Path } from "./modules/faces.js";

/** @typedef {import("./lib/plane.js").Point} Point */
/** @typedef {{ path: Path, inside: boolean[] }} Face */

const SIZE = { width: 120, height: 84 };
const NAMES = ["A", "B", "C"];
/** The outlines of the shapes. */
const COLOURS = ["var(--curve)", "var(--handle)", "var(--level1)"];
const RADIUS = 25;
const TOLERANCE = 0.01;
/** The centres of the shapes. @type {Point[]} */
const CENTERS = [
  [45, 32],
  [74, 32],
  [60, 57],
];

/** Around the origin: a disc, a rounded square, a drop. */
const SHAPES = [
  Path.circle([0, 0], RADIUS, { tolerance: TOLERANCE }),
  Path.rect([-21, -21], 42, 42, { radii: 8 }),
  Path.fromSVG("M0 -26C26 -8 32 24 0 24C-32 24 -26 -8 0 -26Z"),
];

const nameOf = (/** @type {number} */ i) => `Shape ${NAMES[i]}`;
/** @param {boolean[]} inside */
const keyOf = (inside) => inside.map(Number).join("");
/** @param {boolean[]} inside */
const wordsOf = (inside) => NAMES.filter((_, i) => inside[i]).join(" and ");

/** `<fig-faces>` */
export class FigFaces extends Figure {
  static properties = { centers: { state: true }, chosen: { state: true }, pointed: { state: true } };

  constructor() {
    super();
    this.centers = CENTERS;
    /** Selected faces: 1 and 0 for inside and outside of A, B and C. @type {ReadonlySet<string>} */
    this.chosen = new Set();
    /** @type {string | null} */
    this.pointed = null;
  }

  get shapes() {
    return SHAPES.map((shape, i) => shape.transform([1, 0, 0, 1, ...this.centers[i]]));
  }

  /** @returns {Face[]} faces with equal insides as one */
  get faces() {
    /** @type {Map<string, Face[]>} */
    const byKey = new Map();
    for (const face of Path.faces(this.shapes)) {
      const key = keyOf(face.inside);
      byKey.set(key, [...(byKey.get(key) ?? []), face]);
    }
    return [...byKey.values()].map((faces) => ({ path: joined(faces), inside: faces[0].inside }));
  }

  /** @param {string} key */
  toggle(key) {
    const chosen = new Set(this.chosen);
    if (!chosen.delete(key)) chosen.add(key);
    this.chosen = chosen;
    this.notifyChange();
  }

  /** @param {KeyboardEvent} event @param {string} key */
  onKey(event, key) {
    if (event.key !== " " && event.key !== "Enter") return;
    event.preventDefault();
    this.toggle(key);
  }

  /** @param {Face} face @param {import("./lib/plane.js").Plane} plane */
  face({ path, inside }, plane) {
    const key = keyOf(inside);
    const [isChosen, isPointed] = [this.chosen.has(key), this.pointed === key];
    return svg`<path class="node" tabindex="0" role="checkbox" aria-checked=${isChosen} aria-label="Face in ${wordsOf(inside)}" d=${drawn(plane, path)}
      fill=${isChosen ? "var(--curve)" : isPointed ? "var(--handle)" : "var(--panel)"} fill-opacity=${isChosen && isPointed ? 0.75 : isChosen ? 0.5 : isPointed ? 0.4 : 1}
      stroke=${isPointed ? "var(--ink)" : "none"} stroke-width="3"
      @pointerenter=${() => (this.pointed = key)} @pointerleave=${() => (this.pointed = null)} @focus=${() => (this.pointed = key)} @blur=${() => (this.pointed = null)}
      @click=${() => this.toggle(key)} @keydown=${(/** @type {KeyboardEvent} */ event) => this.onKey(event, key)} />`;
  }

  /** @param {Face[]} faces */
  words(faces) {
    const face = faces.find(({ inside }) => keyOf(inside) === this.pointed);
    if (!face) return "Point at a face, or select it with a click.";
    const outside = NAMES.filter((_, i) => !face.inside[i]).join(" and ");
    return `This face lies inside ${wordsOf(face.inside)}${outside && `, outside ${outside}`}. Area ${decimal(face.path.area({ fillRule: "evenodd" }), 0)}.`;
  }

  /** Selects the faces of an operation. @param {(inside: boolean[]) => boolean} isPart */
  select(isPart) {
    this.chosen = new Set(this.faces.filter(({ inside }) => isPart(inside)).map(({ inside }) => keyOf(inside)));
    this.notifyChange();
  }

  render() {
    const plane = planeOf(this.wide, SIZE);
    const { faces, shapes } = this;
    return html`
      <div class="frame">
        <div class="stage">
          <svg viewBox="0 0 ${plane.size.join(" ")}" role="group" aria-label="Three shapes and their faces">
            ${faces.map((face) => this.face(face, plane))}
            ${shapes.map((shape, i) => svg`<path d=${drawn(plane, shape)} fill="none" stroke=${COLOURS[i]} stroke-width="2.5" pointer-events="none" />`)}
            ${this.centers.map((center, i) => {
              const [x, y] = plane.place(center);
              const dy = i === 2 ? 14 : 0;
              return svg`<g pointer-events="none"><circle cx=${x} cy=${y} r="6" fill=${COLOURS[i]} stroke="var(--paper)" stroke-width="1.5" /><text class="strong haloed middle" x=${x + [-16, 16, 0][i]} y=${y + 5 + dy * 1.3}>${NAMES[i]}</text></g>`;
            })}
          </svg>
          ${handles(this, plane, this.centers, { name: nameOf, kind: () => "on", move: (centers) => (this.centers = centers) })}
        </div>
        <p class="facts" role="status">${this.words(faces)} <span class="line"><b>${this.chosen.size}</b> of ${faces.length} selected.</span></p>
        <div class="controls"><div class="row">
          <button @click=${() => this.select(([a, b]) => a || b)}>A ∪ B</button>
          <button @click=${() => this.select(([a, b]) => a && b)}>A ∩ B</button>
          <button @click=${() => this.select(([a, b]) => a && !b)}>A − B</button>
          <button @click=${() => this.select(([a, b]) => a !== b)}>A ⊕ B</button>
          <button @click=${() => this.select(() => false)}>Clear</button>
        </div></div>
      </div>
    `;
  }
}

/** @param {Face[]} faces */
const joined = (faces) => (faces.length === 1 ? faces[0].path : Path.from(faces.map(({ path }) => path)));

customElements.define("fig-faces", FigFaces);
