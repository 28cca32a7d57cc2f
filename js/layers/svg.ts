// The same picture as SVG: what is drawn is written down instead.
import { FONT_FAMILY, LIGHT } from "../ui/tokens.js";
import { drawFigure } from "./draw-figure.js";
import { ALL_LAYERS } from "./index.js";
import type { Layer } from "./draw-figure.js";
import { LEVELS } from "./theme.js";
import type { Theme } from "./theme.js";
import type { Figure } from "../editor/figure.js";
import type { DrawnState } from "../editor/state.js";

export interface SvgOptions {
  /** Colours, by default those of a light page */
  theme?: Partial<Theme>;
  /** What the picture is, for who cannot see it */
  label?: string;
  /** Whether the paper is painted too; false by default */
  opaque?: boolean;
  /** From the back to the front; by default those of curves without weights */
  layers?: readonly Layer[];
}

/** The picture as a text of SVG that needs nothing else. */
export function svgFigure(
  state: DrawnState,
  figure: Figure,
  { theme, label = "Bézier curve", opaque = false, layers = ALL_LAYERS }: SvgOptions = {},
): string {
  const colours = { ...lightTheme(), ...theme } as Theme;
  const recorder = new Recorder();
  drawFigure({ ctx: recorder as any, theme: colours, px: 1 }, state, figure, layers);
  const { width, height } = state.box;
  const paper = opaque ? `<path fill="${escaped(colours.paper)}" d="M0 0H${width}V${height}H0Z"/>` : "";
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" role="img" fill="none" ` +
    `stroke-linejoin="round" stroke-linecap="round" font-family="${escaped(FONT_FAMILY)}" text-anchor="middle"><title>${escaped(label)}</title>${paper}${recorder.text}</svg>`
  );
}

/** The colours of a light page, but on white paper, as documents have it. */
function lightTheme() {
  const colours = Array.from((LIGHT + LEVELS.light).matchAll(/--bz-(\w+): (#\w+)/g), ([, role, colour]) => [
    role,
    colour,
  ]);
  return { ...Object.fromEntries(colours), paper: "#ffffff" };
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
  #elements: string[] = [];
  /** What the last element shows, if its other paint can be added to it. */
  #last = "";

  get text() {
    return this.#elements.join("");
  }

  clearRect() {}

  beginPath() {
    this.#path = "";
  }

  moveTo(x: number, y: number) {
    this.#path += `M${short(x)} ${short(y)}`;
  }

  lineTo(x: number, y: number) {
    this.#path += `${this.#path ? "L" : "M"}${short(x)} ${short(y)}`;
  }

  bezierCurveTo(...numbers: number[]) {
    this.#path += `C${numbers.map(short).join(" ")}`;
  }

  quadraticCurveTo(...numbers: number[]) {
    this.#path += `Q${numbers.map(short).join(" ")}`;
  }

  closePath() {
    this.#path += "Z";
  }

  /** Whole circles only. */
  arc(x: number, y: number, r: number) {
    const [left, radius] = [short(x - r), short(r)];
    this.#path += `M${left} ${short(y)}a${radius} ${radius} 0 1 0 ${short(2 * r)} 0a${radius} ${radius} 0 1 0 ${short(-2 * r)} 0Z`;
  }

  rect(x: number, y: number, width: number, height: number) {
    this.#path += `M${short(x)} ${short(y)}h${short(width)}v${short(height)}h${short(-width)}Z`;
  }

  setLineDash(lengths: number[]) {
    this.#dash = lengths.map(short).join(" ");
  }

  fill() {
    if (this.#path && this.globalAlpha > 0)
      this.#put(`<path d="${this.#path}"`, `fill="${escaped(this.fillStyle)}"${this.#opacity("fill-opacity")}`);
  }

  stroke() {
    if (this.#path) this.#put(`<path d="${this.#path}"`, this.#line(), true);
  }

  strokeText(words: string, x: number, y: number) {
    this.#put(this.#words(words, x, y), `${this.#line()} paint-order="stroke"`);
  }

  fillText(words: string, x: number, y: number) {
    this.#put(this.#words(words, x, y), `fill="${escaped(this.fillStyle)}"`, true);
  }

  #words(words: string, x: number, y: number) {
    const [, weight, size] = /^(\d+) ([\d.]+)px/.exec(this.font) ?? [];
    return `<text x="${short(x)}" y="${short(y)}" dy="0.3em" font-weight="${weight}" font-size="${short(Number(size))}"\n${escaped(words)}`;
  }

  #line() {
    const dash = this.#dash && ` stroke-dasharray="${this.#dash}"`;
    return `stroke="${escaped(this.strokeStyle)}" stroke-width="${short(this.lineWidth)}"${dash}${this.#opacity("stroke-opacity")}`;
  }

  #opacity(name: string) {
    return this.globalAlpha < 1 ? ` ${name}="${short(this.globalAlpha)}"` : "";
  }

  /**
   * @param shape the element's start; words to be shown follow in a line of their own
   * @param paint its further attributes
   * @param above whether SVG paints it above the other paint of the same element: strokes of paths above fills, fills of words
   *   above strokes
   */
  #put(shape: string, paint: string, above = false) {
    const [start, words] = shape.split("\n");
    const end = words === undefined ? "/>" : `>${words}</text>`;
    if (above && shape === this.#last) {
      const element = this.#elements.pop() as string;
      this.#elements.push(`${element.slice(0, -end.length)} ${paint}${end}`);
      this.#last = "";
    } else {
      this.#elements.push(`${start} ${paint}${end}`);
      this.#last = above ? "" : shape;
    }
  }
}

function short(value: number) {
  return String(Math.round(100 * value) / 100);
}

const ENTITIES = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" } as Record<string, string>;

function escaped(text: string) {
  return String(text).replace(/[&<>"]/g, (character) => ENTITIES[character]);
}
