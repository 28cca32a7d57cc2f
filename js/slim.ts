// The same package without the wasm inside: xtask/bundle.js leaves the bytes out of this entry's bundle.
export * from "./index.js";
