// <bezier-surface>: what it draws.
import assert from "node:assert/strict";
import { test } from "node:test";
import { assertSamePictures, difference, facts, FEW, look, openSurface, set, SHADINGS } from "./surface-page.js";

test("the teapot is drawn, whole and large, in each shading", async (t) => {
  const page = await openSurface(t);
  const pictures = [];
  for (const shading of SHADINGS) {
    await set(page, { shading });
    const seen = await look(page);
    assert.ok(seen.inked > 0.1 * seen.width * seen.height, `${shading}: ${seen.inked} pixels`);
    assert.ok(seen.left > 0 && seen.right < seen.width - 1, `${shading}: nothing is cut off`);
    assert.ok(seen.right - seen.left > 0.5 * seen.width, `${shading} fills the picture`);
    assert.ok(seen.colours > 100, `${shading}: ${seen.colours} colours`);
    pictures.push(seen);
  }
  for (let i = 1; i < pictures.length; i++) {
    assert.ok(
      (await difference(page, pictures[i - 1], pictures[i], 6)) > 2000,
      `${SHADINGS[i]} differs from ${SHADINGS[i - 1]}`,
    );
  }
});

test("the core and the graphics card draw the same picture", async (t) => {
  const page = await openSurface(t, 'model="patch" segments="9" show="surface mesh net"');
  for (const shading of ["smooth", "gaussian"]) await assertSamePictures(page, shading); // the others: surface.deep.test.js
});

test("at the poles, too: the knob of the lid and the bottom from near by", async (t) => {
  const page = await openSurface(t, 'segments="4" shading="normals"');
  for (const tilt of [88, -88]) {
    await set(page, { evaluation: "cpu", view: { tilt, zoom: 12 } });
    const cpu = await look(page);
    assert.ok(cpu.inked > 0.9 * cpu.width * cpu.height);
    await set(page, { evaluation: "gpu" });
    const count = await difference(page, cpu, await look(page));
    assert.ok(count <= FEW * cpu.width * cpu.height, `tilt ${tilt}: ${count} pixels differ`);
  }
});

test("the read-out counts, and the parts of the teapot come and go", async (t) => {
  const page = await openSurface(t, 'segments="5"');
  const { triangles, vertices } = await facts(page);
  assert.equal(triangles, 32 * 2 * 25);
  assert.equal(vertices, 32 * 36);
  await set(page, { parts: "body lid" });
  assert.equal((await facts(page)).triangles, 16 * 2 * 25);
  await set(page, { parts: "" });
  assert.equal((await facts(page)).triangles, 0);
  assert.equal((await look(page)).inked, 0);
  await set(page, { parts: null, segments: 64 });
  assert.equal((await facts(page)).vertices, 32 * 65 ** 2);
});

test("the original height is 4/3 of the squashed one, and y up looks like z up", async (t) => {
  const page = await openSurface(t);
  const first = await look(page);
  await set(page, { up: "y" });
  assert.ok((await difference(page, first, await look(page))) < FEW * first.width * first.height);
  await set(page, { up: "z", height: "original" });
  const size = await page.evaluate(() => {
    const z = document.querySelector("bezier-surface").surface.vertices.filter((_, i) => i % 3 === 2);
    return Math.max(...z) - Math.min(...z);
  });
  assert.ok(Math.abs(size - 3.15 / 0.75) < 1e-9, String(size));
  assert.ok((await difference(page, first, await look(page))) > 5000);
});

test("a finer tolerance makes more triangles, and pixels follow the view: smaller, or outside of it, is coarser", async (t) => {
  const page = await openSurface(t, 'tolerance="0.05"');
  const coarse = await facts(page);
  assert.match(coarse.text, /error ≤ 0\.05/);
  await set(page, { tolerance: 0.005 });
  const fine = await facts(page);
  assert.ok(fine.triangles > 4 * coarse.triangles, `${coarse.triangles} → ${fine.triangles}`);
  await set(page, { tolerance: null, pixels: 1 });
  const far = await facts(page);
  assert.match(far.text, /error ≤ 1 px/);
  await set(page, { view: { zoom: 0.5 } });
  const small = await facts(page);
  assert.ok(far.triangles > 1.6 * small.triangles, `${small.triangles} → ${far.triangles}`);
  await set(page, { view: { zoom: 8 } });
  const near = await facts(page);
  assert.ok(near.triangles < far.triangles, `${far.triangles} → ${near.triangles}`);
  assert.ok((await look(page)).inked > 5000);
});

