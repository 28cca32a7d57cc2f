// Figures that show the same points in different ways: what moves in one moves in all.

/** @typedef {HTMLElement & { points: [number, number][], t: number }} Figure */

/** @param {readonly Element[]} elements */
export function share(elements) {
  for (const from of /** @type {Figure[]} */ (elements)) {
    const pass = () => {
      for (const to of /** @type {Figure[]} */ (elements))
        if (to !== from) Object.assign(to, { points: from.points, t: from.t });
    };
    from.addEventListener("input", pass);
    from.addEventListener("change", pass);
  }
}

/** All groups of a page: the figures inside of [data-shared-points], and those with the same data-shares. @param {ParentNode} root */
export function shareAll(root) {
  for (const group of root.querySelectorAll("[data-shared-points]"))
    share([...group.querySelectorAll("bezier-applet")]);
  const named = /** @type {HTMLElement[]} */ ([...root.querySelectorAll("[data-shares]")]);
  for (const name of new Set(named.map(({ dataset }) => dataset.shares)))
    share(named.filter(({ dataset }) => dataset.shares === name));
}
