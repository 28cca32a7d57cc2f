// A drawing surface: a stroke takes the place of the picture.
import { find, pointIn, whenWanted } from "../picture.js";

const OPTIONS = { size: 11, thinning: 0.7, streamline: 0.35, taper: { start: 10, end: 24 } };

const box = find('[data-thing="ink"]');
/** @type {SVGSVGElement} */
const svg = find("svg", box);
const path = find("path", svg);
const load = () => import("casteljau");

whenWanted(svg, load);
svg.addEventListener("pointerdown", async (event) => {
  if (event.button !== 0) return;
  event.preventDefault();
  svg.setPointerCapture(event.pointerId);
  /** Samples that wait for the package. @type {[number, number, { time: number, pressure: number }][]} */
  const samples = [];
  const take = (/** @type {PointerEvent} */ moved) => {
    for (const each of moved.getCoalescedEvents?.() ?? [moved])
      samples.push([...pointIn(svg, each), { time: each.timeStamp, pressure: each.pressure }]);
  };
  samples.push([...pointIn(svg, event), { time: event.timeStamp, pressure: event.pressure }]);
  let isDrawing = true;
  const drag = new AbortController();
  svg.addEventListener("pointermove", take, { signal: drag.signal });
  svg.addEventListener(
    "lostpointercapture",
    () => {
      isDrawing = false;
      drag.abort();
    },
    { signal: drag.signal },
  );
  const { InkStroke } = await load();
  const stroke = new InkStroke({ ...OPTIONS, pressure: event.pointerType === "pen" ? "device" : "simulated" });
  const draw = () => {
    for (const [x, y, sample] of samples.splice(0)) stroke.append(x, y, sample);
    path.setAttribute("d", stroke.outline().toSVG({ precision: 1 }));
    if (isDrawing || samples.length > 0) requestAnimationFrame(draw);
  };
  draw();
});
