// <bezier-surface>: drawn, turned by the mouse and by keys.
import assert from "node:assert/strict";
import { surfacePage } from "../page/surface-page.js";
import { inEach } from "./page.js";

const ready = (session) =>
  session.waitFor(() =>
    /triangles/.test(document.querySelector("bezier-surface")?.shadowRoot?.querySelector(".facts")?.textContent ?? ""),
  );

/** How many pixels of the picture are drawn on, in how many colours, and a number that tells pictures apart. */
const look = (session) =>
  session.evaluate(async () => {
    const element = document.querySelector("bezier-surface");
    await element.updateComplete;
    const bitmap = await createImageBitmap(await element.toBlob());
    const context = /** @type {any} */ (
      Object.assign(document.createElement("canvas"), {
        width: bitmap.width,
        height: bitmap.height,
      }).getContext("2d")
    );
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
    const colours = new Set();
    let [inked, hash] = [0, 0];
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 3] < 128) continue;
      inked++;
      const colour = (data[i] << 16) | (data[i + 1] << 8) | data[i + 2];
      colours.add(colour);
      hash = (Math.imul(hash, 31) + colour + i) | 0;
    }
    return { inked, colours: colours.size, hash };
  });

const element = (session, name) => session.evaluate((name) => document.querySelector("bezier-surface")[name], name);

inEach((test) => {
  test("the teapot is drawn, shaded, in WebGL2", surfacePage("controls"), async (session) => {
    await ready(session);
    const message = await session.evaluate(() =>
      document.querySelector("bezier-surface").shadowRoot.querySelector(".message").textContent.trim(),
    );
    assert.equal(message, "");
    const { inked, colours } = await look(session);
    assert.ok(inked > 30_000 && colours > 100, `${inked} pixels in ${colours} colours`);
  });

  test("mouse and keys turn it", surfacePage('model="patch"'), async (session) => {
    await ready(session);
    const first = [await element(session, "view"), await look(session)];
    const [x, y] = await session.evaluate(() => {
      const box = document.querySelector("bezier-surface").shadowRoot.querySelector("canvas").getBoundingClientRect();
      return [box.x + box.width / 2, box.y + box.height / 2];
    });
    await session.drag([x, y], [x + 30, y], [x + 60, y + 10]);
    const second = [await element(session, "view"), await look(session)];
    assert.ok(Math.abs(second[0].turn - first[0].turn - 24) < 0.5, `turned by ${second[0].turn - first[0].turn}`); // 0.4° a pixel
    assert.notEqual(second[1].hash, first[1].hash);
    await session.evaluate(() => document.querySelector("bezier-surface").shadowRoot.querySelector("canvas").focus());
    await session.press("ArrowRight", "+");
    const third = await element(session, "view");
    assert.ok(Math.abs(third.turn - second[0].turn - 5) < 1e-9 && third.zoom > 1);
  });

  test("a control point follows its handle", surfacePage('model="patch" show="surface net"'), async (session) => {
    await ready(session);
    await session.frame();
    const [x, y] = await session.evaluate(() => {
      const box = document
        .querySelector("bezier-surface")
        .shadowRoot.querySelectorAll(".handle")[5]
        .getBoundingClientRect();
      return [box.x + box.width / 2, box.y + box.height / 2];
    });
    const vertex = () =>
      session.evaluate(() => [...document.querySelector("bezier-surface").surface.vertices.slice(15, 18)]);
    const before = await vertex();
    await session.drag([x, y], [x + 10, y - 20], [x + 20, y - 40]);
    const after = await vertex();
    assert.ok(Math.hypot(...after.map((value, k) => value - before[k])) > 0.1);
  });

  test(
    "what draws is asked for again where it could not be fetched",
    surfacePage('model="patch" hidden'),
    async (session, pages) => {
      const part = "/dist/elements-surface.js";
      pages.set(part, "no script");
      await session.evaluate(() => {
        document.querySelector("bezier-surface").hidden = false;
      });
      await session.waitFor(() =>
        /could not be loaded/.test(document.querySelector("bezier-surface").shadowRoot?.textContent ?? ""),
      );
      pages.delete(part);
      await session.evaluate(() => document.querySelector("main").append(document.querySelector("bezier-surface")));
      await ready(session);
      assert.ok((await look(session)).inked > 3000);
      await session.evaluate(() => void window.problems.splice(0)); // the refusal is told in the console
    },
  );
});
