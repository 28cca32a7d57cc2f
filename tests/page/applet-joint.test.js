// The forced joint: P2, P3 and P4 stay aligned while any of the three is dragged.
import assert from "node:assert/strict";
import { test } from "node:test";
import { assertNear, drag, drawn, joint, openTutorial, points, pull } from "./applet-page.js";

const choose = (page, mode) => page.getByLabel(mode, { exact: true }).check();
const status = (page) => page.locator('[part="status"]').innerText();

/** A mode, a point, and by how many pixels it is dragged; tests/js/applet-joints.test.js has all of them. */
const MOVES = [
  ["G1", 2, 30, -70],
  ["C1", 3, 45, 25],
  ["C1", 4, -60, 40],
];

test("the joint is held in the midst and at the end of dragging P2, P3 and P4", async (t) => {
  const page = await openTutorial(t);
  for (const [mode, index, dx, dy] of MOVES) {
    await choose(page, mode);
    const before = await points(page);
    await pull(page, index, dx, dy);
    const whileDragging = await points(page);
    await page.mouse.up();
    for (const held of [whileDragging, await points(page)]) {
      assertNear(held[index], [before[index][0] + dx, before[index][1] + dy], 0.01, `P${index} follows the pointer`);
      const { sine, cosine, before: first, after: second } = joint(held);
      assert.ok(Math.abs(sine) < 1e-9 && cosine > 0, `aligned: ${sine}`);
      if (mode === "C1") assertNear([first], [second], 1e-9, "half-way");
    }
    const after = await points(page);
    for (const far of [0, 1, 5, 6]) assert.deepEqual(after[far], before[far], `P${far} stays`);
    if (index !== 3) assert.deepEqual(after[3], before[3], "P3 stays");
    const truth = await page.evaluate(() => bezierApp().continuity);
    assert.equal(truth[String(mode).toLowerCase()], true, "the core says so too");
    assert.match(await status(page), mode === "C1" ? /C1.*G1 and C1 at P3/s : /G1/);
  }
});

test("G1 keeps the lengths of both tangents", async (t) => {
  const page = await openTutorial(t);
  await choose(page, "G1");
  const before = joint(await points(page));
  await drag(page, 3, 20, 30);
  const anchored = joint(await points(page));
  assertNear([anchored.before, anchored.after], [before.before, before.after], 1e-9);
  await drag(page, 2, 40, 10);
  assertNear([joint(await points(page)).after], [before.after], 1e-9, "the other handle only turns");
});

test("free: each of the three moves alone", async (t) => {
  const page = await openTutorial(t);
  for (const index of [2, 3, 4]) {
    const before = await points(page);
    await drag(page, index, 15, 20);
    const after = await points(page);
    assertNear(after[index], [before[index][0] + 15, before[index][1] + 20], 0.01);
    assert.deepEqual(after.with(index, before[index]), before);
  }
});

test("switching on G1 mends a broken joint, P2 and P3 kept", async (t) => {
  const page = await openTutorial(t);
  await drag(page, 3, 50, -50);
  const broken = await points(page);
  await choose(page, "G1");
  const mended = await points(page);
  assert.deepEqual(mended.with(4, broken[4]), broken, "only P4 has moved");
  assert.ok(Math.abs(joint(mended).sine) < 1e-12);
  assertNear([joint(mended).after], [joint(broken).after], 1e-9, "its distance from P3 is kept");
});

test("r keeps the lock, and all points inside", async (t) => {
  const page = await openTutorial(t);
  for (const mode of ["g1", "c1"]) {
    const runs = await page.evaluate((mode) => {
      const app = bezierApp();
      app.joint = mode;
      return Array.from({ length: 60 }, (_, seed) => {
        app.randomize(seed);
        return app.points;
      });
    }, mode);
    for (const all of runs) {
      assert.ok(Math.abs(joint(all).sine) < 1e-9 && joint(all).cosine > 0);
      if (mode === "c1") assertNear([joint(all).before], [joint(all).after], 1e-9);
      assert.ok(
        all.every(([x, y]) => x >= 0 && x <= 670 && y >= 0 && y <= 480),
        JSON.stringify(all),
      );
    }
  }
});

test("the lock holds at hidden joints and at those added later", async (t) => {
  const page = await openTutorial(t);
  await choose(page, "C1");
  await page.keyboard.press("m");
  await drawn(page);
  await drag(page, 2, -20, 15); // P4 is hidden
  assertNear([joint(await points(page)).sine], [0], 1e-12);
  await page.evaluate(() => {
    bezierApp().toggleMode();
    bezierApp().append([300, 60]);
  });
  await drawn(page);
  for (const act of [() => {}, () => drag(page, 5, -30, 10)]) {
    await act();
    const later = joint((await points(page)).slice(3)); // at P6
    assertNear([later.sine, later.before], [0, later.after], 1e-9);
  }
});

test("a partner pushed out of the picture waits at its edge and can be fetched back", async (t) => {
  const page = await openTutorial(t);
  await page.evaluate(() =>
    Object.assign(bezierApp(), { joint: "c1", points: bezierApp().points.with(3, [600, 230]) }),
  );
  await drawn(page);
  await drag(page, 2, -100, 0);
  const [x] = (await points(page))[4];
  assert.ok(x > 670, `P4 is outside, at ${x}`);
  await drag(page, 4, -40, 20);
  assertNear([(await points(page))[4][0]], [630], 1);
});
