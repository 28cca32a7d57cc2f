// Which tasks are solved: kept in the browser (localStorage) if it allows that, else until the page is closed.

const KEY = "casteljau-progress";

/** @typedef {Record<string, string>} Progress the day of the solution, such as "2026-11-23", by chapter and task: "curves/half-height" */

/** What is kept where the browser keeps nothing. @type {Progress} */
let fallback = {};

/** The chapter: its folder. */
const chapter = () =>
  /** @type {HTMLElement | null} */ (document.querySelector("[data-chapter]"))?.dataset.chapter ?? "";

/** @param {string} task */
const idOf = (task) => `${chapter()}/${task}`;

/** All solved tasks of all chapters. @returns {Progress} */
export function readProgress() {
  try {
    return validated(JSON.parse(localStorage.getItem(KEY) ?? "{}"));
  } catch {
    return fallback; // no storage, or not ours
  }
}

/** The entries that can be an id and a day. @param {unknown} value @returns {Progress} */
function validated(value) {
  if (typeof value !== "object" || value === null || Array.isArray(value)) return {};
  return Object.fromEntries(
    Object.entries(value).filter(([id, day]) => id.includes("/") && typeof day === "string" && day.length === 10),
  );
}

/** @param {Progress} progress @returns {boolean} whether the browser keeps it */
function write(progress) {
  fallback = progress;
  try {
    localStorage.setItem(KEY, JSON.stringify(progress));
    return true;
  } catch {
    return false;
  }
}

/** @param {string} task of this chapter */
export const isSolved = (task) => idOf(task) in readProgress();

/** @param {string} task of this chapter */
export function markSolved(task) {
  if (!isSolved(task)) write({ ...readProgress(), [idOf(task)]: new Date().toISOString().slice(0, 10) });
}

/** Forgets the tasks of this chapter. */
export function forgetChapter() {
  write(Object.fromEntries(Object.entries(readProgress()).filter(([id]) => !id.startsWith(idOf("")))));
}

/** All progress as the text of a file. */
export const exportText = () =>
  `${JSON.stringify({ format: "casteljau-progress", version: 1, solved: readProgress() }, null, 2)}\n`;
