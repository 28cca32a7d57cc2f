// The elements' classes without a page: what the tests of tests/js/element-*.test.js share.

globalThis.CSSStyleSheet ??= /** @type {any} */ (
  class {
    replaceSync() {}
  }
);

/**
 * A new element whose attributes, as in a document, are reported when they change.
 *
 * @param {any} Type the element's class
 * @param {Record<string, string>} [attributes]
 * @returns {any}
 */
export function elementOf(Type, attributes = {}) {
  const InNode = class extends Type {
    setAttribute(name, value) {
      const before = this.getAttribute(name);
      super.setAttribute(name, value);
      this.attributeChangedCallback(name, before, String(value));
    }
    removeAttribute(name) {
      const before = this.getAttribute(name);
      super.removeAttribute(name);
      this.attributeChangedCallback(name, before, null);
    }
  };
  customElements.define(`element-in-node-${++count}`, /** @type {any} */ (InNode));
  const element = /** @type {any} */ (new InNode());
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  return element;
}

let count = 0;
