// <bezier-applet> with companions, and the easing editor as a field of a form.
import assert from "node:assert/strict";
import { assertNear, joint } from "../page/applet-page.js";
import { inEach } from "./page.js";

const page = (body) => `<!doctype html><html lang="en"><meta charset="utf-8"><title>Elements</title>
<body style="margin: 8px"><main><h1>Elements</h1>${body}</main><script type="module" src="dist/elements.js"></script></body></html>`;

const points = (session) => session.evaluate(() => document.querySelector("bezier-applet").points);

/** Waits until the applet has its handles. */
const ready = async (session) => {
  await session.waitFor(
    () => document.querySelector("bezier-applet")?.shadowRoot?.querySelectorAll("[part=handle]").length > 0,
  );
  await session.frame();
};

/** The middle of something in an element's shadow root. */
const middle = (session, host, selector) =>
  session.evaluate(
    (host, selector) => {
      const part = document.querySelector(host).shadowRoot.querySelector(selector);
      part.scrollIntoView({ block: "nearest" });
      const { x, y, width, height } = part.getBoundingClientRect();
      return [x + width / 2, y + height / 2];
    },
    host,
    selector,
  );
const handle = (index) => `[part="handle"][data-index="${index}"]`;

async function drag(session, index, dx, dy) {
  const [x, y] = await middle(session, "bezier-applet", handle(index));
  await session.drag([x, y], [x + dx / 2, y + dy], [x + dx, y + dy]);
  await session.frame();
}

const focus = (session, index) =>
  session.evaluate(
    (selector) => document.querySelector("bezier-applet").shadowRoot.querySelector(`${selector} input`).focus(),
    handle(index),
  );

/** How many CSS pixels a unit of the box is wide. */
const scale = (session) =>
  session.evaluate(() => document.querySelector("bezier-applet").shadowRoot.querySelector("canvas").clientWidth / 670);

/** The curvature of each side of P3, by the second derivatives. */
function curvatures([, p1, p2, p3, p4, p5]) {
  const minus = (a, b) => [a[0] - b[0], a[1] - b[1]];
  const cross = (a, b) => a[0] * b[1] - a[1] * b[0];
  const [a, b] = [minus(p3, p2), minus(p4, p3)];
  const bent = (along, to) => ((2 / 3) * cross(along, to)) / Math.hypot(...along) ** 3;
  return [bent(a, minus(a, minus(p2, p1))), bent(b, minus(minus(p5, p4), b))];
}

/** Both sides bend the same way: else there are places where curvatures cannot agree. */
const ARCH = "70,330 110,150 230,90 335,90 440,90 560,150 600,330";

/** What each mode promises of the points about P3. */
const HELD = {
  g1: (all) => assertAligned(all),
  c1: (all) => {
    assertAligned(all);
    assertNear([joint(all).before], [joint(all).after], 1e-6);
  },
  g2: (all) => {
    assertAligned(all);
    assertNear([curvatures(all)[0]], [curvatures(all)[1]], 1e-6);
  },
  c2: (all) => {
    HELD.c1(all);
    const [, p1, p2, p3, p4, p5] = all;
    assertNear(
      [0, 1].map((k) => p3[k] - 2 * p2[k] + p1[k]),
      [0, 1].map((k) => p5[k] - 2 * p4[k] + p3[k]),
      1e-6,
      "second derivatives",
    );
  },
};

function assertAligned(all) {
  const { sine, cosine } = joint(all);
  assert.ok(Math.abs(sine) < 1e-9 && cosine > 0, `aligned: ${sine}`);
}

