import "casteljau/elements/surface";
import { NurbsCurve, NurbsSurface } from "casteljau/nurbs";
import { draggablePoints } from "./draggable.js";

const [AXIS, GROUND, WALL] = [150, 200, 6]; // in the units of the drawing, which are mm
const DEGREE = 2;

/** A NURBS curve from the axis along the outside, over the lip, and inside back to the axis. */
function profileOf(points, weight) {
  const outside = points.map(([x, y]) => [Math.max(x - AXIS, 2 * WALL), GROUND - y]);
  const inside = outside.map(([radius, height]) => [radius - WALL, height]).reverse();
  const [foot, ground] = outside[0];
  inside[3][1] += WALL;
  const net = [[0, ground], [foot / 2, ground], ...outside, ...inside, [0, ground + WALL]];
  const weights = [1, 1, 1, weight, 1, 1, 1, 1, weight, 1, 1];
  const spans = net.length - DEGREE;
  const knots = Array.from({ length: net.length + DEGREE + 1 }, (_, i) => Math.min(Math.max(i - DEGREE, 0), spans));
  return new NurbsCurve({ degree: DEGREE, points: net, weights, knots });
}

const svg = document.querySelector("#vase-profile");
const element = document.querySelector("#vase-surface");
const form = svg.nextElementSibling;
const output = form.nextElementSibling;

function draw() {
  const profile = profileOf(points(), Number(form.elements.weight.value));
  const halves = [1, -1].map((side) => profile.transform([side, 0, 0, -1, AXIS, GROUND]).toSVG({ precision: 1 }));
  svg.querySelector(".area").setAttribute("d", halves.join(""));

  // The element shows the surface, and saves its mesh as OBJ, STL or GLB.
  const surface = NurbsSurface.revolve(profile, { axis: [0, 1, 0] }).toSurface();
  element.surface = surface;

  const [volume, area] = [surface.volume() / 1000, surface.area() / 100];
  output.textContent = `${surface.patchCount} patches, ${volume.toFixed(0)} cm³ of clay, ${area.toFixed(0)} cm² to glaze`;
}

const points = draggablePoints(svg, draw);
form.addEventListener("input", draw);
draw();
