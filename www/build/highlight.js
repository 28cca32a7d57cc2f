// Colours for code: enough to tell words, strings, numbers and comments apart. Runs while the site is built.

const KEYWORDS = {
  js: "await break case class const continue default delete else export extends false for from function if import in instanceof let new null of return static super switch this throw true try typeof undefined while yield",
  rs: "as bool break const continue crate else enum f32 f64 false fn for if impl in let loop match mod move mut pub ref return self Self struct super trait true type use usize where while",
  html: "",
  css: "",
};

/** Order matters: what begins a comment or a string is neither a word nor a number. A Rust lifetime is no string. */
const TOKENS =
  /(?<comment>\/\/[^\n]*|\/\*[\s\S]*?\*\/|<!--[\s\S]*?-->)|(?<string>"(?:\\.|[^"\\])*"|`(?:\\.|[^`\\])*`|'(?:\\.|[^'\\\n])')|(?<number>\b\d[\d_]*(?:\.\d+)?(?:e[+-]?\d+)?(?:f64|f32|u32|usize|_f64)?\b)|(?<word>[A-Za-z_$][\w$]*)/g;

/** @param {string} text */
export const escapeHtml = (text) =>
  text.replace(/[&<>"]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c] ?? c);

/**
 * The code as HTML, with `<span class="comment|string|number|keyword">` around what is one.
 *
 * @param {string} code
 * @param {keyof typeof KEYWORDS} language
 * @returns {string}
 */
export function highlight(code, language) {
  const keywords = new Set(KEYWORDS[language].split(" "));
  let html = "";
  let end = 0;
  for (const match of code.matchAll(TOKENS)) {
    const kind = Object.entries(match.groups ?? {}).find(([, text]) => text !== undefined)?.[0];
    const name = kind !== "word" ? kind : keywords.has(match[0]) ? "keyword" : "";
    html += escapeHtml(code.slice(end, match.index));
    html += name ? `<span class="${name}">${escapeHtml(match[0])}</span>` : escapeHtml(match[0]);
    end = match.index + match[0].length;
  }
  return html + escapeHtml(code.slice(end));
}