inEach((test) => {
  test(
    "<bezier-applet>: a point follows the pointer; one undo step, and the events tell",
    page('<bezier-applet controls joints="free"></bezier-applet>'),
    async (session) => {
      await ready(session);
      await session.evaluate(() => {
        window.heard = []; // Firefox runs this in a world of its own
        for (const type of ["input", "change"])
          document.addEventListener(type, (event) => window.heard.push(event.type));
      });
      const [before, unit] = [await points(session), await scale(session)];
      await drag(session, 1, 60, 40);
      const after = await points(session);
      assertNear(after[1], [before[1][0] + 60 / unit, before[1][1] + 40 / unit], 2);
      assert.deepEqual(after.with(1, before[1]), before);
      const heard = await session.evaluate(() => window.heard);
      assert.ok(heard.includes("input") && heard.filter((type) => type === "change").length === 1, heard.join(" "));
      await session.evaluate(() => document.querySelector("bezier-applet").undo());
      assert.deepEqual(await points(session), before);
    },
  );

  test(
    "<bezier-applet>: arrows, m and r while the focus is inside",
    page("<bezier-applet controls></bezier-applet>"),
    async (session) => {
      await ready(session);
      const before = await points(session);
      await focus(session, 1);
      await session.press("ArrowRight", "ArrowRight", "ArrowDown", "Shift+ArrowUp", "Alt+ArrowRight");
      assertNear((await points(session))[1], [before[1][0] + 2.1, before[1][1] - 9], 1e-9);
      await session.press("m");
      await session.waitFor(
        () => document.querySelector("bezier-applet").shadowRoot.querySelectorAll("[part=handle]").length === 4,
      );
      assert.equal((await points(session)).length, 7);
      await session.press("m", "r");
      const random = await points(session);
      assert.equal(random.filter(([x, y], i) => x !== before[i][0] && y !== before[i][1]).length, 7);
      await session.press("Control+z");
      assertNear((await points(session))[1], [before[1][0] + 2.1, before[1][1] - 9], 1e-9);
    },
  );

  for (const mode of Object.keys(HELD)) {
    test(
      `<bezier-applet>: ${mode} is held while P2, P3 and P4 are dragged`,
      page(`<bezier-applet controls points="${ARCH}" joints="${mode}"></bezier-applet>`),
      async (session) => {
        await ready(session);
        for (const [index, dx, dy] of [
          [2, 24, -6],
          [3, 20, -8],
          [4, -30, 6],
        ]) {
          await drag(session, index, dx, dy);
          HELD[mode](await points(session));
        }
      },
    );
  }

  test(
    "the weights' plot follows the applet and moves its t",
    page('<bezier-applet id="a" t="0.25"></bezier-applet><bezier-bernstein for="a"></bezier-bernstein>'),
    async (session) => {
      await ready(session);
      await session.waitFor(
        () =>
          Number(document.querySelector("bezier-bernstein").shadowRoot?.querySelector('input[type="range"]')?.value) ===
          0.25,
      );
      await session.evaluate(() =>
        document.querySelector("bezier-bernstein").shadowRoot.querySelector('input[type="range"]').focus(),
      );
      await session.press("ArrowRight");
      await session.waitFor(() => Math.abs(document.querySelector("bezier-applet").t - 0.26) < 1e-9);
    },
  );

  test(
    "<bezier-easing> is a field of its form: dragged, by keys, reset",
    page('<form><bezier-easing name="way" value="linear"></bezier-easing></form>'),
    async (session) => {
      await session.waitFor(() => document.querySelector("bezier-easing").shadowRoot?.querySelector("[part=handle]"));
      await session.frame();
      const field = () => session.evaluate(() => new FormData(document.querySelector("form")).get("way"));
      const first = await field();
      assert.match(first, /^(linear|cubic-bezier\(0, 0, 1, 1\))$/);
      const [x, y] = await middle(session, "bezier-easing", handle(0));
      await session.drag([x, y], [x + 20, y - 30], [x + 60, y - 40]);
      await session.frame();
      const [x1, y1, x2, y2] = (await field()).match(/-?[\d.]+/g).map(Number);
      assert.ok(x1 > 0.05 && y1 > 0.05 && x2 === 1 && y2 === 1, `${[x1, y1, x2, y2]}`);
      await session.evaluate(
        (selector) => document.querySelector("bezier-easing").shadowRoot.querySelector(`${selector} input`).focus(),
        handle(0),
      );
      await session.press("ArrowUp");
      await session.frame();
      assertNear([Number((await field()).match(/-?[\d.]+/g)[1])], [y1 + 0.01], 1e-9);
      await session.evaluate(() => document.querySelector("form").reset());
      assert.equal(await field(), first);
    },
  );
});
