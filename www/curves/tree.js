// What the tree of halvings measures, in words.

/**
 * @param {HTMLElement} words
 * @param {HTMLElement & { figure: { tree: { segments: number, error: number } | null } }} applet
 */
export function treeReadout(words, applet) {
  const update = () => (words.textContent = treeWords(applet.figure.tree));
  applet.addEventListener("update", update);
  update();
}

/** @param {{ segments: number, error: number } | null} tree */
export function treeWords(tree) {
  if (!tree) return "";
  const error = tree.error < 0.01 ? tree.error.toExponential(1) : tree.error.toFixed(2);
  return `${tree.segments} ${tree.segments === 1 ? "piece" : "pieces"}, measured error ${error} px.`;
}
