// Frameworks set properties with what a template has: attributes' texts, undefined for what a template no longer has.

/**
 * @typedef {object} Accessor
 * @property {(this: any) => unknown} get
 * @property {(this: any, value: any) => void} set
 */

/**
 * An accessor of a Lit property that takes two more values: a text means what it means in the attribute (unless the
 * property is a text itself), and undefined is the value that the constructor sets.
 *
 * @param {PropertyDescriptor | undefined} accessor
 * @param {PropertyKey} name
 * @param {import("lit").PropertyDeclaration} options
 * @returns {PropertyDescriptor}
 */
export function acceptAttributeText(accessor, name, options) {
  const { get, set } = /** @type {Accessor} */ (accessor);
  const isText = options.type !== Number && options.type !== Boolean;
  /** @type {WeakMap<object, { value: unknown }>} */
  const initial = new WeakMap();
  return {
    ...accessor,
    get,
    /** @this {HTMLElement} @param {unknown} value */
    set(value) {
      if (!initial.has(this)) initial.set(this, { value });
      if (typeof value === "string" && !isText) this.setAttribute(String(options.attribute ?? name), value);
      else set.call(this, value === undefined ? initial.get(this)?.value : value);
    },
  };
}

/**
 * Writes a value that frameworks have as an attribute: a text, or undefined for none.
 *
 * @param {HTMLElement} element
 * @param {string} name
 * @param {unknown} value
 * @returns {boolean} whether it was such a value
 */
export function writeAttribute(element, name, value) {
  if (value === undefined) element.removeAttribute(name);
  else if (typeof value === "string") element.setAttribute(name, value);
  else return false;
  return true;
}
