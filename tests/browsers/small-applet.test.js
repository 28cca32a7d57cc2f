// The applet of the tutorial's two lines, by mouse and keys.
import assert from "node:assert/strict";
import { assertNear, joint, tutorialPage } from "../page/applet-page.js";
import { inEach } from "./page.js";

const points = (session) => session.evaluate(() => bezierApp().points);
const app = (session, name) => session.evaluate((name) => bezierApp()[name], name);

/** Where a handle's centre is in the window. */
const centre = (session, index) =>
  session.evaluate((index) => {
    const root = document.querySelector("canvas").parentNode.shadowRoot;
    const box = root.querySelector(`[part="handle"][data-index="${index}"]`).getBoundingClientRect();
    return [box.x + box.width / 2, box.y + box.height / 2];
  }, index);

async function drag(session, index, dx, dy) {
  const [x, y] = await centre(session, index);
  await session.drag([x, y], [x + dx / 2, y], [x + dx, y + dy]);
  await session.frame();
}

/** Where something with such words in its label can be clicked, once it is there. */
async function label(session, words) {
  await session.waitFor((words) => {
    const root = document.querySelector("canvas").parentNode.shadowRoot;
    return [...root.querySelectorAll("label, button")].some((each) => each.textContent.trim().startsWith(words));
  }, words);
  return session.evaluate((words) => {
    const root = document.querySelector("canvas").parentNode.shadowRoot;
    const found = [...root.querySelectorAll("label, button")].find((each) => each.textContent.trim().startsWith(words));
    found.scrollIntoView({ block: "nearest" });
    const box = found.getBoundingClientRect();
    return [box.x + box.width / 2, box.y + box.height / 2];
  }, words);
}
const click = async (session, words) => {
  await session.drag(await label(session, words));
  await session.frame();
};

inEach((test) => {
  test("a point follows the pointer, the others stay", tutorialPage(), async (session) => {
    const before = await points(session);
    await drag(session, 1, 60, 40);
    const after = await points(session);
    assertNear(after[1], [before[1][0] + 60, before[1][1] + 40], 1);
    assert.deepEqual(after.with(1, before[1]), before);
  });

  test("Tab and arrow keys move a point", tutorialPage(), async (session) => {
    const before = await points(session);
    await session.evaluate(() =>
      document.querySelector("canvas").parentNode.shadowRoot.querySelector('[aria-label="P4 x"]').focus(),
    );
    await session.press("ArrowRight", "ArrowRight", "ArrowDown", "Shift+ArrowUp", "Alt+ArrowRight");
    await session.frame();
    assertNear((await points(session))[4], [before[4][0] + 2.1, before[4][1] - 9], 1e-9);
    await session.press("Tab", "Tab");
    const focused = await session.evaluate(() =>
      /** @type {any} */ (document.activeElement).shadowRoot.activeElement.getAttribute("aria-label"),
    );
    assert.equal(focused, "P6 x");
  });

  test(
    "m hides and brings back three points, r randomizes them; the buttons do, too",
    tutorialPage(),
    async (session) => {
      const before = await points(session);
      await session.press("m");
      assert.equal(await app(session, "visiblePoints"), 4);
      await session.press("m");
      assert.deepEqual([await app(session, "visiblePoints"), await points(session)], [7, before]);
      await session.press("r");
      const random = await points(session);
      assert.equal(random.filter(([x, y], i) => x !== before[i][0] && y !== before[i][1]).length, 7);
      await click(session, "Show 4 points");
      assert.equal(await app(session, "visiblePoints"), 4);
    },
  );

  test("a smooth joint is held while its points are dragged", tutorialPage(), async (session) => {
    await click(session, "C1");
    assert.equal(await app(session, "joint"), "c1");
    for (const [index, dx, dy] of [
      [2, 30, -60],
      [3, 40, 20],
      [4, -50, 30],
    ]) {
      await drag(session, index, dx, dy);
      const { sine, cosine, before, after } = joint(await points(session));
      assert.ok(Math.abs(sine) < 1e-9 && cosine > 0);
      assertNear([before], [after], 1e-9);
    }
    assert.match(
      await session.evaluate(
        () => document.querySelector("canvas").parentNode.shadowRoot.querySelector('[part="status"]').textContent,
      ),
      /C1/,
    );
  });
});
