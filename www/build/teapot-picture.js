// The picture of the teapot on the first page, until <bezier-surface> takes its place: drawn with its camera, its light and its
// colours, for light and dark pages.
import { mkdir, writeFile } from "node:fs/promises";
import { boundingSphereOf, HOME, moved, cameraMatricesOf } from "#js/elements/surface/camera.js";
import { isocurves, nets } from "#js/elements/surface/lines.js";
import { image } from "#js/elements/surface/matrix.js";
import { framingPoints, surfaceNamed } from "#js/elements/surface/models.js";
import { settingsOf } from "#js/elements/surface/settings.js";
import { TEAPOT, TEAPOT_VIEW } from "../home/things/teapot-view.js";
import { indexedPng } from "./png.js";

const FOLDER = new URL("../../target/site/", import.meta.url); // home/home.css refers to the pictures
const [WIDTH, HEIGHT] = [664, 480];
/** Samples in each direction of a pixel. */
const SAMPLES = 2;
const SEGMENTS = 16;
/** Lines are so much nearer than they are, relative to their depth, so that they show on the surface. */
const LIFT = 0.0007;
/** Colours differ by at least this in each channel, which keeps the file small. */
const COLOUR_STEP = 6;
const HANDLE_PX = 9;

/** The colours of js/elements/surface/style.ts, and the stage of base.css. */
const THEMES = {
  light: { paper: "#f3f6fa", front: "#b2daf7", back: "#e0a070", line: "#1d3a52", handle: "#d55e00" },
  dark: { paper: "#131a22", front: "#6fb0dc", back: "#b8773f", line: "#d8ebf9", handle: "#e69f00" },
};

/** The light of js/elements/surface/shaders.ts. */
const KEY = [-0.4, 0.62, 0.68];
const FILL = [0.78, -0.1, 0.61];

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** @param {number[]} v */
const unit = (v) => {
  const length = Math.hypot(...v) || 1;
  return v.map((x) => x / length);
};
/** @param {string} hex @returns {number[]} 0 to 255 */
const rgb = (hex) => [1, 3, 5].map((i) => Number.parseInt(hex.slice(i, i + 2), 16));

/**
 * How the light changes the colour of a point: the part of the colour that is left, and the part of white that is added.
 *
 * @param {number[]} normal towards the eye
 * @param {number[]} at in the eye's coordinates
 */
function lightOn(normal, at) {
  const toEye = unit(at.map((x) => -x));
  const light = 0.4 + 0.58 * Math.max(dot(normal, KEY), 0) + 0.16 * Math.max(dot(normal, FILL), 0);
  const half = unit(KEY.map((x, k) => x + toEye[k]));
  const gloss = Math.max(dot(normal, half), 0) ** 48;
  const rim = (1 - Math.max(dot(normal, toEye), 0)) ** 3;
  return [Math.min(light + 0.12 * rim, 1), 0.55 * Math.max(light - 1, 0) + 0.3 * gloss];
}

/** The surface, its lines and the net, in the eye's coordinates and in samples of the picture. */
function scene() {
  const settings = settingsOf(/** @type {any} */ (TEAPOT));
  const surface = surfaceNamed(settings);
  const matrices = cameraMatricesOf(
    moved(HOME, TEAPOT_VIEW),
    boundingSphereOf(framingPoints(settings), settings.up),
    WIDTH,
    HEIGHT,
  );
  /** Where a point appears: x, y, depth. @param {ArrayLike<number>} flat @param {number} i */
  const project = (flat, i) => {
    const [x, y, z, w] = image(matrices.viewProjection, flat, 3 * i);
    return [((x / w + 1) * WIDTH * SAMPLES) / 2, ((1 - y / w) * HEIGHT * SAMPLES) / 2, z / w];
  };
  /** @param {ArrayLike<number>} flat @param {number} i */
  const seen = (flat, i) => image(matrices.view, flat, 3 * i).slice(0, 3);
  /** @param {ArrayLike<number>} flat @param {number} i */
  const turned = (flat, i) => {
    const [x, y, z] = [flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]];
    return [0, 1, 2].map((row) => matrices.view[row] * x + matrices.view[row + 4] * y + matrices.view[row + 8] * z);
  };
  const mesh = surface.grid({ segments: SEGMENTS });
  const vertices = Array.from({ length: mesh.positions.length / 3 }, (_, i) => ({
    place: project(mesh.positions, i),
    at: seen(mesh.positions, i),
    normal: turned(mesh.normals, i),
  }));
  const patch = Number(TEAPOT.patch);
  return {
    vertices,
    indices: mesh.indices,
    curves: isocurves(surface, Number(TEAPOT.lines)),
    net: nets(surface, patch),
    handles: surface.patch(patch).controlPoints(),
    project,
  };
}

