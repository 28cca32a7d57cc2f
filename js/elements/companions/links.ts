// Finds elements by their id, whichever comes first, and follows as elements and ids come and go.

/** One observer for each tree and all who look for something in it. */
const trees: WeakMap<Node, { observer: MutationObserver; looks: Set<() => void> }> = new WeakMap();

/**
 * Calls `look` whenever an element or an id has changed where `elementFor` looks.
 *
 * @returns ends it
 */
export function followIds(element: Element, look: () => void): () => void {
  const ends = [...new Set([element.getRootNode(), element.ownerDocument])].map((tree) => follow(tree, look));
  return () => ends.forEach((end) => end());
}

function follow(tree: Node, look: () => void): () => void {
  const known = trees.get(tree) ?? observe(tree);
  known.looks.add(look);
  return () => {
    known.looks.delete(look);
    if (known.looks.size > 0) return;
    known.observer.disconnect();
    trees.delete(tree);
  };
}

function observe(tree: Node) {
  const looks = new Set() as Set<() => void>;
  const observer = new MutationObserver(() => looks.forEach((look) => look()));
  observer.observe(tree, { subtree: true, childList: true, attributes: true, attributeFilter: ["id"] });
  const known = { observer, looks };
  trees.set(tree, known);
  return known;
}

/** What stands inside an element and means it. */
const HOST = ":host";

/** The element that `id` means where `element` stands: of its own shadow tree, else of the page. */
export function elementFor(element: Element, id: string): Element | null {
  const tree = element.getRootNode();
  if (id === HOST && tree instanceof ShadowRoot) return tree.host;
  const found = tree instanceof ShadowRoot || tree instanceof Document ? tree.getElementById(id) : null;
  return found ?? element.ownerDocument.getElementById(id);
}
