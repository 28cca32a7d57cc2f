// <bezier-applet>: joints that are held and told, snapping, cutting and healing, bases and degrees.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  ask,
  button,
  centre,
  drag,
  focus,
  message,
  openApplet,
  points,
  press,
  pull,
  set,
  settled,
} from "./bezier-applet-page.js";

const near = (got, expected, slack, name) =>
  expected
    .flat()
    .forEach((x, i) =>
      assert.ok(
        Math.abs(got.flat()[i] - x) <= slack,
        `${name ?? ""} ${JSON.stringify(got)}, not ${JSON.stringify(expected)}`,
      ),
    );
const continuity = (page) => ask(page, () => a.figure.continuity);
const row = (page, k = 0) => page.locator("bezier-applet .joints li").nth(k);
const THREE = 'points="60,300 100,100 200,100 250,250 300,380 380,400 430,240 470,100 560,120 610,300"';

/** Equal curvatures on both sides need points that turn one way. */
const ROUND = 'points="60,300 60,150 150,60 300,60 450,60 540,150 540,300 540,420 430,440 300,440"';

test("what is held at the joints stays while points are dragged, and the label says what is true", async (t) => {
  const page = await openApplet(t, `controls joints="g2" ${ROUND}`);
  for (const [index, dx, dy] of [
    [2, 30, 20],
    [4, -20, 35],
    [3, 25, 25],
  ]) {
    await pull(page, index, dx, dy);
    for (const { g2 } of await continuity(page)) assert.ok(g2, `P${index}`);
    await page.mouse.up();
  }
  assert.match(await row(page, 0).innerText(), /^(C2|.*G2)/);
});

test("each joint has its own mode: by its control, by Enter on its point", async (t) => {
  const page = await openApplet(t, `controls ${THREE}`);
  await page.getByLabel("At P6 hold").selectOption("c1");
  await settled(page);
  assert.deepEqual(await ask(page, () => a.joints), ["free", "c1"]);
  assert.deepEqual(
    (await continuity(page)).map(({ c1 }) => c1),
    [false, true],
  );
  await focus(page, 3);
  await press(page, "Enter");
  assert.deepEqual(await ask(page, () => a.joints), ["g1", "c1"]);
  await press(page, "Enter", 5);
  assert.deepEqual(await ask(page, () => a.joints), ["free", "c1"]);
  await drag(page, 4, 20, 70);
  assert.equal((await continuity(page))[0].g1, false, "free again");
  assert.equal((await continuity(page))[1].c1, true);
  assert.match(await ask(page, () => a.getAttribute("joints")), /^free c1$/);
  await focus(page, 4);
  await press(page, "Enter");
  assert.deepEqual(await ask(page, () => a.joints), ["free", "c1"], "a handle has no mode");
});

test("the label tells the angle and the ratio of what is not held", async (t) => {
  const page = await openApplet(t, 'controls points="0,200 50,200 100,200 200,200 200,300 350,300 400,400"');
  assert.match(await row(page).innerText(), /C0\s+At P3 hold[\s\S]*turns by 90°, tangents 1 : 1$/);
  await set(page, {
    points: [
      [0, 200],
      [50, 200],
      [100, 200],
      [200, 200],
      [250, 200],
      [350, 300],
      [400, 400],
    ],
  });
  assert.match(await row(page).innerText(), /G1[\s\S]*tangents 1 : 0.5$/);
});

test("near a smooth joint a point clicks into place; with Ctrl it does not", async (t) => {
  const page = await openApplet(t, 'points="60,300 100,100 200,150 300,240 400,300 500,400 600,300"');
  // the mirror image of P2 is (400, 330)
  await drag(page, 4, 2, 27);
  assert.deepEqual((await points(page))[4], [400, 330]);
  assert.ok((await continuity(page))[0].c1);
  await drag(page, 4, 40, 39);
  near((await points(page))[4], [441.9, 367.7], 2, "on the line through P2 and P3");
  assert.deepEqual(
    (await continuity(page)).map(({ g1, c1 }) => [g1, c1]),
    [[true, false]],
  );
  await ask(page, () => a.undo());
  await settled(page);
  await page.keyboard.down("Control");
  await drag(page, 4, 2, 2);
  await page.keyboard.up("Control");
  assert.deepEqual((await points(page))[4], [402, 332]);
  assert.equal((await continuity(page))[0].g1, false);
});

