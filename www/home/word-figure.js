// The figure at the top: de Casteljau's algorithm writes the word, and the reader can stop it, move the pen and bend the line.
import { append, arrowStep, find, onDrag, pointIn, REDUCED_MOTION, setAttributes } from "./picture.js";
import {
  CURVES,
  KNOTS,
  letterAt,
  ORIGINAL,
  parameterAfter,
  parameterOf,
  polyline,
  round,
  timeOf,
  trailBetween,
  WORD,
  Word,
} from "./word.js";

const WRITE_SECONDS = 5;
const LOOP_SECONDS = 16;
/** After the pointer has left the line, the pen waits before it goes on by itself. */
const WAIT_MS = 1200;
const KEY_WAIT_MS = 4 * WAIT_MS;
/** The pen follows a pointer that is so near to the line. */
const HOVER_PX = 60;
const TRAIL_LINES = 132;
const TRAIL_MS = 1800;
const TRAIL_OPACITY = 0.55;
/** Marks keep their size on small screens, up to this factor: larger ones would cover the letters. */
const MAX_UNIT = 2.4;
/** A jump of the pen leaves no lines. */
const MAX_TRAIL = 2;
const MAX_FRAME_MS = 250;
const SPRING = { stiffness: 120, damping: 11 };
const PAUSE_ICON = '<path d="M8 5v14M16 5v14"/>';
const PLAY_ICON = '<path d="M8 5l11 7-11 7z" fill="currentColor"/>';

const figure = find("#word");
/** @type {SVGSVGElement} */
const svg = find("svg", figure);
/** @type {HTMLButtonElement} */
const playButton = find("#word-play");
/** @type {HTMLInputElement} */
const slider = find("#word-position");
/** @type {HTMLButtonElement} */
const pointsButton = find("#word-points");
/** @type {HTMLButtonElement} */
const resetButton = find("#word-reset");
const code = find("#word-code");
const hint = find("#word-hint");
const grip = find(".grip", svg);
const pen = find(".pen", svg);
const polygons = [".polygon", ".first", ".second"].map((name) => find(name, svg));
const trailGroup = find(".trail", svg);
/** @type {Element[]} */
const ghosts = [...svg.querySelectorAll(".ghost path")];

for (const poster of svg.querySelectorAll(".poster")) poster.remove();
const inks = ghosts.map(() => append(find(".ink", svg), "path", { pathLength: 1 }));
const trail = Array.from({ length: TRAIL_LINES }, () => ({
  line: append(trailGroup, "line", { "stroke-opacity": 0 }),
  born: -Infinity,
}));
const circles = [4, 3, 2].flatMap((count, level) =>
  Array.from({ length: count }, () => append(find(".rounds", svg), "circle", { class: `round-${level}` })),
);

// State

let word = WORD;
/** The parameter of the pen. */
let t = 0;
/** The word is written up to this parameter. */
let written = 0;
/** The word before each change, to undo it. @type {Word[]} */
const history = [];
let isRunning = false;
let isVisible = false;
let isHeld = false;
/** The pen stands until this time. */
let waitUntil = 0;
/** Moves the word back to its first shape. @type {((now: number) => void) | undefined} */
let spring;

// Drawing

/** The size of a CSS pixel in the picture's units. */
let unit = 1;
/** The word that is drawn. @type {Word | undefined} */
let drawnWord;
let trailEnd = 0;
let oldest = 0;

function drawWord() {
  drawnWord = word;
  const data = word.splines.map((spline) => spline.toSVG({ precision: 1 }));
  for (const [i, d] of data.entries()) for (const path of [ghosts[i], inks[i]]) path.setAttribute("d", d);
  grip.setAttribute("d", data.join(""));
  drawPoints();
}

function drawInk() {
  for (const [stroke, path] of inks.entries()) {
    const part = written >= CURVES ? 1 : word.partBefore(stroke, written);
    path.style.display = part > 0 ? "" : "none";
    if (part < 1) path.setAttribute("stroke-dasharray", `${part.toFixed(4)} 2`);
    else path.removeAttribute("stroke-dasharray");
  }
}

function drawConstruction(/** @type {number} */ now) {
  const levels = word.construction(t);
  let circle = 0;
  for (const [level, flat] of levels.slice(0, 3).entries()) {
    polygons[level].setAttribute("d", polyline(flat));
    for (let i = 0; i < flat.length; i += 2, circle++)
      setAttributes(circles[circle], {
        cx: round(flat[i]),
        cy: round(flat[i + 1]),
        r: round((level ? 4.4 : 5) * unit),
      });
  }
  const [x, y] = levels[3];
  pen.setAttribute("transform", `translate(${round(x)} ${round(y)}) scale(${unit.toFixed(3)})`);
  if (Math.abs(t - trailEnd) <= MAX_TRAIL) leaveTrail(trailEnd, now);
  trailEnd = t;
  const curve = Math.floor(t);
  code.textContent = `segments()[${curve}].deCasteljau(${(t - curve).toFixed(2)})`;
  slider.value = String(t);
  slider.setAttribute("aria-valuetext", `letter ${letterAt(t)}, t = ${(t - curve).toFixed(2)}`);
}

