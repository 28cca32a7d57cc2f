// Values in the "got …" part of messages. Minifiers change the names of classes and functions, so messages do not
// contain them: the classes of this package are known by their brands, built-in ones by their tags.

/** `casteljauType` of the classes of this package, which is the name in lower case. */
const TYPE = /^(rational|nurbs)?(curve|spline|path|patch|surface|mesh)$/;

const capitalized = (word: string) => word.charAt(0).toUpperCase() + word.slice(1);

/** The longest part of a text, and the largest number of keys of an object, that a message shows. */
const MAX_TEXT_LENGTH = 40;
const MAX_KEYS = 4;

/** Of `{}`, and of a structured clone of a value of this package. */
export const EMPTY = "an object without keys";

/** Describes a value for the "got …" part of a message. */
export function describe(value: unknown): string {
  if (typeof value === "string") return JSON.stringify(shorten(value));
  if (typeof value === "bigint") return `${value}n`;
  if (typeof value === "function") return "a function";
  if (typeof value !== "object" || value === null) return String(value);
  if (Array.isArray(value)) return `an array of ${value.length}`;
  const { casteljauType } = value as { casteljauType?: unknown };
  const [, kind = "", type] = TYPE.exec(String(casteljauType)) ?? [];
  if (type) return `a ${capitalized(kind)}${capitalized(type)}`;
  const tag = Object.prototype.toString.call(value).slice("[object ".length, -1);
  if (tag !== "Object") return `an object (${tag})`;
  const keys = Object.keys(value);
  if (keys.length === 0) return EMPTY;
  return `an object with ${shorten(keys.slice(0, MAX_KEYS).join(", "))}${keys.length > MAX_KEYS ? ", …" : ""}`;
}

export function shorten(text: string): string {
  return text.length > MAX_TEXT_LENGTH ? `${text.slice(0, MAX_TEXT_LENGTH)}…` : text;
}
