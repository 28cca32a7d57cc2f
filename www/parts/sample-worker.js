// Runs edited code of a sample, away from the page: what does not end there can be ended.

/** What a sample can import. @type {Record<string, () => Promise<unknown>>} */
const PACKAGE = {
  casteljau: () => import("casteljau"),
  "casteljau/core": () => import("casteljau/core"),
  "casteljau/easing": () => import("casteljau/easing"),
  "casteljau/nurbs": () => import("casteljau/nurbs"),
  "casteljau/surfaces": () => import("casteljau/surfaces"),
};

/** @param {string} name */
function load(name) {
  if (!Object.hasOwn(PACKAGE, name))
    throw new Error(`expected ${Object.keys(PACKAGE).join(", ")} in an import, got ${name}`);
  return PACKAGE[name]();
}

/** Imports as a function may have them. @param {string} code */
const withoutImports = (code) =>
  code.replace(/^import\s*(\{[^}]*\})\s*from\s*["']([^"']+)["'];?/gm, (_, names, name) => {
    const parts = names.replaceAll(/\bas\b/g, ":");
    return `const ${parts} = await load(${JSON.stringify(name)});`;
  });

const AsyncFunction = /** @type {FunctionConstructor} */ ((async () => {}).constructor);

addEventListener("message", async ({ data }) => {
  const lines = /** @type {string[]} */ ([]);
  const print = (/** @type {unknown[]} */ ...values) => lines.push(values.join(" "));
  try {
    await new AsyncFunction("console", "load", withoutImports(data))({ log: print }, load);
  } catch (error) {
    lines.push(String(error));
  }
  postMessage(lines.join("\n"));
});
