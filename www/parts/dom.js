// What the parts of the site share when they make elements.

let count = 0;

/** An id that is nowhere else on the page. @param {string} role */
export const uniqueId = (role) => `part-${role}-${++count}`;

/**
 * @param {string} title
 * @param {() => void} act
 * @param {string} [className]
 * @returns {HTMLButtonElement}
 */
export function button(title, act, className = "") {
  const made = Object.assign(document.createElement("button"), { type: "button", textContent: title, className });
  made.addEventListener("click", act);
  return made;
}

/**
 * @param {string} tag
 * @param {Record<string, string>} [properties]
 * @param {...(Node | string)} children
 */
export function element(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}
