import { BezierApp } from "./app.js";
import { kindOf } from "../editor/check.js";
import { DEFAULT_BOX } from "../editor/plane.js";

export { setTranslations } from "../editor/translations.js";
import type { Box } from "../editor/plane.js";

/** Where nothing else is given. */
const DEFAULT_ID = "beziercanvas";

/** The applets that live. */
const apps: WeakMap<HTMLCanvasElement, BezierApp> = new WeakMap();

/**
 * Turns a canvas into the applet: seven control points to drag, two cubic Bézier curves that share P3.
 *
 *     <canvas id="beziercanvas" width="670" height="480"></canvas>
 *     <script type="module">
 *       import { bezierApp } from "casteljau/applet";
 *       const app = bezierApp("beziercanvas");
 *     </script>
 *
 * The canvas's width and height are the picture's own size, in whose units the points are given; on the page it takes
 * that width or, where there is less room, all there is. A second call on the same canvas returns the same applet.
 *
 * @param target a canvas or its id; anything else, as the load event, means the canvas `#beziercanvas`
 * @throws {TypeError} where there is no such canvas, or it is no canvas, or one that shows no 2D pictures
 */
export function bezierApp(target?: unknown): BezierApp {
  const canvas = findCanvas(target);
  const known = apps.get(canvas);
  if (known) return known;
  const app = new BezierApp(canvas, contextOf(canvas), boxOf(canvas), () => apps.delete(canvas));
  apps.set(canvas, app);
  return app;
}

function findCanvas(target: unknown): HTMLCanvasElement {
  const id = typeof target === "string" ? target : DEFAULT_ID;
  const found = isElement(target) ? target : document.getElementById(id);
  const wanted = isElement(target) ? "a canvas, its id or nothing" : `a canvas with the id ${JSON.stringify(id)}`;
  if (found?.localName !== "canvas") {
    const came = found ? kindOf(found) : "none in this document";
    throw new TypeError(`bezierApp: expected ${wanted}, got ${came}`);
  }
  if (!found.parentNode)
    throw new TypeError("bezierApp: expected a canvas that is in a document, got one that is in none");
  return found as HTMLCanvasElement;
}

function isElement(value: unknown): value is Element {
  return typeof value === "object" && value !== null && "nodeType" in value && "localName" in value;
}

function contextOf(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
  try {
    const context = canvas.getContext("2d");
    if (context) return context;
  } catch {
    // handed over to a worker
  }
  throw new TypeError(
    "bezierApp: expected a canvas for 2D pictures, got one that is used otherwise (WebGL or a worker)",
  );
}

/** The canvas's stated size, "670px" as well as "670". */
function boxOf(canvas: HTMLCanvasElement): Box {
  const { width, height } = canvas;
  const stated = canvas.hasAttribute("width") && canvas.hasAttribute("height") && width > 0 && height > 0;
  return stated ? { width, height } : DEFAULT_BOX;
}

export { BezierApp };
