// Measures the time of the import and of the first call in a new process, for start.js. Prints milliseconds as JSON.
const milliseconds = { import: 0, firstCall: 0, compile: 0, instantiate: 0 };

/**
 * Measures the total time in a constructor of WebAssembly.
 *
 * @param {"Module" | "Instance"} name
 * @param {"compile" | "instantiate"} part
 */
function measure(name, part) {
  /** @type {any} */ (WebAssembly)[name] = new Proxy(WebAssembly[name], {
    construct(target, args) {
      const start = performance.now();
      const instance = Reflect.construct(target, args);
      milliseconds[part] += performance.now() - start;
      return instance;
    },
  });
}

measure("Module", "compile");
measure("Instance", "instantiate");

const start = performance.now();
const { Curve } = await import("casteljau");
const imported = performance.now();
const { x, y } = new Curve([0, 0, 1, 2, 2, 0]).eval(0.5);
milliseconds.firstCall = performance.now() - imported;
milliseconds.import = imported - start;

if (x !== 1 || y !== 1) throw new Error(`first call: expected (1, 1), got (${x}, ${y})`);
if (!(milliseconds.compile > 0)) throw new Error("first call: nothing was compiled");
console.log(JSON.stringify(milliseconds));
