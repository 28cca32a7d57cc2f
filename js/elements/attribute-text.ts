// Frameworks set properties with what a template has: attributes' texts, undefined for what a template no longer has.

export interface Accessor {
  get: (this: any) => unknown;
  set: (this: any, value: any) => void;
}

/**
 * An accessor of a Lit property that takes two more values: a text means what it means in the attribute (unless the
 * property is a text itself), and undefined is the value that the constructor sets.
 */
export function acceptAttributeText(
  accessor: PropertyDescriptor | undefined,
  name: PropertyKey,
  options: import("lit").PropertyDeclaration,
): PropertyDescriptor {
  const { get, set } = accessor as Accessor;
  const isText = options.type !== Number && options.type !== Boolean;
  const initial: WeakMap<object, { value: unknown }> = new WeakMap();
  return {
    ...accessor,
    get,
    set(this: HTMLElement, value: unknown) {
      if (!initial.has(this)) initial.set(this, { value });
      if (typeof value === "string" && !isText) this.setAttribute(String(options.attribute ?? name), value);
      else set.call(this, value === undefined ? initial.get(this)?.value : value);
    },
  };
}

/** The property `controls`: true and false as well as the words of an attribute. */
export const CONTROLS = {
  converter: {
    fromAttribute: (value: string | null) => value,
    toAttribute: (value: unknown) => (value === true ? "" : value === false || value === null ? null : String(value)),
  },
  reflect: true,
};

/** The groups of controls that a value of `controls` names; none means all. */
export function controlGroups(controls: string | boolean | null): string[] {
  return typeof controls === "string" ? controls.split(/\s+/).filter(Boolean) : [];
}

/**
 * Writes a value that frameworks have as an attribute: a text, or undefined for none.
 *
 * @returns whether it was such a value
 */
export function writeAttribute(element: HTMLElement, name: string, value: unknown): boolean {
  if (value === undefined) element.removeAttribute(name);
  else if (typeof value === "string") element.setAttribute(name, value);
  else return false;
  return true;
}
