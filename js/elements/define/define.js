const registry = globalThis.customElements;

/**
 * Defines an element, once on a page: a second copy of this package takes the class of the first. Where there is no
 * document it does nothing.
 *
 * @template T
 * @param {string} name
 * @param {CustomElementConstructor} type
 * @returns {T}
 */
export function define(name, type) {
  if (registry && !registry.get(name)) registry.define(name, type);
  return /** @type {T} */ (/** @type {unknown} */ (registry?.get(name) ?? type));
}