/** @param {number} from @param {number} now */
function leaveTrail(from, now) {
  for (const { tangent, line } of trailBetween(word, from, t)) {
    const place = trail[oldest++ % TRAIL_LINES];
    place.born = now;
    const [x1, y1, x2, y2] = line.map(round);
    setAttributes(place.line, { class: tangent ? "tangent" : "side", x1, y1, x2, y2 });
  }
}

/** With reduced motion the lines of the trail stay. @param {number} now */
function drawTrail(now) {
  for (const { line, born } of trail) {
    const age = REDUCED_MOTION.matches && born > -Infinity ? 0.3 : Math.min(1, (now - born) / TRAIL_MS);
    line.setAttribute("stroke-opacity", (TRAIL_OPACITY * (1 - age)).toFixed(3));
  }
}

function draw(now = performance.now()) {
  if (drawnWord !== word) drawWord();
  drawInk();
  drawConstruction(now);
  drawTrail(now);
}

new ResizeObserver(() => {
  const scale = svg.getScreenCTM()?.a;
  if (!scale) return;
  unit = Math.min(MAX_UNIT, 1 / scale);
  drawnWord = undefined;
  draw();
}).observe(svg);

// Time: first the word is written, then the pen goes round. It stands while the figure is not visible or the line is held.

let frame = 0;
let before = 0;

function requestDraw() {
  if (frame) return;
  if (!isRunning) before = performance.now();
  frame = requestAnimationFrame(step);
}

/** @param {number} now */
function step(now) {
  frame = 0;
  const seconds = Math.min(Math.max(now - before, 0), MAX_FRAME_MS) / 1000;
  before = now;
  if (isRunning) advance(seconds, now);
  spring?.(now);
  draw(now);
  const fades = !REDUCED_MOTION.matches && trail.some(({ born }) => now - born < TRAIL_MS);
  if (isVisible && (isRunning || spring || fades)) requestDraw();
}

/** @param {number} seconds @param {number} now */
function advance(seconds, now) {
  const writes = written < CURVES;
  if (writes) {
    const part = timeOf(written) + seconds / WRITE_SECONDS;
    written = part >= 1 ? CURVES : parameterAfter(part);
  }
  if (isHeld || now < waitUntil) return;
  t = writes
    ? parameterAfter(timeOf(Math.min(written, CURVES - 1e-6)))
    : parameterAfter((timeOf(t) + seconds / LOOP_SECONDS) % 1);
}

new IntersectionObserver((entries) => {
  isVisible = entries.at(-1)?.isIntersecting ?? false;
  before = performance.now();
  if (isVisible) requestDraw();
}).observe(svg);

/** @param {boolean} running */
function setRunning(running) {
  isRunning = running;
  waitUntil = 0;
  playButton.setAttribute("aria-label", running ? "Pause" : "Play");
  find("svg", playButton).innerHTML = running ? PAUSE_ICON : PLAY_ICON;
  requestDraw();
}

playButton.addEventListener("click", () => setRunning(!isRunning));
slider.addEventListener("input", () => {
  setRunning(false);
  written = CURVES;
  t = Math.min(Number(slider.value), CURVES - 1e-6);
});

// The pointer: near the line the pen follows it, and a drag bends the line.

/** @param {Word} changed */
function setWord(changed) {
  word = changed;
  resetButton.disabled = false;
  requestDraw();
}

svg.addEventListener("pointermove", (event) => {
  if (isHeld || event.pointerType === "touch") return;
  const nearest = word.nearest(pointIn(svg, event));
  if (nearest.distance > HOVER_PX * unit) return;
  t = nearest.t;
  waitUntil = performance.now() + WAIT_MS;
  requestDraw();
});

/** @type {{ word: Word, point: [number, number], start: [number, number] } | undefined} */
let bend;
onDrag(svg, grip, {
  start(point) {
    const nearest = word.nearest(point);
    bend = { word, point: nearest.point, start: point };
    remember();
    spring = undefined;
    isHeld = true;
    t = nearest.t;
    hint.textContent = "";
    figure.classList.add("bending");
  },
  move([x, y]) {
    if (bend) setWord(bend.word.bend(bend.point, [x - bend.start[0], y - bend.start[1]]));
  },
  end(cancelled) {
    if (cancelled) undo();
    bend = undefined;
    isHeld = false;
    waitUntil = performance.now() + WAIT_MS;
    figure.classList.remove("bending");
    requestDraw();
  },
});

const remember = () => history.push(word);

function undo() {
  const previous = history.pop();
  if (previous) setWord(previous);
}

figure.addEventListener("keydown", (/** @type {KeyboardEvent} */ event) => {
  if (!(event.ctrlKey || event.metaKey) || event.key !== "z" || history.length === 0) return;
  event.preventDefault();
  undo();
});

