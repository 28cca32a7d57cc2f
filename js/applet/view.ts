// The frame around the canvas: a host element with a shadow root, in which the canvas is slotted.
import { element } from "../ui/dom.js";
import { adoptStyle } from "./style.js";
import { instructions, title } from "./words.js";
import type { Box } from "../editor/plane.js";

export interface View {
  /** Stands where the canvas stood */
  host: HTMLElement;
  /** The picture with its handles */
  stage: HTMLElement;
  /** Lies exactly over the canvas; holds the handles */
  overlay: HTMLElement;
  /** The picture in words, for screen readers */
  description: HTMLElement;
  /** The short form of what holds at P3 */
  verdict: HTMLElement;
  /** The long form */
  label: HTMLElement;
  /** Where changes are announced */
  live: HTMLElement;
  /** From which colours are read */
  probe: HTMLElement;
  /** Empty at first */
  controls: HTMLElement;
  /** Puts the page back as it was */
  unwrap: () => void;
}

/** The host carries this attribute, so that pages can style it. */
const HOST_ATTRIBUTE = "data-bezier-applet";

/** Wraps the canvas. */
export function createView(canvas: HTMLCanvasElement, box: Box): View {
  const page = canvas.ownerDocument;
  const parts = createParts(page);
  const host = element(page, "div", { [HOST_ATTRIBUTE]: "" });
  host.style.setProperty("inline-size", `${box.width}px`);
  host.style.setProperty("--bz-box", `${box.width} / ${box.height}`);
  host.style.margin = margins(canvas);
  const root = host.attachShadow({ mode: "open" });
  adoptStyle(root);
  root.append(parts.frame);
  const unwrap = wrap(canvas, host);
  return { host, ...parts, unwrap };
}

function createParts(page: Document) {
  const make = element.bind(null, page);
  const overlay = make("div", { className: "overlay", part: "overlay" });
  const description = make("p", { className: "away", id: "description" });
  const verdict = make("span", { className: "verdict", part: "verdict" });
  const label = make("span", {});
  const live = make("p", { className: "away", role: "status" });
  const probe = make("span", { className: "probe", hidden: true });
  const controls = make("div", { className: "controls", part: "controls" });
  const stage = make(
    "div",
    { className: "stage", part: "stage", role: "figure", "aria-label": title(), "aria-describedby": "description" },
    make("p", { className: "away" }, instructions()),
    description,
    make("slot"),
    overlay,
  );
  const status = make("p", { className: "status", part: "status" }, verdict, label);
  const frame = make("div", { className: "frame", part: "frame" }, stage, status, controls, live, probe);
  return { frame, stage, overlay, description, verdict, label, live, probe, controls };
}

/** The canvas's own margins, which the host takes over; a block with equal ones at its sides is taken to be centred. */
function margins(canvas: HTMLCanvasElement): string {
  const { display, marginTop, marginRight, marginBottom, marginLeft } = getComputedStyle(canvas);
  const centred = display === "block" && marginLeft === marginRight && marginLeft !== "0px";
  return centred ? `${marginTop} auto ${marginBottom}` : `${marginTop} ${marginRight} ${marginBottom} ${marginLeft}`;
}

/** Puts the host in the canvas's place and the canvas into the host; returns what undoes it. */
function wrap(canvas: HTMLCanvasElement, host: HTMLElement): () => void {
  const changed = ["width", "height", "aria-hidden"].map((name) => ({ name, value: canvas.getAttribute(name) }));
  canvas.replaceWith(host);
  canvas.setAttribute("aria-hidden", "true"); // else its fallback text is read, though the picture is there
  host.append(canvas);
  return () => {
    for (const { name, value } of changed) {
      if (value === null) canvas.removeAttribute(name);
      else canvas.setAttribute(name, value);
    }
    host.replaceWith(canvas);
  };
}