test("the recursion of the text leaves cracks, which are shown; a grid has none", async (t) => {
  const page = await openSurface(t, 'flatness="0.05"');
  const { text, triangles } = await facts(page);
  const [, pieces, depth] = text
    .replaceAll(/(?<=\d),(?=\d)/g, "")
    .match(/(\d+)\s+pieces,\s+(\d+)\s+deep/)
    .map(Number);
  assert.equal(triangles, 2 * pieces);
  assert.ok(pieces > 100 && depth >= 2, text);
  const cracks = Number(text.replaceAll(/(?<=\d),(?=\d)/g, "").match(/(\d+)\s+cracks/)[1]);
  assert.ok(cracks > 10, text);
  const cracked = await look(page);
  assert.ok(cracked.loud > 100, `${cracked.loud} pixels`);
  await set(page, { flatness: null, tolerance: 0.05 });
  assert.equal((await look(page)).loud, 0);
  await set(page, { tolerance: null, flatness: 0.05 });
  await page.evaluate(() => {
    const { Surface } = bezier;
    const points = [0, 1, 2, 3].flatMap((y) => [0, 1, 2, 3].map((x) => [x, y, 0]));
    document.querySelector("bezier-surface").surface = new Surface({
      vertices: points,
      patches: [points.map((_, k) => k)],
    });
  });
  await set(page, {});
  assert.match((await facts(page)).text, /1\s+pieces, 0\s+deep\s+0\s+cracks/);
});

test("cracks do not depend on where a patch begins: every other patch of the teapot turned round", async (t) => {
  const page = await openSurface(t, 'flatness="0.05"');
  const before = (await facts(page)).text;
  await page.evaluate(() => {
    const element = document.querySelector("bezier-surface");
    const { vertices, patches } = element.surface;
    element.surface = new bezier.Surface({ vertices, patches: patches.map((net, k) => (k % 2 ? net.reverse() : net)) });
  });
  await set(page, {});
  const counts = (text) => text.match(/[\d,]+\s+(?:pieces|cracks)/g);
  assert.deepEqual(counts((await facts(page)).text), counts(before));
});

test("a surface of another entry point, which has classes of its own", async (t) => {
  const page = await openSurface(t, 'flatness="0.05"');
  await page.evaluate(async () => {
    const { Surface } = await import(new URL("./dist/surfaces.js", location.href).href);
    const points = [0, 1, 2, 3].flatMap((y) => [0, 1, 2, 3].map((x) => [x, y, 0]));
    const element = document.querySelector("bezier-surface");
    element.surface = new Surface({ vertices: points, patches: [points.map((_, k) => k)] });
  });
  await set(page, {});
  assert.match((await facts(page)).text, /1\s+pieces, 0\s+deep\s+0\s+cracks/);
  const refusal = await page.evaluate(() => {
    try {
      document.querySelector("bezier-surface").surface = { casteljauType: "mesh" };
    } catch (error) {
      return String(error);
    }
    return "";
  });
  assert.equal(refusal, "TypeError: surface: expected a Surface or null, got object");
});

test("curves as tubes: bodies without their surface", async (t) => {
  const page = await openSurface(t, 'show="tubes" lines="2"');
  const few = await facts(page);
  const first = await look(page);
  assert.ok(few.triangles > 1000 && first.inked > 3000, `${few.triangles} triangles, ${first.inked} pixels`);
  await set(page, { lines: 5 });
  const [many, second] = [await facts(page), await look(page)];
  assert.ok(many.triangles > 1.8 * few.triangles && second.inked > 1.3 * first.inked);
  await set(page, { show: "" });
  assert.equal((await facts(page)).triangles, 0);
  assert.equal((await look(page)).inked, 0);
});

test("unknown words and impossible numbers count as the defaults", async (t) => {
  const page = await openSurface(t, 'model="kettle" segments="many" shading="shiny" u="-4" tolerance="-1"');
  assert.equal((await facts(page)).triangles, 32 * 2 * 144);
  assert.ok((await look(page)).inked > 5000);
});
