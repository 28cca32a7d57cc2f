// What `console.log` shows of a path in Node. A class with a method whose name is computed is kept by bundlers even if it
// is unused; the unused result of a call that is marked as pure is not.

/** Longer path data is cut off, as Node does with long arrays. */
const MAX_LENGTH = 1000;

/**
 * A class whose instances Node shows as SVG path data: `Path M0,0 L4,0`.
 *
 * @internal
 * @returns {new () => object}
 */
export function inspectedAsSVG() {
  return class {
    /** @returns {string} */
    [Symbol.for("nodejs.util.inspect.custom")]() {
      const text = /** @type {any} */ (this).toSVG();
      return `Path ${text.length > MAX_LENGTH ? `${text.slice(0, MAX_LENGTH)}…` : text || "(empty)"}`;
    }
  };
}
