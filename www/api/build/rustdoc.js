// Addresses in the Rust documentation, which the site has in the folder rust/.

/** Types that are not in the module of the same name, and enums. @type {Record<string, string>} */
const PAGES = {
  Basis: "curve/enum.Basis.html",
  Easing: "struct.Easing.html",
  InkStroke: "path/struct.InkStroke.html",
  Grid: "mesh/struct.Grid.html",
  NurbsCurve: "struct.NurbsCurve.html",
  NurbsSurface: "struct.NurbsSurface.html",
  PathBuilder: "path/struct.PathBuilder.html",
  RationalCurve: "struct.RationalCurve.html",
  RationalPatch: "struct.RationalPatch.html",
  RationalSurface: "struct.RationalSurface.html",
  TessellationOptions: "mesh/struct.TessellationOptions.html",
};

/** `toSVG` is `to_svg` in Rust. @param {string} name */
export const snakeCase = (name) =>
  name
    .replace(/BSpline/g, "Bspline")
    .replace(/([a-z])([A-Z])/g, "$1_$2")
    .toLowerCase();

/**
 * The address of a symbol: "Curve::nearest", "curve::bernstein" for a function of a module, or "Mesh.positions" for a field.
 *
 * @param {string} symbol
 */
export function rustAddress(symbol) {
  if (symbol.includes(".")) {
    const [type, field] = symbol.split(".");
    return `casteljau/${PAGES[type] ?? `${type.toLowerCase()}/struct.${type}.html`}#structfield.${field}`;
  }
  const [type, name] = symbol.split("::");
  if (/^[a-z]/.test(type)) return `casteljau/${type}/fn.${name}.html`;
  return `casteljau/${PAGES[type] ?? `${type.toLowerCase()}/struct.${type}.html`}#method.${name}`;
}

/**
 * The counterpart in Rust of an entry: what its Rust sample names, or the same name in snake_case.
 *
 * @param {string} title of the page: "Curve"
 * @param {string} id of the entry: "timesAtCoordinate"
 * @param {string} info what stands behind ```rust
 */
export function counterpart(title, id, info) {
  if (info) return info;
  const type = title === "easing" ? "Easing" : title;
  return `${type}::${id === "constructor" ? "new" : snakeCase(id)}`;
}
