// Frameworks set properties with what a template has: attributes' texts, undefined for what a template no longer has.
import type { PropertyDeclaration } from "lit";

/** The attribute of a property: `visiblePoints` has the attribute `visible-points`. */
export const attributeName = (property: string) => property.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);

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
  options: PropertyDeclaration,
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

/** Groups of controls by their names, each with its parts; none means all. */
export type ControlGroups = Map<string, string[]>;

/** The groups that a value of `controls` names: "t show:polygon,hull" is the group t and two parts of the group show. */
export function controlGroups(controls: string | boolean | null): ControlGroups {
  const words = typeof controls === "string" ? controls.split(/\s+/).filter(Boolean) : [];
  return new Map(
    words.map((word) => {
      const [name, parts = ""] = word.split(":");
      return [name, parts.split(",").filter(Boolean)];
    }),
  );
}

/** Whether a group that is shown has a part. */
export function hasPart(groups: ControlGroups, group: string, part: string): boolean {
  const parts = groups.get(group) ?? [];
  return !parts.length || parts.includes(part);
}

/**
 * Writes a value that frameworks have as an attribute: a text, or undefined for none.
 *
 * @param name of the property
 * @returns whether it was such a value
 */
export function writeAttribute(element: HTMLElement, name: string, value: unknown): boolean {
  if (value === undefined) element.removeAttribute(attributeName(name));
  else if (typeof value === "string") element.setAttribute(attributeName(name), value);
  else return false;
  return true;
}
