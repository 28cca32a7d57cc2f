// The base of the figures: knows how wide it is, so that letters keep their size on every screen.
import { LitElement } from "lit";
import { style } from "./style.js";

/** What a figure is drawn for until it has been measured, in CSS pixels. */
const FIRST_WIDTH = 640;
/** Narrower than this a figure shrinks as a whole. */
const MIN_WIDTH = 280;

/**
 * A figure of the chapters. Subclasses draw in units of CSS pixels, `this.wide` of them from side to side.
 */
export class Figure extends LitElement {
  /** @type {import("lit").PropertyDeclarations} */
  static properties = { wide: { state: true } };
  /** @type {import("lit").CSSResultGroup} */
  static styles = style;

  /** @type {ResizeObserver | null} */
  #observer = null;

  constructor() {
    super();
    /** The inner width in CSS pixels. */
    this.wide = FIRST_WIDTH;
  }

  connectedCallback() {
    super.connectedCallback();
    this.#observer = new ResizeObserver(([{ contentRect }]) => {
      if (contentRect.width > 0) this.wide = Math.max(MIN_WIDTH, Math.round(contentRect.width) - 2); // the frame's rim
    });
    this.#observer.observe(this);
  }

  createRenderRoot() {
    const root = super.createRenderRoot();
    root.addEventListener("change", () => this.notifyChange()); // the event of a control does not leave the shadow root
    return root;
  }

  disconnectedCallback() {
    super.disconnectedCallback();
    this.#observer?.disconnect();
    this.#observer = null;
  }

  /** Tells the page that the user is moving something. */
  notifyInput() {
    this.dispatchEvent(new Event("input", { bubbles: true, composed: true }));
  }

  /** Tells the page that the user has changed something. */
  notifyChange() {
    this.dispatchEvent(new Event("change", { bubbles: true, composed: true }));
  }
}

/**
 * Attributes hold any text: what is no number in the range counts as the default.
 *
 * @param {{ least?: number, most?: number, whole?: boolean, otherwise: number }} options
 * @returns {(text: string | null) => number}
 */
export const numberFrom =
  ({ least = -Infinity, most = Infinity, whole = false, otherwise }) =>
  (text) => {
    const number = text === null || text.trim() === "" ? NaN : Number(text);
    const usable = number >= least && number <= most && Number.isFinite(number) && (!whole || Number.isInteger(number));
    return usable ? number : otherwise;
  };

/**
 * A property that is an attribute with a number.
 *
 * @param {Parameters<typeof numberFrom>[0]} options
 */
export const numeric = (options) => ({ converter: { fromAttribute: numberFrom(options) } });

/**
 * One of several words; anything else is the first.
 *
 * @param {readonly string[]} words
 */
export const oneOf = (words) => ({
  converter: {
    fromAttribute: (/** @type {string | null} */ text) => (text !== null && words.includes(text) ? text : words[0]),
  },
});
