/**
 * Makes an element. Properties are set as properties, those with a hyphen (and `role`, `part`) as attributes,
 * those that begin with "on" as listeners.
 *
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Document} page
 * @param {Tag} tag
 * @param {Record<string, unknown>} [properties]
 * @param {(Node | string)[]} children
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function element(page, tag, properties = {}, ...children) {
  const made = page.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith("on")) made.addEventListener(name.slice(2), /** @type {EventListener} */ (value));
    else if (name in made && name !== "part") Object.assign(made, { [name]: value });
    else made.setAttribute(name, String(value));
  }
  made.append(...children);
  return made;
}
