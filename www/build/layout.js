// Filters for the layouts.

/** The relative path from a page to the first page: "" or "../". @param {string} url */
export const pathToRoot = (url) => "../".repeat(url.split("/").length - 2);

/**
 * The table of contents: the sections of a page (build/sections.js) with their titles.
 *
 * @param {string} html
 * @returns {{ id: string, title: string }[]} title as HTML
 */
export const contentsOf = (html) =>
  Array.from(html.matchAll(/<section id="([^"]+)"[^>]*>\s*<h2[^>]*>(.*?)<\/h2>/gs), ([, id, title]) => ({
    id,
    title: title.replace(/ <a class="permalink".*<\/a>/, "").replace(/<\/?a\b[^>]*>/g, ""),
  }));

/** Words that a reader of English as a second language reads in a minute of a mathematical text, and minutes for a task. */
const WORDS_PER_MINUTE = 120;
const MINUTES_PER_TASK = 3;

/**
 * How long a page takes to read, with its tasks: "25 minutes", a multiple of five, or from an hour on "2½ hours". Code and
 * formulas are not counted.
 *
 * @param {string} html
 */
export function readingTime(html) {
  const text = html.replace(/<(pre|svg|math|script)\b.*?<\/\1>/gs, " ").replace(/<[^>]*>/g, " ");
  const words = text.match(/\p{L}[\p{L}\p{N}’'-]*/gu)?.length ?? 0;
  const tasks = html.match(/<lesson-task\b/g)?.length ?? 0;
  const minutes = words / WORDS_PER_MINUTE + tasks * MINUTES_PER_TASK;
  if (minutes < 57.5) return `${5 * Math.max(1, Math.round(minutes / 5))} minutes`;
  const halves = Math.round(minutes / 30);
  if (halves === 2) return "1 hour";
  return `${Math.floor(halves / 2)}${halves % 2 ? "½" : ""} hours`;
}
