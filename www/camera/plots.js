// Two plots along the path: ways in equal times, and how frames turn about it.
import { html, svg } from "lit";
import { guard } from "lit/directives/guard.js";
import { decimal } from "../figures/lib/numbers.js";
import { equalSteps, framesOf, minimising, roll } from "./path.js";

/** @typedef {import("./camera-path.js").CameraPath} CameraPath */

const ROLL_STEPS = 240;

/** Ways in equal times, at both speeds: marks along the straightened path. @param {CameraPath} camera */
export function strip(camera) {
  const [left, right] = [74, 16];
  const x = (/** @type {number} */ s) => left + (s / camera.length) * (camera.wide - left - right);
  const lengths = (/** @type {boolean} */ even) =>
    Array.from(equalSteps(camera.path, camera.steps, even), (t) => lengthUpTo(camera.path, t));
  const row = (/** @type {boolean} */ even, /** @type {number} */ y, /** @type {string} */ words) => svg`
    <text class="end ${even === camera.state.even ? "strong" : "quiet"}" x=${left - 10} y=${y + 4}>${words}</text>
    <path class="axis" d="M${left} ${y}H${camera.wide - right}" />
    ${lengths(even).map((s) => svg`<circle class="tick" data-even=${even} data-s=${s} cx=${x(s)} cy=${y} r="3" fill="var(--paper)" stroke=${even === camera.state.even ? "var(--handle)" : "var(--quiet)"} stroke-width="1.5" />`)}`;
  const s = camera.state.even ? camera.progress * camera.length : lengthUpTo(camera.path, camera.here.t);
  return html`
    <svg viewBox="0 0 ${camera.wide} 74" role="img" aria-label="The path straightened, with marks at ${camera.steps} equal times: evenly spaced at even speed, crowded and sparse at raw speed">
      ${guard([camera.state, camera.wide], () => [row(true, 22, "even"), row(false, 54, "raw t")])}
      <path class="at" d="M${x(s)} ${(camera.state.even ? 22 : 54) - 9}l7 9l-7 9l-7 -9Z" />
    </svg>
  `;
}

/** The way behind the camera. @param {import("casteljau").Spline} path @param {number} t */
function lengthUpTo(path, t) {
  const segments = path.segments();
  const k = Math.min(Math.floor(t), segments.length - 1);
  const before = segments.slice(0, k).reduce((sum, segment) => sum + segment.length(), 0);
  return before + (t > k ? segments[k].subsegment(0, t - k).length() : 0);
}

/** How frames turn about the path, against rotation-minimising ones; the time does not matter. @param {CameraPath} camera */
export const rolls = (camera) => guard([camera.state, camera.wide], () => rollPlot(camera));

/** @param {CameraPath} camera */
function rollPlot(camera) {
  const ts = camera.path.equidistantTimes(ROLL_STEPS);
  const carried = minimising(camera.path, ts);
  const kinds = /** @type {const} */ ([
    ["minimising", "level1", "", "rotation-minimizing"],
    ["frenet", "handle", "2 4", "Frenet"],
    ["upright", "curve", "8 4", "upright"],
  ]);
  const [left, right, height] = [74, 16, 130];
  const x = (/** @type {number} */ i) => left + (i / ROLL_STEPS) * (camera.wide - left - right);
  const y = (/** @type {number} */ degrees) => 12 + ((180 - degrees) / 360) * (height - 34);
  const lists = kinds.map(([kind]) => framesOf(camera.path, ts, kind).map((frame, i) => roll(frame, carried[i])));
  // A leap from 180° to −180° is none: the line is lifted there.
  const trace = (/** @type {number[]} */ list) =>
    list
      .map(
        (value, i) =>
          `${i === 0 || Math.abs(value - list[i - 1]) > 300 ? "M" : "L"}${x(i).toFixed(1)} ${y(value).toFixed(1)}`,
      )
      .join("");
  const leap = (/** @type {number[]} */ list) =>
    Math.max(...list.slice(1).map((value, i) => Math.abs(((value - list[i] + 540) % 360) - 180)));
  return html`
    <svg viewBox="0 0 ${camera.wide} ${height}" role="img" aria-label="The rotation of the frames about the path, in degrees, along the path">
      ${[-180, 0, 180].map((degrees) => svg`<path class="gridline" d="M${left} ${y(degrees)}H${camera.wide - right}" /><text class="quiet end" x=${left - 10} y=${y(degrees) + 4}>${decimal(degrees, 0)}°</text>`)}
      ${kinds.map(([kind, colour, dash], k) => svg`<path d=${trace(lists[k])} fill="none" stroke="var(--${colour})" stroke-width=${kind === camera.state.frames ? 3 : 1.75} stroke-dasharray=${dash} stroke-linejoin="round" />`)}
      <text class="quiet" x=${left} y=${height - 5}>start</text><text class="quiet end" x=${camera.wide - right} y=${height - 5}>end</text>
    </svg>
    <p class="facts">
      ${kinds.map(([, colour, dash, words]) => html`<span class="key-line" .style=${`border-color: var(--${colour}); border-block-start-style: ${dash ? (dash === "2 4" ? "dotted" : "dashed") : "solid"}`}></span>${words}`)}.
      In one of ${ROLL_STEPS} equal steps the Frenet frame turns by up to <b class="leap">${decimal(leap(lists[1]), 0)}°</b> about the path, the rotation-minimizing frame by ${decimal(leap(lists[0]), 0)}°.
    </p>
  `;
}
