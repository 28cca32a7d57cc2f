// Finds elements by their id, whichever comes first, and follows as elements and ids come and go.

/**
 * One observer for each tree and all who look for something in it.
 *
 * @type {WeakMap<Node, { observer: MutationObserver, looks: Set<() => void> }>}
 */
const trees = new WeakMap();

/**
 * Calls `look` whenever an element or an id of the tree has changed.
 *
 * @param {Node} tree
 * @param {() => void} look
 * @returns {() => void} ends it
 */
export function followIds(tree, look) {
  const known = trees.get(tree) ?? observe(tree);
  known.looks.add(look);
  return () => {
    known.looks.delete(look);
    if (known.looks.size > 0) return;
    known.observer.disconnect();
    trees.delete(tree);
  };
}

/** @param {Node} tree */
function observe(tree) {
  const looks = /** @type {Set<() => void>} */ (new Set());
  const observer = new MutationObserver(() => looks.forEach((look) => look()));
  observer.observe(tree, { subtree: true, childList: true, attributes: true, attributeFilter: ["id"] });
  const known = { observer, looks };
  trees.set(tree, known);
  return known;
}

/** What stands inside an element and means it. */
const HOST = ":host";

/**
 * The element that `id` means where `element` stands: of its own shadow tree, else of the page.
 *
 * @param {Element} element
 * @param {string} id
 * @returns {Element | null}
 */
export function elementFor(element, id) {
  const tree = element.getRootNode();
  if (id === HOST && tree instanceof ShadowRoot) return tree.host;
  const found = tree instanceof ShadowRoot || tree instanceof Document ? tree.getElementById(id) : null;
  return found ?? element.ownerDocument.getElementById(id);
}
