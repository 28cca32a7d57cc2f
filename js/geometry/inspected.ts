// What `console.log` shows of a value in Node. The classes call this when they make their first instance: a method with a
// computed name, or a call beside the class, would make bundlers keep an unused class.

/**
 * Defines what Node shows of the instances of a class: the name and the contents, as
 * `Curve { points: [ [ 0, 0 ], [ 1, 2 ] ] }`.
 *
 * @internal
 * @param name a text of its own, because minifiers change the names of classes
 * @param contents a text is shown without quotes
 */
export function showInNode<T>(prototype: T, name: string, contents: (value: T) => unknown): true {
  /**
   * @param depth how many levels of objects may be shown
   */
  function value(this: T, depth: number, options: object, inspect: (value: unknown, options: object) => string) {
    if (depth < 0) return `[${name}]`;
    const shown = contents(this);
    return `${name} ${typeof shown === "string" ? shown : inspect(shown, { ...options, depth: null })}`;
  }
  Object.defineProperty(prototype, Symbol.for("nodejs.util.inspect.custom"), { value, configurable: true });
  return true;
}
