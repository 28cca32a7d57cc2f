import { Spline } from "casteljau";

const POSITIONS = 400; // at equal distances along the path
const [RINGS, RING_STEP, CORNERS, RADIUS] = [40, 2, 8, 0.8];
const FOCAL_LENGTH = 160;

const path = Spline.interpolate([
  [0, 0, 0],
  [6, 3, 1],
  [10, -2, 3],
  [16, 0, 0],
  [20, 6, -3],
  [27, 4, 1],
  [32, -2, 0],
]);
const { points, tangents, normals, binormals } = path.frames(path.equidistantTimes(POSITIONS), { normal: [0, 0, 1] });
const vector = (list, i) => list.subarray(3 * i, 3 * i + 3);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** The corners of a regular polygon around the path, in the frame at a position. */
const ring = (i) =>
  Array.from({ length: CORNERS }, (_, k) => {
    const [cos, sin] = [Math.cos, Math.sin].map((f) => RADIUS * f((2 * Math.PI * (k + 0.5)) / CORNERS));
    return vector(points, i).map((x, axis) => x + cos * vector(binormals, i)[axis] + sin * vector(normals, i)[axis]);
  });

/** A point as the camera sees it that looks along the tangent; the normal is up. */
function project(point, camera) {
  const offset = point.map((x, axis) => x - vector(points, camera)[axis]);
  const scale = FOCAL_LENGTH / Math.max(dot(offset, vector(tangents, camera)), 0.05);
  return [dot(offset, vector(binormals, camera)) * scale, -dot(offset, vector(normals, camera)) * scale];
}

const svg = document.querySelector("#camera-flight-picture");
const form = svg.nextElementSibling;
const [slider, button] = form.elements;

function draw() {
  const camera = Number(slider.value);
  const rings = Array.from({ length: RINGS }, (_, k) => camera + RING_STEP * (k + 1)).filter((i) => i <= POSITIONS);
  const polygons = rings.map(
    (i) =>
      `M${ring(i)
        .map((corner) => project(corner, camera).map((x) => x.toFixed(1)))
        .join("L")}Z`,
  );
  svg.firstElementChild.setAttribute("d", polygons.join(""));
  form.nextElementSibling.textContent = `${((camera / POSITIONS) * path.length()).toFixed(1)} of ${path.length().toFixed(1)} units`;
}

let playing = false;
function step() {
  if (!playing) return;
  slider.value = slider.value === slider.max ? 0 : Number(slider.value) + 1;
  draw();
  requestAnimationFrame(step);
}

button.addEventListener("click", () => {
  playing = !playing;
  button.textContent = playing ? "Pause" : "Play";
  step();
});
slider.addEventListener("input", draw);
draw();
