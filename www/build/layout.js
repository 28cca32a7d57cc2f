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
    title: title.replace(/ <a class="permalink".*<\/a>/, ""),
  }));

/** Words that a reader of English as a second language reads in a minute, and minutes for a task. */
const WORDS_PER_MINUTE = 180;
const MINUTES_PER_TASK = 1;

/**
 * How long a page takes to read, with its tasks: in minutes, a multiple of five. Code and formulas are not counted.
 *
 * @param {string} html
 */
export function readingMinutes(html) {
  const text = html.replace(/<(pre|svg|math|script)\b.*?<\/\1>/gs, " ").replace(/<[^>]*>/g, " ");
  const words = text.match(/\p{L}[\p{L}\p{N}’'-]*/gu)?.length ?? 0;
  const tasks = html.match(/<lesson-task\b/g)?.length ?? 0;
  return 5 * Math.max(1, Math.round((words / WORDS_PER_MINUTE + tasks * MINUTES_PER_TASK) / 5));
}

/**
 * The page of the chapter after this one, if there is one.
 *
 * @template {{ data: { chapter?: number } }} Page
 * @param {Page[]} chapters
 * @param {number} chapter
 * @returns {Page | undefined}
 */
export const nextChapter = (chapters, chapter) => chapters.find(({ data }) => data.chapter === chapter + 1);
