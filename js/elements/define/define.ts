const registry = globalThis.customElements;

/**
 * Defines an element, once on a page: a second copy of this package takes the class of the first. Where there is no
 * document it does nothing.
 */
export function define<T>(name: string, type: CustomElementConstructor): T {
  if (registry && !registry.get(name)) registry.define(name, type);
  return (registry?.get(name) ?? type) as unknown as T;
}
