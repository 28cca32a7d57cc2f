// The text of JSDoc comments in declarations: the first sentence, further paragraphs, parameters, results and errors.
import ts from "typescript-api";

/** @typedef {{ summary: string, details: string[], text: string, parameters: Map<string, string>, returns: string, throws: string[] }} Doc */

/** Paragraphs are separated by empty lines; a summary is the first one. @param {string} text @returns {{ summary: string, details: string[], text: string }} */
export function paragraphs(text) {
  const [summary = "", ...details] = text.trim().split(/\n\s*\n/);
  return {
    summary: joinLines(summary),
    details: details.map((part) => (/^ {4}/.test(part) ? part : joinLines(part))),
    text: joinLines(text),
  };
}

/** @param {string} text */
const joinLines = (text) => text.replace(/\s*\n\s*/g, " ").trim();

/** @param {ts.Node} node @returns {Doc} */
export function docOf(node) {
  const comments = /** @type {ts.JSDoc[]} */ (/** @type {any} */ (node).jsDoc ?? []);
  const last = comments.at(-1);
  const text = last ? (ts.getTextOfJSDocComment(last.comment) ?? "") : "";
  const doc = { ...paragraphs(text), parameters: new Map(), returns: "", throws: /** @type {string[]} */ ([]) };
  for (const tag of last?.tags ?? []) addTag(doc, tag);
  if (!doc.summary) doc.summary = doc.returns;
  return doc;
}

/** @param {Doc} doc @param {ts.JSDocTag} tag */
function addTag(doc, tag) {
  const text = joinLines(ts.getTextOfJSDocComment(tag.comment) ?? "");
  if (ts.isJSDocParameterTag(tag)) doc.parameters.set(tag.name.getText(), text);
  else if (ts.isJSDocReturnTag(tag)) doc.returns = text;
  else if (ts.isJSDocThrowsTag(tag)) doc.throws.push(`${tag.typeExpression?.type.getText() ?? "Error"} ${text}`.trim());
}

/**
 * The options that a sentence such as "`tolerance`: the largest distance; `into`: …" describes.
 *
 * @param {string} text
 */
export function fieldsIn(text) {
  const parts = text.split(/(?:^|[;.,] )(?=`\w+`: )/);
  const fields = new Map();
  let rest = "";
  for (const part of parts) {
    const match = /^`(\w+)`: ([\s\S]*)$/.exec(part.trim());
    if (match) fields.set(match[1], match[2]);
    else rest += part;
  }
  return { fields, rest: rest.trim() };
}