resetButton.addEventListener("click", async () => {
  // A disabled button would lose the focus, and the keyboard its place.
  if (document.activeElement === resetButton) playButton.focus();
  resetButton.disabled = true;
  history.length = 0;
  const finish = () => {
    setWord(WORD);
    resetButton.disabled = true;
    spring = undefined;
  };
  if (REDUCED_MOTION.matches) return finish();
  const { easing } = await import("casteljau/easing");
  const ease = easing.spring(SPRING);
  const from = word.points;
  const start = performance.now();
  spring = (now) => {
    const time = Math.max(0, now - start) / ease.duration;
    if (time >= 1) return finish();
    const part = ease(time);
    word = Word.of(
      from.map((stroke, i) =>
        stroke.map(([x, y], k) => [x + part * (ORIGINAL[i][k][0] - x), y + part * (ORIGINAL[i][k][1] - y)]),
      ),
    );
  };
  requestDraw();
});

// Control points: one stop of the Tab key; Page Up and Page Down choose a point, the arrow keys move it.

const pointGroup = find(".points", svg);
let selected = 0;
/** The marks of the control points. @type {{ mark: SVGElement, stroke: number, index: number }[]} */
let marks = [];

function drawPoints() {
  if (marks.length === 0) return;
  const points = word.points;
  const levers = points.flatMap((stroke) =>
    stroke.flatMap(([x, y], k) =>
      k % 3 ? [`M${stroke[k % 3 === 1 ? k - 1 : k + 1].map(round).join(" ")}L${round(x)} ${round(y)}`] : [],
    ),
  );
  find(".levers", pointGroup).setAttribute("d", levers.join(""));
  for (const { mark, stroke, index } of marks) {
    const [x, y] = points[stroke][index].map(round);
    const r = (index % 3 ? 3 : 5) * unit;
    if (index % 3) setAttributes(mark, { x: x - r, y: y - r, width: 2 * r, height: 2 * r });
    else {
      const number = KNOTS.findIndex(([i, k]) => i === stroke && k === index) + 1;
      setAttributes(mark, {
        cx: x,
        cy: y,
        r,
        "aria-label": `Point ${number} of ${KNOTS.length}, ${Math.round(x)}, ${Math.round(y)}`,
      });
    }
  }
}

function showPoints() {
  append(pointGroup, "path", { class: "levers" });
  const handles = ORIGINAL.flatMap((points, stroke) =>
    points.flatMap((_, index) => (index % 3 ? [{ mark: append(pointGroup, "rect"), stroke, index }] : [])),
  );
  const knots = KNOTS.map(([stroke, index], n) => {
    const attributes = { tabindex: n === selected ? 0 : -1, role: "button", "aria-roledescription": "draggable point" };
    const mark = append(pointGroup, "circle", attributes);
    mark.addEventListener("keydown", (event) => onKey(event, n));
    return { mark, stroke, index };
  });
  marks = [...handles, ...knots];
  for (const { mark, stroke, index } of marks)
    onDrag(svg, mark, {
      start() {
        mark.focus();
        remember();
        isHeld = true;
      },
      move: (point) => setWord(word.movePoint(stroke, index, point)),
      end(cancelled) {
        isHeld = false;
        if (cancelled) undo();
      },
    });
  drawPoints();
}

/** @param {KeyboardEvent} event @param {number} n of the point */
function onKey(event, n) {
  const step = arrowStep(event);
  const next = { PageDown: n + 1, PageUp: n - 1, Home: 0, End: KNOTS.length - 1 }[event.key];
  if (!step && next === undefined) return;
  event.preventDefault();
  if (step) {
    const [stroke, index] = KNOTS[n];
    const [x, y] = word.points[stroke][index];
    remember();
    setWord(word.movePoint(stroke, index, [x + step[0], y + step[1]]));
  } else if (next !== undefined) select((next + KNOTS.length) % KNOTS.length);
}

/** @param {number} n of the point */
function select(n) {
  selected = n;
  const knots = marks.slice(-KNOTS.length);
  for (const [i, { mark }] of knots.entries()) mark.setAttribute("tabindex", String(i === n ? 0 : -1));
  knots[n].mark.focus();
  t = parameterOf(...KNOTS[n]);
  waitUntil = performance.now() + KEY_WAIT_MS;
  requestDraw();
}

pointsButton.addEventListener("click", () => {
  const show = marks.length === 0;
  pointsButton.setAttribute("aria-pressed", String(show));
  hint.textContent = show ? "Arrow keys move a point; Page Up and Page Down select one." : "";
  if (show) return showPoints();
  pointGroup.replaceChildren();
  marks = [];
});

// The start: with reduced motion the word is written, and the pen stands where the build has drawn it.

slider.max = String(CURVES);
for (const control of [playButton, slider, pointsButton]) control.disabled = false;
if (REDUCED_MOTION.matches) {
  const [from, to] = figure.dataset.still.split(" ").map(Number);
  written = CURVES;
  trailEnd = from;
  t = to;
}
setRunning(!REDUCED_MOTION.matches);
