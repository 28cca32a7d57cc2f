// What `console.log` shows of a value in Node. The classes call this when they make their first instance: a method with a
// computed name, or a call beside the class, would make bundlers keep an unused class.

/**
 * Defines what Node shows of the instances of a class: the name and the contents, as
 * `Curve { points: [ [ 0, 0 ], [ 1, 2 ] ] }`.
 *
 * @internal
 * @template T
 * @param {T} prototype
 * @param {string} name a text of its own, because minifiers change the names of classes
 * @param {(value: T) => unknown} contents a text is shown without quotes
 * @returns {true}
 */
export function showInNode(prototype, name, contents) {
  /**
   * @this {T}
   * @param {number} depth how many levels of objects may be shown
   * @param {object} options
   * @param {(value: unknown, options: object) => string} inspect
   */
  function value(depth, options, inspect) {
    if (depth < 0) return `[${name}]`;
    const shown = contents(this);
    return `${name} ${typeof shown === "string" ? shown : inspect(shown, { ...options, depth: null })}`;
  }
  Object.defineProperty(prototype, Symbol.for("nodejs.util.inspect.custom"), { value, configurable: true });
  return true;
}
