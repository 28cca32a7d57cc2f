// The peer verb-nurbs.

/** verb needs a global `window`, and prints its version when it is loaded. */
async function loadVerb() {
  const { log } = console;
  Object.assign(globalThis, { window: globalThis });
  console.log = () => {};
  try {
    return (await import("verb-nurbs")).default;
  } finally {
    console.log = log;
    Reflect.deleteProperty(globalThis, "window");
  }
}

export const verb = await loadVerb();
