// The pages that every page links to, in three groups: the bar (_layouts/header.njk) and the end of the first page show them.

/** @typedef {{ path: string, name: string, about: string }} Entry */

/** @type {{ name: string, id: string, entries: Entry[] }[]} */
export const NAVIGATION = [
  {
    name: "Learn",
    id: "learn",
    entries: [
      { path: "curves/", name: "Bézier curves", about: "from two points to splines, with tasks" },
      { path: "surfaces/", name: "Bézier surfaces", about: "from one patch to the teapot, with tasks" },
      { path: "figures/", name: "Figures", about: "the small figures of both chapters" },
    ],
  },
  {
    name: "Tools",
    id: "use",
    entries: [
      { path: "easing/", name: "Easing", about: "draw a timing function, copy the CSS" },
      { path: "glyph/", name: "Glyphs", about: "outlines with corners and smooth joints" },
      { path: "ink/", name: "Ink", about: "strokes with pressure, as SVG" },
      { path: "camera/", name: "Camera", about: "a flight at constant speed" },
      { path: "teapot/", name: "Teapot", about: "a wireframe, one call per frame" },
      { path: "applet/", name: "Applet", about: "a curve on a plain page, to copy" },
    ],
  },
  {
    name: "Docs",
    id: "package",
    entries: [
      { path: "install/", name: "Installation", about: "npm, cargo, script tag, frameworks" },
      { path: "api/", name: "API", about: "every class, method and type" },
      { path: "recipes/", name: "Recipes", about: "complete programs to copy" },
      { path: "elements/", name: "Elements", about: "these figures on your pages" },
      { path: "migration/", name: "Migration", about: "from bezier-js, paper.js and others" },
      { path: "benchmarks/", name: "Benchmarks", about: "times and sizes compared" },
      { path: "conformance/", name: "Conformance", about: "right and wrong answers compared" },
    ],
  },
];
