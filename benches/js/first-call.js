// Run in a process of its own by start.js: how long until the first answer? Prints the milliseconds as JSON.
const milliseconds = { import: 0, firstCall: 0, compile: 0, instantiate: 0 };

/**
 * Adds up the time that a constructor of WebAssembly takes.
 *
 * @param {"Module" | "Instance"} name
 * @param {"compile" | "instantiate"} part
 */
function watch(name, part) {
  /** @type {any} */ (WebAssembly)[name] = new Proxy(WebAssembly[name], {
    construct(target, args) {
      const start = performance.now();
      const made = Reflect.construct(target, args);
      milliseconds[part] += performance.now() - start;
      return made;
    },
  });
}

watch("Module", "compile");
watch("Instance", "instantiate");

const start = performance.now();
const { Curve } = await import("casteljau");
const imported = performance.now();
const { x, y } = new Curve([0, 0, 1, 2, 2, 0]).eval(0.5);
milliseconds.firstCall = performance.now() - imported;
milliseconds.import = imported - start;

if (x !== 1 || y !== 1) throw new Error(`first call: expected (1, 1), got (${x}, ${y})`);
if (!(milliseconds.compile > 0)) throw new Error("first call: nothing was compiled");
console.log(JSON.stringify(milliseconds));
