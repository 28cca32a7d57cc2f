// What `console.log` shows of a value in Node. The method has a computed name, because of which bundlers would keep an
// unused class. They drop an unused call that is marked as pure, so the method is in a class that such a call returns.

/**
 * A class whose instances Node shows with the name and their `toJSON`, as `Curve { points: [ [ 0, 0 ], [ 1, 2 ] ] }`.
 *
 * @internal
 * @param {string} name a text of its own, because minifiers change the names of classes
 * @returns {new () => object}
 */
export function inspectedAs(name) {
  return class {
    /**
     * @param {number} depth how many levels of objects may be shown
     * @param {object} options
     * @param {(value: unknown, options: object) => string} inspect
     * @returns {string}
     */
    [Symbol.for("nodejs.util.inspect.custom")](depth, options, inspect) {
      if (depth < 0) return `[${name}]`;
      return `${name} ${inspect(/** @type {any} */ (this).toJSON(), { ...options, depth: null })}`;
    }
  };
}