test("Shift turns a handle about its anchor in steps of 15°", async (t) => {
  const page = await openApplet(t);
  const anchor = (await points(page))[0];
  await page.keyboard.down("Shift");
  await drag(page, 1, 83, 41);
  await page.keyboard.up("Shift");
  const [x, y] = (await points(page))[1];
  const angle = (Math.atan2(y - anchor[1], x - anchor[0]) * 180) / Math.PI;
  assert.ok(Math.abs(angle / 15 - Math.round(angle / 15)) < 1e-4, `${angle}°`);
});

test("Alt breaks the joint for good", async (t) => {
  const page = await openApplet(t, `joints="c1" ${THREE}`);
  const before = await points(page);
  await page.keyboard.down("Alt");
  await drag(page, 4, 40, -50);
  await page.keyboard.up("Alt");
  assert.deepEqual((await points(page))[2], before[2]);
  assert.deepEqual(await ask(page, () => a.joints), ["free", "c1"]);
  await ask(page, () => a.undo());
  assert.deepEqual(await ask(page, () => [a.joints, a.points]), [["c1", "c1"], before], "one step");
});

test("i cuts the segment of the point at t and leaves the curve; Delete heals it", async (t) => {
  const page = await openApplet(t, 't="0.3"');
  const before = await points(page);
  const samples = () =>
    ask(page, () =>
      [0.1, 0.4, 0.9].map(
        (t) => a.figure.spline.nearest(a.figure.spline.eval(t * a.figure.spline.segmentCount)).distance,
      ),
    );
  const whole = await ask(page, () => a.figure.spline.length());
  await focus(page, 5);
  await press(page, "i");
  const cut = await points(page);
  assert.equal(cut.length, 10);
  assert.deepEqual(cut.slice(0, 4), before.slice(0, 4), "the first is not touched");
  assert.ok(Math.abs((await ask(page, () => a.figure.spline.length())) - whole) < 1e-8);
  assert.ok((await samples()).every((distance) => distance < 1e-9));
  assert.deepEqual(await ask(page, () => a.joints), ["free", "g1"]);
  await focus(page, 6);
  await press(page, "Delete");
  near(await points(page), before, 1e-9, "healed");
  assert.deepEqual(await ask(page, () => a.joints), ["free"]);
  assert.equal(await ask(page, () => a.shadowRoot.activeElement.getAttribute("aria-label")), "P6 x");
  await press(page, "Control+z", 2);
  assert.deepEqual(await points(page), before);
});

test("Delete takes an end with its segment, lays a handle on the chord; with Shift it takes the point alone", async (t) => {
  const page = await openApplet(t, THREE);
  const before = await points(page);
  await focus(page, 9);
  await press(page, "Delete");
  assert.deepEqual(await points(page), before.slice(0, 7));
  await focus(page, 1);
  await press(page, "Delete");
  near((await points(page))[1], [60 + 190 / 3, 300 - 50 / 3], 1e-9);
  await press(page, "Shift+Delete");
  const bare = await points(page);
  assert.equal(bare.length, 6);
  assert.deepEqual(bare[1], before[2]);
  assert.deepEqual(await ask(page, () => a.figure.kinds), ["on", "off", "off", "on", "wait", "wait"]);
});

test("what cannot be removed or cut says so", async (t) => {
  const page = await openApplet(t, 'points="0,0 100,100 200,0 300,300"');
  await focus(page, 0);
  await press(page, "Delete");
  assert.match(await message(page), /only segment/);
  await set(page, { basis: "b-spline" });
  await focus(page, 0);
  await press(page, "i");
  assert.match(await message(page), /insert: expected the basis bezier or hermite/);
  assert.equal((await points(page)).length, 4);
});

