// <bezier-applet>: what it is given, good and bad: attributes, properties, drops; what it gives: files and code; zoom.
import assert from "node:assert/strict";
import { test } from "node:test";
import { ask, button, centre, drag, ink, message, openApplet, points, settled } from "./bezier-applet-page.js";
import { boxOf } from "./browser.js";

const near = (got, expected, slack, name) =>
  expected
    .flat()
    .forEach((x, i) =>
      assert.ok(
        Math.abs(got.flat()[i] - x) <= slack,
        `${name ?? ""} ${JSON.stringify(got)}, not ${JSON.stringify(expected)}`,
      ),
    );

/** For each attribute a text that cannot be used; tests/js/applet-joints.test.js has more of them. */
const UNUSABLE = {
  points: "1,2 3,NaN",
  mode: "99",
  joints: "g1 x",
  basis: "__proto__",
  degree: "2.5",
  matrix: "1 2 3",
  t: "",
  show: "hasOwnProperty",
  labels: "Q",
  tolerance: "-3",
  segments: "1e9",
  offset: "x",
  ticks: "0",
  view: "0 0 1e-400 1",
  segment: "-1",
};

test("any string in attributes: what cannot be used is told, the last good one stays, undo works", async (t) => {
  const page = await openApplet(t, 'points="10,20 30,200 300,40 400,300" t="0.25" show="hull"');
  const good = await ask(page, () => JSON.stringify(a.state));
  const told = await page.evaluate(
    async ([unusable, good]) => {
      const told = [];
      for (const [name, text] of Object.entries(unusable)) {
        a.setAttribute(name, text);
        await a.updateComplete;
        told.push([name, a.shadowRoot.querySelector(".message").textContent, JSON.stringify(a.state)]);
        a.removeAttribute(name);
        a.state = JSON.parse(good);
        await a.updateComplete;
      }
      return told;
    },
    [UNUSABLE, good],
  );
  for (const [name, message, state] of told) {
    assert.match(message.trim(), new RegExp(`^${name}|of ${name}|${name}\\[`), name);
    assert.equal(state, good, name);
  }
  for (const name of ["theme", "hotkeys", "controls", "label", "readonly"])
    await ask(page, `a.setAttribute(${JSON.stringify(name)}, "<b>&'x")`);
  await settled(page);
  await ask(page, () => a.removeAttribute("readonly"));
  assert.equal(await message(page), "");
  await drag(page, 1, 20, 20);
  await ask(page, () => a.undo());
  assert.deepEqual(await points(page), [
    [10, 20],
    [30, 200],
    [300, 40],
    [400, 300],
  ]);
});

test("a megabyte in an attribute, or in a drop, is refused and shown short", async (t) => {
  const page = await openApplet(t, "controls");
  for (const text of ['"x".repeat(2 ** 20)', '"1,2 ".repeat(2 ** 18)']) {
    await ask(page, `a.setAttribute("points", ${text}), a.updateComplete.then(() => 0)`);
    const words = await message(page);
    assert.ok(/^points: expected/.test(words) && words.length < 200, words);
    assert.equal((await points(page)).length, 7);
  }
  await drop(page, "M0 0 ".repeat(2 ** 19));
  assert.match(await message(page), /no figure/);
  assert.equal((await points(page)).length, 7);
});

test("properties refuse with the right errors, and nothing changes", async (t) => {
  const page = await openApplet(t);
  const before = await ask(page, () => JSON.stringify(a));
  const refused = await ask(page, () =>
    [
      () => (a.points = 3),
      () => (a.points = [[1, 2]]),
      () =>
        (a.points = [
          [1, NaN],
          [2, 3],
        ]),
      () => (a.points = [[1, 2], "x"]),
      () => (a.t = [0.5]),
      () => (a.t = 7),
      () => (a.t = NaN),
      () => (a.joints = 1),
      () => (a.joints = ["x"]),
      () => (a.state = null),
      () =>
        (a.state = {
          points: [
            [0, 0],
            [1, 1],
          ],
          basis: "x",
        }),
      () => (a.state = { points: 1 }),
      () => a.insert(2),
      () => a.insert("x"),
      () => a.remove(99),
      () => a.remove(1.5),
      () => a.append([1]),
      () => a.append([NaN, 1]),
      () => a.randomize(0.5),
      () => a.split(3),
      () => a.steer({ index: 99, point: [1, 1] }),
      () => a.steer({ t: 9 }),
    ].map((act) => {
      try {
        act();
        return "nothing";
      } catch (/** @type {any} */ error) {
        return `${error.name}: ${error.message}`;
      }
    }),
  );
  for (const words of refused) assert.match(words, /^(TypeError|RangeError): .*expected .*got /);
  assert.equal(refused.filter((words) => words.startsWith("TypeError")).length, 8, refused.join("\n"));
  assert.equal(await ask(page, () => JSON.stringify(a)), before);
});

