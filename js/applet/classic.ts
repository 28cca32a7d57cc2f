import { bezierApp } from "./index.js";

Object.assign(globalThis, { bezierApp });
