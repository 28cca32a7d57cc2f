// What companions show is a file of its own: pages without a companion in sight never fetch it.

/** @typedef {typeof import("./views.js")} Views */

/** Underway or there, for all companions of the page. @type {Promise<Views> | null} */
let loading = null;

/**
 * Where it could not be fetched, the next call asks again.
 *
 * @returns {Promise<Views>}
 */
export function loadViews() {
  loading ??= import("./views.js").catch((error) => {
    loading = null;
    throw error;
  });
  return loading;
}