/** The visible points of the surface: by pixel the depth, the side and the light. @param {ReturnType<typeof scene>} scene */
function visible({ vertices, indices }) {
  const [width, height] = [WIDTH * SAMPLES, HEIGHT * SAMPLES];
  const depths = new Float32Array(width * height).fill(Infinity);
  const fronts = new Uint8Array(width * height);
  const lights = new Float32Array(2 * width * height);
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [vertices[indices[i]], vertices[indices[i + 1]], vertices[indices[i + 2]]];
    const [[x0, y0, z0], [x1, y1, z1], [x2, y2, z2]] = [a.place, b.place, c.place];
    const area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0);
    if (area === 0) continue;
    const isFront = area < 0; // y points down: counter-clockwise is negative
    const [minX, maxX] = [Math.max(0, Math.ceil(Math.min(x0, x1, x2))), Math.min(width - 1, Math.max(x0, x1, x2))];
    const [minY, maxY] = [Math.max(0, Math.ceil(Math.min(y0, y1, y2))), Math.min(height - 1, Math.max(y0, y1, y2))];
    for (let y = minY; y <= maxY; y++)
      for (let x = minX; x <= maxX; x++) {
        const u = ((x - x0) * (y2 - y0) - (x2 - x0) * (y - y0)) / area;
        const v = ((x1 - x0) * (y - y0) - (x - x0) * (y1 - y0)) / area;
        const depth = z0 + u * (z1 - z0) + v * (z2 - z0);
        const pixel = y * width + x;
        if (u < 0 || v < 0 || u + v > 1 || depth >= depths[pixel]) continue;
        const blend = (/** @type {number[]} */ p, /** @type {number[]} */ q, /** @type {number[]} */ r) =>
          p.map((value, k) => value + u * (q[k] - value) + v * (r[k] - value));
        const normal = unit(blend(a.normal, b.normal, c.normal)).map((value) => (isFront ? value : -value));
        depths[pixel] = depth;
        fronts[pixel] = Number(isFront);
        lights.set(lightOn(normal, blend(a.at, b.at, c.at)), 2 * pixel);
      }
  }
  return { depths, fronts, lights };
}

/**
 * @param {ReturnType<typeof scene>} scene
 * @param {ReturnType<typeof visible>} surface
 * @param {(typeof THEMES)["light"]} theme
 */
function drawn({ curves, net, handles, project }, { depths, fronts, lights }, theme) {
  const [width, height] = [WIDTH * SAMPLES, HEIGHT * SAMPLES];
  const [paper, front, back, line, handle] = [theme.paper, theme.front, theme.back, theme.line, theme.handle].map(rgb);
  const colours = new Float32Array(3 * width * height);
  for (let pixel = 0; pixel < depths.length; pixel++) {
    const base = depths[pixel] === Infinity ? paper : fronts[pixel] ? front : back;
    const [left, white] = base === paper ? [1, 0] : lights.subarray(2 * pixel, 2 * pixel + 2);
    for (let k = 0; k < 3; k++) colours[3 * pixel + k] = base[k] * left + (255 - base[k] * left) * white;
  }
  const mix = (/** @type {number} */ pixel, /** @type {number[]} */ colour, opacity = 1) => {
    for (let k = 0; k < 3; k++) colours[3 * pixel + k] += opacity * (colour[k] - colours[3 * pixel + k]);
  };
  /** Points along pieces of lines; each pixel of a line is drawn once. @param {Float32Array} pieces @param {number} radius @param {number[]} colour @param {number} opacity @param {boolean} hidden */
  const drawLines = (pieces, radius, colour, opacity, hidden) => {
    const done = new Set();
    for (let i = 0; i < pieces.length / 3; i += 2) {
      const [from, to] = [project(pieces, i), project(pieces, i + 1)];
      const steps = Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]));
      for (let k = 0; k <= steps; k++) {
        const [x, y, depth] = from.map((value, n) => value + (steps ? k / steps : 0) * (to[n] - value));
        for (let py = Math.ceil(y - radius); py <= y + radius; py++)
          for (let px = Math.ceil(x - radius); px <= x + radius; px++) {
            const pixel = py * width + px;
            if (px < 0 || py < 0 || px >= width || py >= height || done.has(pixel)) continue;
            if ((px - x) ** 2 + (py - y) ** 2 > radius ** 2 || (!hidden && depth - LIFT > depths[pixel])) continue;
            done.add(pixel);
            mix(pixel, colour, opacity);
          }
      }
    }
  };
  drawLines(curves, 0.6 * SAMPLES, line, 0.75, false);
  drawLines(net, 0.45 * SAMPLES, line, 0.4, true);
  for (let i = 0; i < handles.length / 3; i++) {
    const [x, y] = project(handles, i);
    const half = (HANDLE_PX * SAMPLES) / 2;
    for (let py = Math.round(y - half); py < y + half; py++)
      for (let px = Math.round(x - half); px < x + half; px++) mix(py * width + px, handle);
  }
  return colours;
}

/** The mean of the samples of each pixel, in steps. @param {Float32Array} colours @returns {Uint8Array} RGB */
function averaged(colours) {
  const pixels = new Uint8Array(3 * WIDTH * HEIGHT);
  for (let y = 0; y < HEIGHT; y++)
    for (let x = 0; x < WIDTH; x++)
      for (let k = 0; k < 3; k++) {
        let sum = 0;
        for (let j = 0; j < SAMPLES; j++)
          for (let i = 0; i < SAMPLES; i++)
            sum += colours[3 * ((y * SAMPLES + j) * WIDTH * SAMPLES + x * SAMPLES + i) + k];
        pixels[3 * (y * WIDTH + x) + k] = sum / SAMPLES ** 2;
      }
  return pixels;
}

/** Writes teapot-light.png and teapot-dark.png. */
export async function drawTeapot() {
  await mkdir(FOLDER, { recursive: true });
  const all = scene();
  const surface = visible(all);
  for (const [name, theme] of Object.entries(THEMES)) {
    const png = indexedPng(averaged(drawn(all, surface, theme)), WIDTH, HEIGHT, {
      step: COLOUR_STEP,
      exact: rgb(theme.paper),
    });
    await writeFile(new URL(`teapot-${name}.png`, FOLDER), png);
  }
}
