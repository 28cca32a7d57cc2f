import { Curve, Patch, Surface } from "casteljau";

// A vase of 100 mm: four quarters around the z axis for each of the five parts of its profile.
const [HEIGHT, WALL] = [100, 2.5];
const K = 0.5522847498307936; // handles of a cubic quarter of a circle
const QUARTER = [
  [1, 0],
  [1, K],
  [K, 1],
  [0, 1],
];

/** The profile as cubic curves of points [radius, z]: bottom, outside, lip, inside, inner bottom. */
function profile(belly, neck) {
  const line = (...ends) => new Curve(ends).elevate().elevate();
  const side = (offset, bottom) =>
    new Curve([
      [28 - offset, bottom],
      [belly - offset, 35],
      [neck - offset, 75],
      [24 - offset, HEIGHT],
    ]);
  return [
    line([0, 0], [28, 0]),
    side(0, 0),
    line([24, HEIGHT], [24 - WALL, HEIGHT]),
    side(WALL, WALL).reverse(),
    line([28 - WALL, WALL], [0, WALL]),
  ];
}

/** One patch: a profile curve, turned by a quarter and by k quarters before. */
function quarterPatch(curve, k) {
  const numbers = curve.controlPoints();
  const net = [];
  for (let v = 0; v < 4; v++) {
    const [radius, z] = numbers.subarray(2 * v, 2 * v + 2);
    for (const [x, y] of QUARTER) {
      const [cos, sin] = [
        [1, 0],
        [0, 1],
        [-1, 0],
        [0, -1],
      ][k];
      net.push([radius * (x * cos - y * sin), radius * (x * sin + y * cos), z]);
    }
  }
  return new Patch(net);
}

const canvas = document.querySelector("#stl-for-printing-picture");
const form = canvas.nextElementSibling;
const { belly, neck, tolerance } = form.elements;

function vase() {
  const curves = profile(Number(belly.value), Number(neck.value));
  return Surface.fromPatches(curves.flatMap((curve) => [0, 1, 2, 3].map((k) => quarterPatch(curve, k))));
}

const stl = (surface) => surface.tessellate({ tolerance: Number(tolerance.value), weld: "position" }).toSTL();

function draw() {
  const surface = vase();
  const context = canvas.getContext("2d");
  canvas.width = canvas.clientWidth * devicePixelRatio;
  canvas.height = canvas.clientHeight * devicePixelRatio;
  const { width, height } = canvas;
  const scale = height / 140;
  const tilt = 0.35;
  const [up, depth] = [-scale * Math.cos(tilt), -scale * Math.sin(tilt)];
  context.strokeStyle = getComputedStyle(canvas).color;
  context.lineWidth = devicePixelRatio;
  context.beginPath();
  // Columns: where the x, y and z axes and the origin go on the canvas.
  surface.trace(context, {
    matrix: [scale, 0, 0, 0, 0, depth, 0, 0, 0, up, 0, 0, width / 2, 0.86 * height, 0, 1],
    lines: 4,
  });
  context.stroke();
  const bytes = stl(surface).length;
  const material = surface.volume() / 1000;
  form.nextElementSibling.textContent = `${material.toFixed(1)} cm³ of material, ${Math.round(bytes / 1000)} kB`;
}

form.querySelector("button").addEventListener("click", () => {
  const href = URL.createObjectURL(new Blob([stl(vase())], { type: "model/stl" }));
  Object.assign(document.createElement("a"), { href, download: "vase.stl" }).click();
  URL.revokeObjectURL(href);
});
form.addEventListener("input", draw);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
new ResizeObserver(draw).observe(canvas);