test("split shows the halves and returns them", async (t) => {
  const page = await openApplet(t);
  const halves = await ask(page, () => a.split(0.25).map((half) => [...half.controlPoints()]));
  assert.deepEqual(halves[0].slice(0, 2), [70, 330]);
  assert.deepEqual(halves[0].slice(-2), halves[1].slice(0, 2));
  assert.deepEqual(await ask(page, () => [a.t, a.show]), [0.25, "polygon halves"]);
});

const FLAT = [
  [100, 300],
  [150, 100],
  [300, 100],
  [350, 300],
  [450, 420],
  [550, 300],
];

test("in every basis a point is dragged, and undone it is back", async (t) => {
  const page = await openApplet(t, `controls points="${FLAT.map((point) => point.join(",")).join(" ")}"`);
  for (const basis of ["hermite", "b-spline", "catmull-rom", "natural", "centripetal", "matrix"]) {
    await set(page, { basis });
    await drag(page, 2, 20, -20);
    near((await points(page))[2], [320, 80], 0.01, basis);
    await ask(page, () => a.undo());
    assert.deepEqual(await points(page), FLAT);
  }
});

test("a matrix of one's own begins with the basis before, and can be edited", async (t) => {
  const page = await openApplet(t, "controls");
  await page.getByRole("combobox", { name: "Basis" }).selectOption("b-spline");
  await page.getByRole("combobox", { name: "Basis" }).selectOption("matrix");
  await settled(page);
  near(await ask(page, () => a.state.matrix), [-1 / 6, 0.5, -0.5, 1 / 6], 1e-12);
  await page.getByLabel("row 4, column 1").fill("1");
  await page.getByLabel("row 4, column 1").press("Tab");
  await settled(page);
  assert.equal(await ask(page, () => a.state.matrix[12]), 1);
  await page.getByLabel("row 4, column 1").fill("");
  await page.getByLabel("row 4, column 1").press("Tab");
  assert.match(await message(page), /matrix\[12\]: expected a number/);
  assert.equal(await ask(page, () => a.state.matrix[12]), 1);
});

test("of degree n a point added or removed changes the degree", async (t) => {
  const page = await openApplet(t, 'controls degree="n"');
  await button(page, "Add a point").click();
  assert.deepEqual(await ask(page, () => [a.figure.degree, a.points.length]), [7, 8]);
  await focus(page, 2);
  await press(page, "Delete");
  assert.deepEqual(await ask(page, () => [a.figure.degree, a.points.length]), [6, 7], "the degree falls");
});

test("the hidden points stay where they are, and come back", async (t) => {
  const page = await openApplet(t, 'mode="4"');
  const before = await points(page);
  await drag(page, 1, 20, 20);
  assert.deepEqual((await points(page)).slice(4), before.slice(4));
  await ask(page, () => a.removeAttribute("mode"));
  await settled(page);
  assert.equal(await page.locator('bezier-applet [part="handle"]').count(), 7);
});

test("two fingers move two points", async (t) => {
  const page = await openApplet(t, "", { hasTouch: true });
  const client = await page.context().newCDPSession(page);
  const [[x1, y1], [x2, y2]] = [await centre(page, 1), await centre(page, 5)];
  const touch = (type, ...places) =>
    client.send("Input.dispatchTouchEvent", { type, touchPoints: places.map(([x, y], id) => ({ x, y, id })) });
  const before = await points(page);
  await touch("touchStart", [x1, y1]);
  await touch("touchStart", [x1, y1], [x2, y2]);
  await touch("touchMove", [x1 + 30, y1 + 10], [x2 - 40, y2 - 60]);
  await touch("touchEnd");
  await settled(page);
  const after = await points(page);
  near(after[1], [before[1][0] + 30, before[1][1] + 10], 1);
  near(after[5], [before[5][0] - 40, before[5][1] - 60], 1);
  await ask(page, () => a.undo());
  assert.deepEqual(await points(page), before, "one step");
});
