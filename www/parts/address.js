// Which attributes of the elements an address may set (a link to a figure, or embed.html's query), and in which form.
// The range of numbers and the meaning of words are the elements' own business: they say what they cannot use.

/** Nobody types or shares a longer one; what is longer is not read at all. */
export const LONGEST_ADDRESS = 10_000;
const MAX_SHOWN = 40;

const POINTS = "points";
const NUMBER = "number";
const NUMBERS = "numbers";
const WORDS = "words";

/** @typedef {typeof POINTS | typeof NUMBER | typeof NUMBERS | typeof WORDS | "text"} Form */

/** @type {Record<string, Record<string, Form>>} by the element's name, then the attribute's */
export const SHARED = {
  "bezier-applet": {
    points: POINTS,
    weights: NUMBERS,
    "visible-points": NUMBER,
    joints: WORDS,
    basis: WORDS,
    degree: WORDS,
    matrix: NUMBERS,
    t: NUMBER,
    segment: NUMBER,
    show: WORDS,
    labels: WORDS,
    tolerance: NUMBER,
    segments: NUMBER,
    offset: NUMBER,
    ticks: NUMBER,
    view: NUMBERS,
  },
  "bezier-surface": {
    model: WORDS,
    parts: WORDS,
    height: WORDS,
    up: WORDS,
    segments: NUMBER,
    tolerance: NUMBER,
    pixels: NUMBER,
    flatness: NUMBER,
    lines: NUMBER,
    shading: WORDS,
    show: WORDS,
    evaluation: WORDS,
    u: NUMBER,
    v: NUMBER,
    step: NUMBER,
    patch: NUMBER,
  },
};

/** The property of an attribute: "visible-points" is `visiblePoints`. @param {string} attribute */
export const propertyOf = (attribute) => attribute.replace(/-(.)/g, (_, letter) => letter.toUpperCase());

/** Whose empty value is a yes. */
const FLAGS = { controls: true, readonly: true, turn: true, swept: true };

const isNumber = (/** @type {string} */ text) =>
  /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text) && Number.isFinite(Number(text));
const parts = (/** @type {string} */ text, /** @type {RegExp} */ between) => text.trim().split(between);

/** @type {Record<Form, { is: (text: string) => boolean, expected: string }>} */
const FORMS = {
  points: {
    is: (text) => parts(text, /\s+/).every((pair) => pair.split(",").length === 2 && pair.split(",").every(isNumber)),
    expected: "pairs of numbers such as 10,20 30,40",
  },
  number: { is: isNumber, expected: "a number" },
  numbers: { is: (text) => parts(text, /[\s,]+/).every(isNumber), expected: "numbers" },
  words: { is: (text) => /^[\w\s,-]*$/.test(text), expected: "words" },
  text: { is: () => true, expected: "text" },
};

/** A value as it can be told: foreign and perhaps long. @param {string} text */
export const shortened = (text) => (text.length > MAX_SHOWN ? `${text.slice(0, MAX_SHOWN)}…` : text);

/**
 * What of a query an element can be given; an empty value means the attribute's absence.
 *
 * @param {string} query as after a question mark; broken percent-encoding is no error
 * @param {Record<string, Form>} known
 * @returns {{ values: Map<string, string>, problems: string[] }}
 */
export function read(query, known) {
  const values = new Map();
  const problems = [];
  for (const [name, value] of new URLSearchParams(query)) {
    const form = Object.hasOwn(known, name) ? FORMS[known[name]] : undefined;
    if (!form) problems.push(`“${shortened(name)}” is not known here`);
    else if (value === "" || form.is(value)) values.set(name, value);
    else problems.push(`${name}: expected ${form.expected}, got “${shortened(value)}”`);
  }
  return { values, problems };
}

/**
 * @param {Element} element
 * @param {Map<string, string>} values
 */
export function apply(element, values) {
  for (const [name, value] of values) {
    if (value === "" && !(name in FLAGS)) element.removeAttribute(name);
    else element.setAttribute(name, value);
  }
}

/** Coordinates to a hundredth; nothing encoded that may stand in an address as it is. @param {Map<string, string>} values */
export function write(values) {
  const tidy = (/** @type {string} */ text) =>
    text.replace(/-?\d+\.\d{3,}(?![\de])/g, (number) => String(Number(Number(number).toFixed(2))));
  const pairs = Array.from(
    values,
    ([name, value]) => `${name}=${encodeURIComponent(name === "points" ? tidy(value) : value)}`,
  );
  return pairs.join("&").replaceAll("%20", "+").replaceAll("%2C", ",");
}
