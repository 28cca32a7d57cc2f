// <bezier-surface>: what it draws. tests/js/element-surface.test.js has the numbers below the picture.
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

test("the read-out counts; without parts nothing is drawn; y up looks like z up, the original height does not", async (t) => {
  const page = await openSurface(t, 'segments="5"');
  const first = await look(page);
  const { triangles, vertices } = await facts(page);
  assert.deepEqual([triangles, vertices], [32 * 2 * 25, 32 * 36]);
  await set(page, { parts: "" });
  assert.deepEqual([(await facts(page)).triangles, (await look(page)).inked], [0, 0]);
  await set(page, { parts: null, up: "y" });
  assert.ok((await difference(page, first, await look(page))) < FEW * first.width * first.height);
  await set(page, { up: "z", height: "original" });
  assert.ok((await difference(page, first, await look(page))) > 5000);
});

test("pixels follow the view", async (t) => {
  const page = await openSurface(t, 'pixels="1"');
  const far = await facts(page);
  assert.match(far.text, /error ≤ 1 px/);
  await set(page, { view: { zoom: 0.5 } });
  const small = await facts(page);
  assert.ok(far.triangles > 1.6 * small.triangles, `${small.triangles} → ${far.triangles}`);
});

test("cracks of the recursion and tubes are drawn and counted", async (t) => {
  const page = await openSurface(t, 'flatness="0.05"');
  assert.match((await facts(page)).text, /\d\d\d\s+pieces, \d\s+deep\s+[\d,]+\s+cracks, up to/);
  const cracked = await look(page);
  assert.ok(cracked.loud > 100, `${cracked.loud} pixels`);
  await set(page, { flatness: null, tolerance: 0.05 });
  assert.equal((await look(page)).loud, 0);
  await set(page, { tolerance: null, show: "tubes", lines: 2 });
  const few = await look(page);
  assert.ok(few.inked > 3000, `${few.inked} pixels`);
  await set(page, { lines: 5 });
  assert.ok((await look(page)).inked > 1.3 * few.inked);
});