/** Drops a text, as another window would give it. */
async function drop(page, text) {
  await page.evaluate((text) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.setData("text/plain", text);
    a.shadowRoot
      .querySelector(".overlay")
      .dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, composed: true, cancelable: true }));
  }, text);
  await settled(page);
}

test("dropped and pasted: points, an SVG path, a file, JSON; what is none of these is told", async (t) => {
  const page = await openApplet(t, "controls");
  await drop(page, "10,20 30,40 50,60 70,80");
  assert.deepEqual(await points(page), [
    [10, 20],
    [30, 40],
    [50, 60],
    [70, 80],
  ]);
  await drop(page, '<svg viewBox="0 0 9 9"><path stroke="red" d="M10 10Q60 10 60 60L10 60Z"/></svg>');
  const path = await points(page);
  assert.equal(path.length, 10);
  assert.deepEqual(
    [path[0], path[3], path[6], path[9]],
    [
      [10, 10],
      [60, 60],
      [10, 60],
      [10, 10],
    ],
  );
  await drop(page, "M0 0 L2000 0");
  assert.ok(
    (await points(page)).every(([x, y]) => x >= 0 && x <= 670 && y >= 0 && y <= 480),
    "made to fit",
  );
  await drop(
    page,
    JSON.stringify({
      points: [
        [1, 2],
        [3, 4],
        [5, 6],
        [7, 8],
      ],
      t: 0.125,
      show: ["comb"],
    }),
  );
  assert.deepEqual(await ask(page, () => [a.t, a.show, a.points[3]]), [0.125, "comb", [7, 8]]);
  for (const [text, words] of /** @type {[string, RegExp][]} */ ([
    ["hello world", /no figure: points/],
    ["{", /no figure/],
    ["[1, 2]", /no figure/],
    ["<svg></svg>", /no figure: .*path/],
    ["M0 0 L x", /no figure/],
    ["", /no figure/],
    ['{"points": [[1, null]]}', /no figure/],
  ])) {
    await drop(page, text);
    assert.match(await message(page), words, text);
    assert.deepEqual((await points(page))[3], [7, 8]);
  }
  await page.locator("bezier-applet summary", { hasText: "Save" }).click();
  await page
    .locator('bezier-applet input[type="file"]')
    .setInputFiles({ name: "a.txt", mimeType: "text/plain", buffer: Buffer.from("5,5 9,9 20,30 40,50") });
  await page.waitForFunction(() => a.points[0][0] === 5);
  await page.evaluate(() => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", "[[1,1],[2,2],[3,3],[4,4]]");
    a.shadowRoot
      .querySelector("[data-index] input")
      .dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, composed: true, cancelable: true }));
  });
  assert.deepEqual((await points(page))[3], [4, 4]);
  await ask(page, () => a.undo());
  assert.deepEqual((await points(page))[3], [40, 50]);
});

