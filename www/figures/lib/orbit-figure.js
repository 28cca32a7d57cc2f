// The base of figures in space that the reader turns: by dragging, with arrow keys, and with two sliders.
import { arrowDirection } from "#js/ui/keys.js";
import { capture } from "#js/ui/capture.js";
import { html } from "lit";
import { Figure, numeric } from "./figure.js";
import { decimal } from "./numbers.js";
import { slider } from "./parts.js";

const DEGREES_PER_PIXEL = 0.5;
const DEGREES_PER_KEY = 5;
export const RADIANS = Math.PI / 180;

/**
 * Seen from far away: turned about the z axis, tilted against the horizon.
 *
 * @param {number} turn degrees
 * @param {number} tilt degrees
 * @returns {(point: ArrayLike<number>) => [number, number]} right and down
 */
export function seen(turn, tilt) {
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

  /** The sliders of both angles. */
  angles() {
    return html`
      ${slider({ name: "Rotation", value: this.turn, min: -180, max: 180, step: 1, text: `${decimal(this.turn, 0)}°`, change: (turn) => this.orbit(turn, this.tilt) })}
      ${slider({ name: "Tilt", value: this.tilt, min: -90, max: 90, step: 1, text: `${decimal(this.tilt, 0)}°`, change: (tilt) => this.orbit(this.turn, tilt) })}
    `;
  }
}
