// Elements that a page wrote to before they were defined.

/** What a page wrote before the element was defined lies over the accessors: takes it away and writes it again. */
export function adoptProperties(element: any, names: string[]) {
  for (const name of names) {
    if (!Object.hasOwn(element, name)) continue;
    const value = element[name];
    delete element[name];
    element[name] = value;
  }
}