test("SVG, PNG and code come out, and the code draws the same curve", async (t) => {
  const page = await openApplet(t, 'controls show="polygon hull construction names"');
  const svg = await ask(page, () => a.toSVG());
  const parsed = await page.evaluate((text) => {
    const root = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
    return [
      root.localName,
      root.querySelectorAll("parsererror").length,
      root.querySelectorAll("path").length > 10,
      root.textContent.includes("P1223"),
    ];
  }, svg);
  assert.deepEqual(parsed, ["svg", 0, true, true]);
  const image = await ask(page, async () => {
    const { width, height } = await createImageBitmap(await a.toBlob());
    return [width, height];
  });
  assert.deepEqual(image, [670, 480]);
  await page.locator("bezier-applet summary", { hasText: "Save" }).click();
  const code = page.locator("bezier-applet pre");
  await page.waitForFunction(() => /Spline/.test(a.shadowRoot.querySelector("pre").textContent));
  assert.match(await code.innerText(), /import \{ Spline \} from "casteljau"[\s\S]*\[70, 330\][\s\S]*degree: 3/);
  await page.getByRole("combobox", { name: "Code" }).selectOption("rust");
  await settled(page);
  assert.match(await code.innerText(), /Curve::new\(&\[DVec2::new\(70\.0, 330\.0\)/);
  await page.getByRole("combobox", { name: "Code" }).selectOption("canvas");
  await settled(page);
  const calls = await code.innerText();
  assert.match(
    calls,
    /^ctx\.beginPath\(\);\nctx\.moveTo\(70, 330\);\nctx\.bezierCurveTo\(110, 90, 235, 120, 325, 230\);/,
  );
  for (const basis of ["bezier", "b-spline", "natural", "centripetal", "hermite", "catmull-rom"]) {
    const same = await ask(
      page,
      `(async () => {
      a.basis = "${basis}";
      const text = (await a.toCode("js")).replace(/import.*\\n/, "") + "; return [x, y];";
      const [x, y] = new Function("Spline", "Curve", text)(bezier.Spline, bezier.Curve);
      const place = a.figure.pieces[a.figure.segment].curve.eval(a.t);
      return Math.hypot(place.x - x, place.y - y);
    })()`,
    );
    assert.ok(same < 0.01, `${basis}: ${same}`);
  }
});

test("saved files have their names", async (t) => {
  const page = await openApplet(t, "controls");
  await page.locator("bezier-applet summary", { hasText: "Save" }).click();
  for (const ending of ["SVG", "PNG", "JSON"]) {
    const [download] = await Promise.all([page.waitForEvent("download"), button(page, ending).click()]);
    assert.equal(download.suggestedFilename(), `curve.${ending.toLowerCase()}`);
  }
});

test("zoom: buttons, Ctrl and the wheel about the pointer, dragging what is seen; the curve stays sharp at any closeness", async (t) => {
  const page = await openApplet(t, 'controls t="0.5"');
  const view = () => ask(page, () => a.view.split(" ").map(Number));
  await button(page, "Closer").click();
  assert.deepEqual(await view(), [167.5, 120, 335, 240]);
  await button(page, "Whole picture").click();
  assert.equal(await ask(page, () => a.view), "0 0 670 480");
  const [x, y] = (await centre(page, 3)).map(Math.round); // the wheel tells whole pixels
  await page.mouse.move(x, y);
  await page.keyboard.down("Control");
  await page.mouse.wheel(0, -1000);
  await page.keyboard.up("Control");
  await settled(page);
  near(await centre(page, 3), [x, y], 4, "the place under the pointer stays");
  assert.ok((await view())[2] < 100);
  const before = await points(page);
  await drag(page, 3, 20, 10);
  const scale = (await view())[2] / 670;
  near((await points(page))[3], [before[3][0] + 20 * scale, before[3][1] + 10 * scale], 0.01);
  const seen = await view();
  const stage = await boxOf(page.locator("bezier-applet .overlay"));
  await page.mouse.move(stage.x + 50, stage.y + 440);
  await page.mouse.down();
  await page.mouse.move(stage.x + 80, stage.y + 420);
  await page.mouse.up();
  await settled(page);
  near((await view()).slice(0, 2), [seen[0] - 30 * scale, seen[1] + 20 * scale], 0.05, "the picture is moved");
  assert.ok(await ask(page, () => a.getAttribute("points") !== null));
  for (const closeness of [1e3, 1e6, 1e8]) {
    await page.evaluate((closeness) => {
      const { x, y } = a.figure.pieces[0].curve.eval(0.3);
      a.view = [x - 335 / closeness, y - 240 / closeness, 670 / closeness, 480 / closeness].join(" ");
    }, closeness);
    await settled(page);
    assert.ok((await ink(page, [335, 240], 3)) > 10, `the curve runs through the middle at ${closeness}`);
  }
});

test("two fingers on the picture enlarge it", async (t) => {
  const page = await openApplet(t, "", { hasTouch: true });
  const { x, y } = await boxOf(page.locator("bezier-applet .overlay"));
  const client = await page.context().newCDPSession(page);
  const touch = (type, ...places) =>
    client.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: places.map(([dx, dy], id) => ({ x: x + dx, y: y + dy, id })),
    });
  await touch("touchStart", [400, 100]);
  await touch("touchStart", [400, 100], [440, 100]);
  for (const d of [10, 20, 30, 40]) await touch("touchMove", [400 - d, 100], [440 + d, 100]);
  await touch("touchEnd");
  await settled(page);
  const width = await ask(page, () => Number(a.view.split(" ")[2]));
  assert.ok(width > 150 && width < 300, `${width}`);
});
