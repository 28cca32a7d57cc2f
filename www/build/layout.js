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
