// How a companion asks for the code of the element that its `for` names, without importing it.

/** `request` fetches the code of an element by its name, and returns whether it knows the name. casteljau/elements sets it. */
export const loader: { request: (name: string) => boolean } = { request: () => false };
