// The same picture as SVG: what is drawn is written down instead.
import { LIGHT } from "../../../applet/style.js";
import { drawFigure } from "./index.js";
import { LEVELS } from "./theme.js";

/** @typedef {import("./theme.js").Theme} Theme */
/** @typedef {import("../figure.js").Figure} Figure */
/** @typedef {import("../state.js").State} State */

/**
 * @typedef {object} SvgWishes
 * @property {Partial<Theme>} [theme] colours, by default those of a light page
 * @property {string} [label] what the picture is, for who cannot see it
 * @property {boolean} [opaque] whether the paper is painted too; false by default
 */

/**
 * The picture as a text of SVG that needs nothing else.
 *
 * @param {State} state
 * @param {Figure} figure
 * @param {SvgWishes} [wishes]
 * @returns {string}
 */
export function svgFigure(state, figure, { theme, label = "Bézier curve", opaque = false } = {}) {
  const colours = /** @type {Theme} */ ({ ...lightTheme(), ...theme });
  const recorder = new Recorder();
  drawFigure({ ctx: /** @type {any} */ (recorder), theme: colours, px: 1 }, state, figure);
  const { width, height } = state.box;
  const paper = opaque ? `<path fill="${escaped(colours.paper)}" d="M0 0H${width}V${height}H0Z"/>` : "";
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" role="img" fill="none" ` +
    `stroke-linejoin="round" stroke-linecap="round" font-family="system-ui, sans-serif" text-anchor="middle"><title>${escaped(label)}</title>${paper}${recorder.text}</svg>`
  );
}

/** The colours of a light page, as the style sheet states them. */
function lightTheme() {
  return Object.fromEntries(
    Array.from((LIGHT + LEVELS.light).matchAll(/--bz-(\w+): (#\w+)/g), ([, role, colour]) => [role, colour]),
  );
}

/** As much of a canvas's context as the layers use; each thing drawn is an element of SVG. */
export class Recorder {
  fillStyle = "";
  strokeStyle = "";
  lineWidth = 1;
  globalAlpha = 1;
  font = "";
  #path = "";
  #dash = "";
  /** @type {string[]} */
  #elements = [];
  /** What the last element shows: further paint of the same thing goes into it. */
  #last = "";

  get text() {
    return this.#elements.join("");
  }

  clearRect() {}

  beginPath() {
    this.#path = "";
  }

  /**
   * @param {number} x
   * @param {number} y
   */
  moveTo(x, y) {
    this.#path += `M${short(x)} ${short(y)}`;
  }

  /**
   * @param {number} x
   * @param {number} y
   */
  lineTo(x, y) {
    this.#path += `${this.#path ? "L" : "M"}${short(x)} ${short(y)}`;
  }

  /** @param {number[]} numbers */
  bezierCurveTo(...numbers) {
    this.#path += `C${numbers.map(short).join(" ")}`;
  }

  /** @param {number[]} numbers */
  quadraticCurveTo(...numbers) {
    this.#path += `Q${numbers.map(short).join(" ")}`;
  }

  closePath() {
    this.#path += "Z";
  }

  /**
   * Whole circles only.
   *
   * @param {number} x
   * @param {number} y
   * @param {number} r
   */
  arc(x, y, r) {
    const [left, radius] = [short(x - r), short(r)];
    this.#path += `M${left} ${short(y)}a${radius} ${radius} 0 1 0 ${short(2 * r)} 0a${radius} ${radius} 0 1 0 ${short(-2 * r)} 0Z`;
  }

  /**
   * @param {number} x
   * @param {number} y
   * @param {number} width
   * @param {number} height
   */
  rect(x, y, width, height) {
    this.#path += `M${short(x)} ${short(y)}h${short(width)}v${short(height)}h${short(-width)}Z`;
  }

  /** @param {number[]} lengths */
  setLineDash(lengths) {
    this.#dash = lengths.map(short).join(" ");
  }

  fill() {
    if (this.#path && this.globalAlpha > 0)
      this.#put(`<path d="${this.#path}"`, `fill="${escaped(this.fillStyle)}"${this.#opacity("fill-opacity")}`);
  }

  stroke() {
    if (this.#path) this.#put(`<path d="${this.#path}"`, this.#line());
  }

  /**
   * @param {string} words
   * @param {number} x
   * @param {number} y
   */
  strokeText(words, x, y) {
    this.#put(this.#words(words, x, y), `${this.#line()} paint-order="stroke"`);
  }

  /**
   * @param {string} words
   * @param {number} x
   * @param {number} y
   */
  fillText(words, x, y) {
    this.#put(this.#words(words, x, y), `fill="${escaped(this.fillStyle)}"`);
  }

  /**
   * @param {string} words
   * @param {number} x
   * @param {number} y
   */
  #words(words, x, y) {
    const [, weight, size] = /^(\d+) ([\d.]+)px/.exec(this.font) ?? [];
    return `<text x="${short(x)}" y="${short(y)}" dy="0.3em" font-weight="${weight}" font-size="${short(Number(size))}"\n${escaped(words)}`;
  }

  #line() {
    const dash = this.#dash && ` stroke-dasharray="${this.#dash}"`;
    return `stroke="${escaped(this.strokeStyle)}" stroke-width="${short(this.lineWidth)}"${dash}${this.#opacity("stroke-opacity")}`;
  }

  /** @param {string} name */
  #opacity(name) {
    return this.globalAlpha < 1 ? ` ${name}="${short(this.globalAlpha)}"` : "";
  }

  /**
   * @param {string} shape the element's start; words to be shown follow in a line of their own
   * @param {string} paint its further attributes
   */
  #put(shape, paint) {
    const [start, words] = shape.split("\n");
    const end = words === undefined ? "/>" : `>${words}</text>`;
    if (shape === this.#last) {
      const element = /** @type {string} */ (this.#elements.pop());
      this.#elements.push(`${element.slice(0, -end.length)} ${paint}${end}`);
      this.#last = "";
    } else {
      this.#elements.push(`${start} ${paint}${end}`);
      this.#last = shape;
    }
  }
}

/** @param {number} value */
function short(value) {
  return String(Math.round(100 * value) / 100);
}

const ENTITIES = /** @type {Record<string, string>} */ ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" });

/** @param {string} text */
function escaped(text) {
  return String(text).replace(/[&<>"]/g, (character) => ENTITIES[character]);
}
