// <bezier-applet>: what it is given: odd attributes, drops, files; what it gives: files and code; zoom.
// tests/js/element-applet.test.js has the refusals of attributes, properties, methods and dropped texts.
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  ask,
  button,
  centre,
  drag,
  FIRST,
  fired,
  handle,
  ink,
  message,
  openApplet,
  points,
  pointsText,
  press,
  pull,
  settled,
} from "./bezier-applet-page.js";
import { boxOf } from "./browser.js";
import { assertNear, downloadBy, dragFrom } from "./gestures.js";

test("any text in attributes: a bad one is reported shortly, the last good one is kept, and the element still works", async (t) => {
  const page = await openApplet(t, 'points="10,20 30,200 300,40 400,300"');
  const written = (name, text) =>
    page.evaluate(
      async ([name, text]) => {
        a.setAttribute(name, text);
        await a.updateComplete;
      },
      [name, text],
    );
  for (const [name, text] of [
    ["t", "seven"],
    ["points", "x".repeat(2 ** 20)],
  ]) {
    await written(name, text);
    assert.match(await message(page), new RegExp(`${name}: expected`));
    assert.ok((await message(page)).length < 200);
    await page.evaluate((name) => a.removeAttribute(name), name);
  }
  for (const name of ["theme", "hotkeys", "controls", "label", "readonly"]) await written(name, "<b>&'x");
  await settled(page);
  await ask(page, () => a.removeAttribute("readonly"));
  assert.deepEqual([await message(page), await pointsText(page)], ["", FIRST]);
  await drag(page, 1, 20, 20);
  await ask(page, () => a.undo());
  assert.equal(await pointsText(page), FIRST);
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

test("a text is dropped, a file opened, a text pasted; one that is not a figure is refused with a message", async (t) => {
  const page = await openApplet(t, "controls");
  await drop(page, '{"points":[[1,2],[3,4],[5,6],[7,8]],"t":0.125,"show":["comb"]}');
  assert.deepEqual(await ask(page, () => [a.t, a.show, a.points[3]]), [0.125, "comb", [7, 8]]);
  await drop(page, "<svg></svg>");
  assert.match(await message(page), /no figure: .*path/);
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
  assert.equal(await pointsText(page), "1,1 2,2 3,3 4,4");
  await ask(page, () => a.undo());
  assert.equal(await pointsText(page), "5,5 9,9 20,30 40,50");
});

test("SVG, PNG and code come out, the code draws the same curve, and saved files have their names", async (t) => {
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
  const distance = await ask(page, async () => {
    const text = `${(await a.toCode("js")).replace(/import.*\n/, "")}; return [x, y];`;
    const [x, y] = new Function("Spline", "Curve", text)(bezier.Spline, bezier.Curve);
    const place = a.figure.pieces[a.figure.segment].curve.eval(a.t);
    return Math.hypot(place.x - x, place.y - y);
  });
  assert.ok(distance < 0.01, `${distance}`);
  for (const ending of ["SVG", "PNG", "JSON"])
    assert.equal((await downloadBy(button(page, ending))).name, `curve.${ending.toLowerCase()}`);
});

test("zoom: buttons, Ctrl and the wheel about the pointer, dragging what is seen; the curve stays sharp at any closeness", async (t) => {
  const page = await openApplet(t, 'controls t="0.5"');
  const view = () => ask(page, () => Object.values(a.view));
  await button(page, "Closer").click();
  assert.deepEqual(await view(), [167.5, 120, 335, 240]);
  await button(page, "Whole picture").click();
  assert.deepEqual(await view(), [0, 0, 670, 480]);
  const [x, y] = (await centre(page, 3)).map(Math.round); // the wheel tells whole pixels
  await page.mouse.move(x, y);
  await page.keyboard.down("Control");
  await page.mouse.wheel(0, -1000);
  await page.keyboard.up("Control");
  await settled(page);
  assertNear(await centre(page, 3), [x, y], 4, "the place under the pointer stays");
  assert.ok((await view())[2] < 100);
  const before = await points(page);
  await drag(page, 3, 20, 10);
  const scale = (await view())[2] / 670;
  assertNear((await points(page))[3], [before[3][0] + 20 * scale, before[3][1] + 10 * scale], 0.01);
  const seen = await view();
  const stage = await boxOf(page.locator("bezier-applet .overlay"));
  await dragFrom(page, [stage.x + 50, stage.y + 440], 30, -20);
  await settled(page);
  assertNear((await view()).slice(0, 2), [seen[0] - 30 * scale, seen[1] + 20 * scale], 0.05, "the picture is moved");
  assert.ok(await ask(page, () => a.getAttribute("points") !== null));
  for (const closeness of [1e3, 1e6, 1e8]) {
    await page.evaluate((closeness) => {
      const { x, y } = a.figure.pieces[0].curve.eval(0.3);
      const [width, height] = [670 / closeness, 480 / closeness];
      a.view = { x: x - width / 2, y: y - height / 2, width, height };
    }, closeness);
    await settled(page);
    assert.ok((await ink(page, [335, 240], 3)) > 10, `the curve runs through the middle at ${closeness}`);
  }
});

test("controls and picture follow a change together, in the next frame", async (t) => {
  const page = await openApplet(t, "controls");
  const [first, soon, later] = await page.evaluate(async () => {
    const root = a.shadowRoot;
    const shown = () => [root.querySelector("[name=t]").value, root.querySelector("canvas").toDataURL()];
    const first = shown();
    a.t = 0.9;
    for (let i = 0; i < 10; i++) await null;
    const soon = shown();
    await a.updateComplete;
    return [first, soon, shown()];
  });
  assert.deepEqual(soon, first);
  assert.deepEqual([later[0], later[1] === first[1]], ["0.9", false]);
});

test("pointing at a place is drawn and changes nothing else", async (t) => {
  const page = await openApplet(t, 'controls show="nearest"');
  const picture = () => page.evaluate(() => a.shadowRoot.querySelector("canvas").toDataURL());
  const box = await boxOf(page.locator("bezier-applet .overlay"));
  const [empty, state] = [await picture(), await ask(page, () => JSON.stringify(a))];
  await page.mouse.move(box.x + 300, box.y + 60);
  await settled(page);
  assert.notEqual(await picture(), empty);
  assert.match((await page.locator("bezier-applet .messages").textContent()) ?? "", /Nearest/);
  assert.deepEqual([await fired(page), await ask(page, () => JSON.stringify(a))], [[], state]);
  await page.mouse.move(box.x + 300, box.y + box.height + 200);
  await settled(page);
  assert.equal(await picture(), empty);
});

test("a pointer that is released outside of the picture is let go", async (t) => {
  const page = await openApplet(t);
  const view = () => ask(page, () => Object.values(a.view));
  const box = await boxOf(page.locator("bezier-applet .overlay"));
  const empty = [box.x + 40, box.y + 30];
  await page.mouse.move(empty[0], empty[1]);
  await page.mouse.down();
  await page.mouse.move(box.x + 40, box.y + box.height + 300, { steps: 3 });
  await page.mouse.up();
  await page.mouse.move(empty[0], empty[1], { steps: 3 });
  await page.keyboard.down("Control");
  await page.mouse.wheel(0, -500);
  await page.keyboard.up("Control");
  await settled(page);
  const before = await view();
  assert.ok(before[2] < 600, "enlarged");
  await page.mouse.move(empty[0] + 60, empty[1] + 40, { steps: 3 });
  await settled(page);
  assert.deepEqual(await view(), before, "no button is pressed");
});

test("Escape during a drag takes back the point, not the enlargement", async (t) => {
  const page = await openApplet(t);
  const first = await pointsText(page);
  await pull(page, 2, 30, 40);
  assert.notEqual(await pointsText(page), first);
  await page.keyboard.down("Control");
  await page.mouse.wheel(0, -300);
  await page.keyboard.up("Control");
  await settled(page);
  const view = await ask(page, () => Object.values(a.view));
  assert.ok(view[2] < 670, "enlarged");
  await press(page, "Escape");
  await page.mouse.up();
  assert.equal(await pointsText(page), first);
  assert.deepEqual(await ask(page, () => Object.values(a.view)), view);
});

test("an element that was never on the page gives its picture, and can be put there afterwards", async (t) => {
  const page = await openApplet(t, 'points="0,0 100,200 300,200 400,0" t="0.25"');
  const [apart, shown] = await page.evaluate(async () => {
    const element = /** @type {any} */ (document.createElement("bezier-applet"));
    element.setAttribute("points", "0,0 100,200 300,200 400,0");
    element.t = 0.25;
    const apart = await element.toSVG();
    const shown = await a.toSVG();
    a.replaceWith(element);
    element.id = "a";
    globalThis.a = element;
    return [apart, shown];
  });
  assert.equal(apart.replace(/stroke="[^"]*"|fill="[^"]*"/g, ""), shown.replace(/stroke="[^"]*"|fill="[^"]*"/g, ""));
  await page.waitForFunction(() => a.shadowRoot.querySelector(".overlay")?.style.width);
  assert.ok((await boxOf(handle(page, 0))).width > 10, "it has its style sheet");
});
