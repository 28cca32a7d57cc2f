// The base of figures in space that the reader turns: by dragging, with arrow keys, and with two sliders.
import { arrowDirection } from "#js/ui/keys.js";
import { capture } from "#js/ui/capture.js";
import { html } from "lit";
import { Figure, numeric } from "./figure.js";
import { decimal } from "./numbers.js";
import { slider } from "./parts.js";

const DEGREES_PER_PIXEL = 0.5;
const DEGREES_PER_KEY = 5;
/** Wider pictures are no taller than this one, in CSS pixels. */
const MAX_WIDTH = 690;
const MIN_HEIGHT = 300;
export const RADIANS = Math.PI / 180;

/**
 * Seen from far away: turned about the z axis, tilted against the horizon.
 *
 * @param {number} turn degrees
 * @param {number} tilt degrees
 * @returns {(point: ArrayLike<number>) => [number, number]} right and down
 */
function seen(turn, tilt) {
  const [c, s] = [Math.cos(turn * RADIANS), Math.sin(turn * RADIANS)];
  const [ct, st] = [Math.cos(tilt * RADIANS), Math.sin(tilt * RADIANS)];
  return ({ 0: x, 1: y, 2: z }) => [c * y - s * x, st * (c * x + s * y) - ct * z];
}

/** Attributes `turn` and `tilt`, in degrees. */
export class OrbitFigure extends Figure {
  /** @type {import("lit").PropertyDeclarations} */
  static properties = {
    turn: numeric({ least: -180, most: 180, otherwise: -42 }),
    tilt: numeric({ least: -90, most: 90, otherwise: 22 }),
  };

  constructor() {
    super();
    this.turn = -42;
    this.tilt = 22;
  }

  /** @param {number} turn @param {number} tilt */
  orbit(turn, tilt) {
    this.turn = ((((turn + 180) % 360) + 360) % 360) - 180;
    this.tilt = Math.min(Math.max(tilt, -90), 90);
  }

  /** @param {PointerEvent} start */
  drag(start) {
    if (start.button !== 0) return;
    const [turn, tilt] = [this.turn, this.tilt];
    capture(start, {
      move: (event) =>
        this.orbit(
          turn - (event.clientX - start.clientX) * DEGREES_PER_PIXEL,
          tilt + (event.clientY - start.clientY) * DEGREES_PER_PIXEL,
        ),
    });
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const arrow = arrowDirection(event);
    if (!arrow || event.altKey) return;
    event.preventDefault();
    this.orbit(this.turn - arrow[0] * DEGREES_PER_KEY, this.tilt + arrow[1] * DEGREES_PER_KEY);
  }

  /**
   * The height of the picture, and the map from space onto it, which always holds a ball.
   *
   * @param {ArrayLike<number>} center
   * @param {number} radius
   * @param {number} ratio of the height to the width
   */
  view(center, radius, ratio) {
    const height = Math.round(Math.max(MIN_HEIGHT, ratio * Math.min(this.wide, MAX_WIDTH)));
    const look = seen(this.turn, this.tilt);
    const scale = Math.min(this.wide, height) / (2 * radius);
    const [cx, cy] = look(center);
    const place = (/** @type {ArrayLike<number>} */ point) => {
      const [x, y] = look(point);
      return /** @type {[number, number]} */ ([this.wide / 2 + (x - cx) * scale, height / 2 + (y - cy) * scale]);
    };
    return { height, place };
  }

  /** The picture that is turned. @param {number} height @param {string} what in words @param {string} state @param {unknown} content */
  turned(height, what, state, content) {
    const words = `${what}, seen from ${Math.round(this.turn)} degrees around and ${Math.round(this.tilt)} above; arrow keys turn it. ${state}`;
    return html`<svg class="orbit" viewBox="0 0 ${this.wide} ${height}" role="img" tabindex="0" aria-label=${words} @pointerdown=${this.drag} @keydown=${this.key}>${content}</svg>`;
  }

  /** @param {number} t @param {(t: number) => void} set */
  sliderOfT(t, set) {
    const change = (/** @type {number} */ to) => {
      set(to);
      this.notifyChange();
    };
    return slider({ name: html`<i>t</i>`, value: t, min: 0, max: 1, text: decimal(t), change });
  }

  /** The sliders of both angles. */
  angles() {
    return html`
      ${slider({ name: "Rotation", value: this.turn, min: -180, max: 180, step: 1, text: `${decimal(this.turn, 0)}°`, change: (turn) => this.orbit(turn, this.tilt) })}
      ${slider({ name: "Tilt", value: this.tilt, min: -90, max: 90, step: 1, text: `${decimal(this.tilt, 0)}°`, change: (tilt) => this.orbit(this.turn, tilt) })}
    `;
  }
}
