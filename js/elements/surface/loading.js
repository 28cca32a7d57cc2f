// The part that draws (WebGL and what it needs) is a file of its own: pages without a surface in sight never fetch it.

/** @typedef {typeof import("./stage.js").Stage} StageClass */

/** Underway or there, for all elements of the page. @type {Promise<StageClass> | null} */
let loading = null;

/**
 * The class of the stage. Where it could not be fetched, the next call asks again.
 *
 * @returns {Promise<StageClass>}
 */
export function loadStage() {
  loading ??= import("./stage.js").then(
    ({ Stage }) => Stage,
    (error) => {
      loading = null;
      throw error;
    },
  );
  return loading;
}
