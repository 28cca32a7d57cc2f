// Defines the elements of the package that are on the page, each from a file of its own: only a page with <bezier-surface>
// loads the module of surfaces.

/** @type {Record<string, () => Promise<unknown>>} */
export const DEFINITIONS = {
  "bezier-applet": () => import("casteljau/elements/applet"),
  "bezier-bernstein": () => import("casteljau/elements/bernstein"),
  "bezier-coordinates": () => import("casteljau/elements/coordinates"),
  "bezier-easing": () => import("casteljau/elements/easing"),
  "bezier-equation": () => import("casteljau/elements/equation"),
  "bezier-surface": () => import("casteljau/elements/surface"),
};

for (const [name, define] of Object.entries(DEFINITIONS)) if (document.querySelector(name)) void define();
