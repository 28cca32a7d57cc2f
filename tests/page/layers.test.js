// The layers of <bezier-applet> as pixels: each where it belongs, in its colour, light, dark and forced.
import assert from "node:assert/strict";
import { test } from "node:test";
import { openApplet, set } from "./bezier-applet-page.js";
import { countPixels } from "./pixels.js";

const LIGHT = {
  curve: [0, 114, 178],
  handle: [213, 94, 0],
  level1: [0, 138, 100],
  level2: [184, 85, 143],
  paper: [243, 246, 250],
};
const DARK = {
  curve: [86, 180, 233],
  handle: [230, 159, 0],
  level1: [47, 196, 143],
  level2: [217, 138, 184],
  paper: [19, 26, 34],
};

/** How many pixels around a place of the box are nearly of a colour, however thinly. */
const count = (page, colour, at = [335, 240], reach = 1000) =>
  countPixels(page.locator("bezier-applet canvas"), { colour, at, reach, alpha: 70 });

const POINTS = 'points="100,380 180,80 420,80 560,380"';

test("each layer puts its colour where it belongs", async (t) => {
  const page = await openApplet(t, `${POINTS} show="" labels="none"`);
  // the curve's point at ½ is (307.5, 155): half-way between its ends and handles weighed 1, 3, 3, 1
  /** @type {[string, any, [number, number], number?][]} */
  const places = [
    ["construction", LIGHT.level1, [140, 230]], // half-way from P0 to P1
    ["construction", LIGHT.level2, [220, 155]], // half-way between the two points of the first level
    ["normals", LIGHT.level1, [307, 200]], // down from the point at t
    ["extrema", LIGHT.level1, [307, 155], 30],
    ["offset", LIGHT.level1, [307, 185]], // 30 px along the normal, which is down where x grows
    ["comb", LIGHT.level2, [307, 125], 20], // to the outer side, up here
    ["halves", LIGHT.handle, [444, 220], 20], // the second half
    ["segments", LIGHT.handle, [307, 155], 12],
    ["envelope", LIGHT.level1, [240, 155]], // the string at ½
    ["extrapolation", LIGHT.curve, [104, 400], 30], // goes on below P0
  ];
  for (const [show, colour, place, radius = 8] of places) {
    await set(page, { show: "" });
    const before = await count(page, colour, place, radius);
    await set(page, { show });
    const after = await count(page, colour, place, radius);
    assert.ok(after > before + 2, `${show} at ${place}: ${before} pixels of it without, ${after} with`);
  }
});

test("weights grow with t: the disc on P3 is small at the start and large at the end", async (t) => {
  const page = await openApplet(t, `${POINTS} show="weights" labels="none" t="0.1"`);
  const rim = () => count(page, LIGHT.curve, [560, 380], 45);
  const small = await rim();
  await set(page, { t: "0.95" });
  assert.ok((await rim()) > small + 60, `${small} pixels, then ${await rim()}`);
});

test("dark: the same roles in the dark colours", async (t) => {
  const page = await openApplet(t, `${POINTS} show="construction comb"`, { colorScheme: "dark" });
  for (const role of ["curve", "handle", "level1", "level2"]) assert.ok((await count(page, DARK[role])) > 30, role);
  assert.equal(await count(page, LIGHT.curve), 0);
});

test("forced colours: the picture takes the user's", async (t) => {
  const page = await openApplet(t, `${POINTS} show="construction hull"`, {
    forcedColors: "active",
    colorScheme: "dark",
  });
  assert.equal(await count(page, LIGHT.curve), 0);
  assert.equal(await count(page, DARK.curve), 0);
  assert.ok((await count(page, [255, 255, 255])) > 500, "the curve is in the colour of text");
});

test("the exported SVG shows what the canvas shows", async (t) => {
  const page = await openApplet(t, `${POINTS} show="polygon construction weights tree comb"`);
  const differing = await page.evaluate(async () => {
    const element = document.querySelector("bezier-applet");
    const picture = new Image();
    picture.src = `data:image/svg+xml,${encodeURIComponent(await element.toSVG())}`;
    await picture.decode();
    const pixels = (draw) => {
      const canvas = Object.assign(document.createElement("canvas"), { width: 670, height: 480 });
      const context = /** @type {any} */ (canvas.getContext("2d", { willReadFrequently: true }));
      context.fillStyle = "#fff";
      context.fillRect(0, 0, 670, 480);
      draw(context);
      return context.getImageData(0, 0, 670, 480).data;
    };
    const own = element.shadowRoot.querySelector("canvas");
    const [a, b] = [
      pixels((context) => context.drawImage(own, 0, 0, 670, 480)),
      pixels((context) => context.drawImage(picture, 0, 0, 670, 480)),
    ];
    const apart = (i, k) => Math.abs(a[i] - b[k]) + Math.abs(a[i + 1] - b[k + 1]) + Math.abs(a[i + 2] - b[k + 2]);
    const around = [-1, 0, 1].flatMap((dy) => [-1, 0, 1].map((dx) => 4 * (670 * dy + dx))); // edges may fall on the next pixel
    let [differing, drawn] = [0, 0];
    for (let i = 0; i < a.length; i += 4) {
      if (a[i] + a[i + 1] + a[i + 2] > 600) continue;
      drawn++;
      if (around.every((step) => !(apart(i, i + step) < 200))) differing++;
    }
    return differing / drawn;
  });
  assert.ok(differing < 0.01, `${(100 * differing).toFixed(2)} % of what is drawn is not there`);
});
