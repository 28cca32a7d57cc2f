// Prints values as `console.log` of Node does, for what samples print: on one line, optionally with rounded numbers.

/**
 * @param {unknown} value
 * @param {number} [digits] significant digits of numbers; all of them by default
 * @returns {string}
 */
export function inspect(value, digits) {
  if (typeof value === "string") return value;
  return written(value, digits);
}

/** @param {unknown} value @param {number | undefined} digits @returns {string} */
function written(value, digits) {
  if (typeof value === "number") return numberText(value, digits);
  if (typeof value === "string") return quoted(value);
  if (ArrayBuffer.isView(value)) {
    const list = /** @type {Float64Array} */ (/** @type {unknown} */ (value));
    return `${value.constructor.name}(${list.length}) ${listText(Array.from(list), digits)}`;
  }
  if (Array.isArray(value)) return listText(value, digits);
  if (value === null || typeof value !== "object") return String(value);
  const custom = /** @type {any} */ (value)[Symbol.for("nodejs.util.inspect.custom")];
  if (custom) return custom.call(value, 2, {}, (/** @type {unknown} */ inner) => written(inner, digits));
  const fields = Object.entries(value).map(([name, field]) => `${name}: ${written(field, digits)}`);
  return fields.length === 0 ? "{}" : `{ ${fields.join(", ")} }`;
}

/** @param {unknown[]} list @param {number | undefined} digits */
const listText = (list, digits) =>
  list.length === 0 ? "[]" : `[ ${list.map((item) => written(item, digits)).join(", ")} ]`;

/** @param {number} value @param {number | undefined} digits */
function numberText(value, digits) {
  if (Object.is(value, -0)) return "-0";
  return String(digits === undefined ? value : Number(value.toPrecision(digits)));
}

/** @param {string} text */
const quoted = (text) => (text.includes("'") ? JSON.stringify(text) : `'${text}'`);
