// /api/: the names of all entries.
import { indexHtml } from "./build/render.js";
import { reference } from "./build/reference.js";

export const data = {
  permalink: "/api/index.html",
  title: "API reference · casteljau",
  description:
    "Every class, function, option and type of casteljau, with samples in JavaScript and Rust and live figures.",
  heading: "API reference",
  lead: "Every class, function, option and type of the npm package, with samples in JavaScript and Rust. The figures can be dragged; the code below them follows.",
  bodyClass: "wide",
  styles: ["api.css"],
  script: "index.js",
};

export const render = () => indexHtml(reference());
