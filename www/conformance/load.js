// The modules that ask the libraries, by their names. Each is loaded when it is asked.

/** @type {Record<string, () => Promise<{ answers: import("./answers.js").Answers }>>} */
export const LOADERS = {
  casteljau: () => import("./libraries/casteljau.js"),
  "bezier-js": () => import("./libraries/bezier-js.js"),
  "paper.js": () => import("./libraries/paper.js"),
  "svg-path-properties": () => import("./libraries/svg-path-properties.js"),
  // It looks for a window, and prints its version.
  verb: async () => {
    const { log } = console;
    Object.assign(globalThis, { window: globalThis });
    console.log = () => {};
    try {
      return await import("./libraries/verb.js");
    } finally {
      console.log = log;
    }
  },
};
