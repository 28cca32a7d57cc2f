// The three applications: easing, camera, glyph. What they show is right, what the user does is kept, in the address too.
import assert from "node:assert/strict";
import { test } from "node:test";
import { easing, Path, Spline } from "../../dist/index.js";
import { assertAccessible, openPage, root } from "./browser.js";
import { serve } from "./server.js";

const PHONE = { viewport: { width: 360, height: 740 }, deviceScaleFactor: 2, hasTouch: true, isMobile: true };
const TAGS = { "/easing/": "easing-lab", "/camera/": "camera-path", "/glyph/": "glyph-editor" };

/** Opens an application and waits until it has drawn. */
async function open(t, path, options = {}) {
  const page = await openPage(t, path, { viewport: { width: 1000, height: 1000 }, reducedMotion: "reduce", ...options });
  await page.locator(`${TAGS[path.split("#")[0]]} svg`).first().waitFor();
  return page;
}

const state = (page) => page.evaluate(() => JSON.parse(decodeURIComponent(location.hash.slice("#state=".length))));
const slide = (page, name, value) => page.getByRole("slider", { name, exact: true }).first().fill(String(value));
const close = (a, b, tolerance) => assert.ok(Math.abs(a - b) <= tolerance, `${a} is not ${b}`);

for (const path of Object.keys(TAGS)) {
  for (const options of [{ colorScheme: "light" }, { colorScheme: "dark", ...PHONE }, { forcedColors: "active" }]) {
    test(`${path} is accessible and fits: ${Object.entries(options)[0].join(" ")}`, async (t) => {
      const page = await open(t, path, options);
      await assertAccessible(page);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), page.viewportSize().width);
    });
  }

  test(`${path} takes no harm from addresses that somebody made up`, async (t) => {
    for (const hash of ["#state=%E0%A4%A", "#state=null", "#state={\"points\":[[1,2]],\"curve\":[9,9,9,9],\"d\":\"M1 wrong\"}", `#state=${"x".repeat(200_000)}`]) {
      const page = await open(t, `${path}${hash}`);
      await page.locator(".state-message").waitFor();
      assert.match(await page.locator(".state-message").innerText(), /could not be used: .+\. The page is as it was\./);
    }
  });
}

test("applications and figures work under a strict policy", async (t) => {
  const policy = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' data:";
  const site = await serve({ "/": `${root}site` }, { "Content-Security-Policy": policy });
  t.after(site.close);
  for (const [path, tag] of [...Object.entries(TAGS), ["/figures/", "fig-compare"]]) {
    const page = await openPage(t, path, { baseURL: site.url });
    await page.locator(`${tag} svg`).first().waitFor();
    const handles = page.locator(`${tag} .handle`);
    if (await handles.count()) assert.ok((await handles.first().evaluate((handle) => handle.style.left)).endsWith("%"));
  }
});

test("easing: presets, text and editor are one value, which the address keeps", async (t) => {
  const page = await open(t, "/easing/");
  await page.getByRole("button", { name: "overshoot" }).click();
  assert.match(await page.locator("pre").first().innerText(), /cubic-bezier\(0\.34, 1\.56, 0\.64, 1\)/);
  assert.deepEqual(await state(page), { curve: [0.34, 1.56, 0.64, 1] });
  await page.waitForFunction(() => document.querySelector("bezier-easing").value === "cubic-bezier(0.34, 1.56, 0.64, 1)");
  const text = page.getByLabel("Value");
  for (const wrong of ["cubic-bezier(2, 0, 0, 1)", "bouncy", "cubic-bezier(0, NaN, 1, 1)", ""]) {
    await text.fill(wrong);
    await text.press("Enter");
    assert.match(await page.locator(".problem").innerText(), /^Not taken: .+ The last good curve is kept\.$/);
    assert.deepEqual(await page.evaluate(() => document.querySelector("easing-lab").value), [0.34, 1.56, 0.64, 1]);
  }
  await text.fill("transition-timing-function: cubic-bezier(.1, .7, 1, .1);");
  await text.press("Enter");
  assert.deepEqual(await state(page), { curve: [0.1, 0.7, 1, 0.1] });
  await page.reload();
  await page.waitForFunction(() => document.querySelector("easing-lab").value.join() === "0.1,0.7,1,0.1");
});

test("easing: the editor inside steers the page", async (t) => {
  const page = await open(t, "/easing/");
  const field = page.locator("bezier-easing input[type=number]").first();
  await field.waitFor();
  await field.fill("0.9");
  await field.press("Enter");
  await page.waitForFunction(() => document.querySelector("easing-lab").value[0] === 0.9);
  assert.equal((await state(page)).curve[0], 0.9);
});

test("easing: the preview is where the browser's own animation is, and x is not t", async (t) => {
  const page = await open(t, "/easing/");
  for (const name of ["gentle stop", "wind up"]) {
    await page.getByRole("button", { name }).click();
    await slide(page, "time x", 0.6);
    const value = await page.evaluate(() => document.querySelector("easing-lab").value);
    const browsers = await page.evaluate((numbers) => {
      const animation = document.body.animate([{ opacity: 1 }, { opacity: 1 }], { duration: 1000, easing: `cubic-bezier(${numbers})`, fill: "both" });
      animation.pause();
      animation.currentTime = 600;
      const { progress } = animation.effect.getComputedTiming();
      animation.cancel();
      return progress;
    }, value);
    const shown = await page.locator("[data-preview=move]").evaluate((box) => box.offsetLeft / (box.parentElement.clientWidth - box.offsetWidth));
    close(shown, browsers, 0.005); // whole pixels
    const t = Number(await page.locator(".t").innerText());
    close(3 * (1 - t) ** 2 * t * value[0] + 3 * (1 - t) * t * t * value[2] + t ** 3, 0.6, 2e-4);
    close(Number((await page.locator("b.y").innerText()).replace("−", "-")), easing(...value)(0.6), 1e-4);
  }
});

test("easing: playing runs the time, stops at its end, and can be stopped", async (t) => {
  const page = await open(t, "/easing/");
  await slide(page, "Duration", 200);
  const button = page.locator("easing-lab .frame .controls > button").first();
  await button.click();
  assert.equal(await button.innerText(), "Stop");
  await page.waitForFunction(() => document.querySelector("easing-lab").x === 1);
  await page.waitForFunction(() => !document.querySelector("easing-lab").playing);
});

test("camera: equal times are equal ways at even speed only", async (t) => {
  const page = await open(t, "/camera/");
  const ways = (even) => page.locator(`[data-even=${even}]`).evaluateAll((ticks) => ticks.map((tick) => Number(tick.dataset.s)));
  const steps = (list) => list.slice(1).map((s, i) => s - list[i]);
  const even = steps(await ways(true));
  const raw = steps(await ways(false));
  close(Math.max(...even), Math.min(...even), 1e-9);
  assert.ok(Math.max(...raw) > 1.5 * Math.min(...raw), "raw speed is uneven");
  close(raw.reduce((a, b) => a + b), even.reduce((a, b) => a + b), 1e-9);
  const at = async () => Number(await page.locator("b.t").innerText());
  await slide(page, "Time", 0.5);
  const evenly = await at();
  await page.getByRole("radio", { name: "raw t" }).check();
  assert.equal(await at(), 4);
  assert.notEqual(evenly, 4);
});

test("camera: the code on the page finds the place on the page", async (t) => {
  const page = await open(t, "/camera/");
  await slide(page, "Time", 0.37);
  const code = await page.locator("camera-path pre").innerText();
  const [, body, , place] = code.match(/^import .+?;\n(.*)\n(cameraAt\(0\.37\))\.position; \/\/ \((.+)\)$/s);
  const cameraAt = new Function("Spline", `${body}; return cameraAt;`)(Spline);
  const { position, forward, up } = cameraAt(0.37);
  place.replaceAll("−", "-").split(", ").forEach((text, k) => close(position[k], Number(text), 1e-3));
  close(forward[0] * up[0] + forward[1] * up[1] + forward[2] * up[2], 0, 1e-12);
});

test("camera: Frenet's frame leaps where the bend changes sides, the minimising one never", async (t) => {
  const page = await open(t, "/camera/");
  assert.ok(parseFloat(await page.locator("b.leap").innerText()) > 90);
  const ups = (kind) => page.evaluate(async (kind) => {
    const camera = document.querySelector("camera-path");
    camera.state = { ...camera.state, frames: kind };
    await camera.updateComplete;
    return camera.frames.map(({ normal }) => normal);
  }, kind);
  const least = (list) => Math.min(...list.slice(1).map((n, i) => n[0] * list[i][0] + n[1] * list[i][1] + n[2] * list[i][2]));
  assert.ok(least(await ups("minimising")) > 0.9);
  assert.ok(least(await ups("frenet")) < 0);
  assert.ok((await ups("upright")).every((normal) => normal[2] > 0.5));
});

test("camera: points are moved by hand and keys, added, deleted; the address has them", async (t) => {
  const page = await open(t, "/camera/");
  const points = () => page.evaluate(() => document.querySelector("camera-path").state.points);
  const before = await points();
  const handle = page.locator(".handle").nth(3);
  await handle.scrollIntoViewIfNeeded();
  const box = await handle.boundingBox();
  await page.mouse.move(box.x + 12, box.y + 12);
  await page.mouse.down();
  await page.mouse.move(box.x + 52, box.y - 8, { steps: 3 });
  await page.mouse.up();
  const after = await points();
  const moved = after[3].map((value, k) => value - before[3][k]);
  assert.ok(moved[0] > 0.5 && moved[1] > 0.2 && moved[2] === 0, String(moved));
  close(moved[0], 2 * moved[1], 0.02); // pixels are not divided
  await page.keyboard.press("ArrowRight");
  close((await points())[3][0], after[3][0] + 0.1, 1e-9);
  await slide(page, "Height of point 4", 6);
  assert.equal((await points())[3][2], 6);
  await page.getByRole("button", { name: "Add a point behind 4" }).click();
  assert.equal((await points()).length, before.length + 1);
  await page.getByRole("button", { name: "Delete point 4" }).click();
  assert.equal((await points()).length, before.length);
  const kept = (await state(page)).points;
  await page.reload();
  await page.waitForFunction((kept) => JSON.stringify(document.querySelector("camera-path").state.points) === kept, JSON.stringify(kept));
});

test("camera: Escape takes a drag back; playing moves, pausing stops", async (t) => {
  const page = await open(t, "/camera/");
  const points = () => page.evaluate(() => JSON.stringify(document.querySelector("camera-path").state.points));
  const before = await points();
  const handle = page.locator(".handle").nth(2);
  await handle.scrollIntoViewIfNeeded();
  const box = await handle.boundingBox();
  await page.mouse.move(box.x + 12, box.y + 12);
  await page.mouse.down();
  await page.mouse.move(box.x + 62, box.y + 12, { steps: 2 });
  assert.notEqual(await points(), before);
  await page.keyboard.press("Escape");
  assert.equal(await points(), before);
  await page.mouse.up();
  await page.getByRole("button", { name: "Play" }).click();
  await page.waitForFunction(() => document.querySelector("camera-path").progress > 0.01);
  await page.getByRole("button", { name: "Pause" }).click();
  const stood = await page.evaluate(() => document.querySelector("camera-path").progress);
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  assert.equal(await page.evaluate(() => document.querySelector("camera-path").progress), stood);
});

test("camera: both pictures are drawn, and change with the time and the theme", async (t) => {
  const page = await open(t, "/camera/");
  const picture = (id) => page.evaluate(async (id) => {
    const camera = document.querySelector("camera-path");
    await camera.updateComplete;
    const canvas = camera.shadowRoot.getElementById(id);
    const data = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    return { inked: data.filter((value, i) => i % 4 === 3 && value > 60).length, url: canvas.toDataURL() };
  }, id);
  for (const id of ["eye", "outside"]) {
    const first = await picture(id);
    assert.ok(first.inked > 2000, `${id}: ${first.inked}`);
    await slide(page, "Time", 0.3);
    const second = await picture(id);
    assert.notEqual(second.url, first.url);
    await page.emulateMedia({ colorScheme: "dark" });
    await page.waitForFunction(([id, url]) => document.querySelector("camera-path").shadowRoot.getElementById(id).toDataURL() !== url, [id, second.url]);
    await page.emulateMedia({ colorScheme: "light" });
    await slide(page, "Time", 0);
  }
});

/** The outline of the page as a Path of ours. */
const outline = async (page) => Path.fromJSON(await page.evaluate(() => document.querySelector("glyph-editor").path.toJSON()));
const data = (page) => page.getByLabel("SVG path data");

test("glyph: letters are inked where their contours wind, holes are holes", async (t) => {
  const page = await open(t, "/glyph/");
  for (const [name, inside, hole] of [["a", [570, 600], [400, 650]], ["R", [200, 400], [400, 300]], ["&", [470, 560], [380, 250]]]) {
    await page.getByRole("button", { name, exact: true }).click();
    const path = await outline(page);
    assert.ok(path.winding(inside) > 0, `${name} has ink`);
    assert.equal(path.winding(hole), 0, `${name} has a hole`);
  }
  await page.getByRole("button", { name: "a", exact: true }).click();
  await page.getByRole("slider", { name: /^Contour 2, point 0, x/ }).focus();
  assert.match(await page.locator(".direction").innerText(), /^counter-clockwise/);
  await page.getByRole("button", { name: "Turn contour round" }).click();
  assert.match(await page.locator(".direction").innerText(), /^clockwise/);
  assert.equal((await outline(page)).winding([400, 650]), 2);
  await page.keyboard.press("Control+z");
  assert.equal((await outline(page)).winding([400, 650]), 0);
});

test("glyph: a smooth joint stays smooth under the hand; freed, it breaks; undo and redo", async (t) => {
  const page = await open(t, "/glyph/");
  const g1 = async () => (await outline(page)).subpaths[0].continuity(3, 1e-6).g1;
  assert.equal(await g1(), true);
  const handle = page.getByRole("slider", { name: "Contour 1, handle 6, x" }).locator("..");
  const drag = async () => {
    await handle.scrollIntoViewIfNeeded();
    const box = await handle.boundingBox();
    await page.mouse.move(box.x + 12, box.y + 12);
    await page.mouse.down();
    await page.mouse.move(box.x + 2, box.y + 42, { steps: 4 });
    await page.mouse.up();
  };
  const before = await data(page).inputValue();
  await drag();
  const after = await data(page).inputValue();
  assert.notEqual(after, before);
  assert.equal(await g1(), true);
  await page.getByRole("button", { name: "Undo" }).click();
  assert.equal(await data(page).inputValue(), before);
  await page.getByRole("button", { name: "Redo" }).click();
  assert.equal(await data(page).inputValue(), after);
  await page.getByRole("slider", { name: "Contour 1, point 5, x" }).focus();
  await page.getByRole("combobox", { name: "Joint" }).selectOption("free");
  await drag();
  assert.equal(await g1(), false);
  await page.getByRole("slider", { name: "Contour 1, point 5, x" }).focus();
  assert.match(await page.locator(".truth").innerText(), /corner of/);
  await page.getByRole("combobox", { name: "Joint" }).selectOption("c1");
  assert.match(await page.locator(".truth").innerText(), /G1, C1/);
});

test("glyph: points are added without changing the outline, and healed away again", async (t) => {
  const page = await open(t, "/glyph/");
  const before = await outline(page);
  await page.getByRole("slider", { name: "Contour 1, point 5, x" }).focus();
  await page.keyboard.press("i");
  const more = await outline(page);
  assert.equal(more.subpaths[0].segmentCount, before.subpaths[0].segmentCount + 1);
  close(more.area(), before.area(), 1e-6);
  await page.getByRole("slider", { name: "Contour 1, point 8, x" }).focus();
  await page.keyboard.press("Delete");
  const healed = await outline(page);
  assert.ok(healed.equals(before, 1e-6));
  const { x, y } = await page.evaluate(() => {
    const editor = document.querySelector("glyph-editor");
    const rect = editor.shadowRoot.querySelector(".sheet").getBoundingClientRect();
    const [px, py] = editor.scales().place([620, 600]);
    return { x: rect.x + (px * rect.width) / editor.wide, y: rect.y + (py * rect.width) / editor.wide };
  });
  await page.mouse.dblclick(x, y);
  assert.equal((await outline(page)).subpaths[0].segmentCount, before.subpaths[0].segmentCount + 1);
  close((await outline(page)).area(), before.area(), 1e-6);
});

test("glyph: path data in; what is none is refused with its place, the last good outline kept", async (t) => {
  const page = await open(t, "/glyph/");
  const good = await data(page).inputValue();
  for (const [wrong, reason] of [["M10 10 L", /character/], ["hello", /character 0/], ["", /at least one/], [`M0 0${"h1v1".repeat(3000)}`, /at most 2000/]]) {
    await data(page).fill(wrong);
    await data(page).blur();
    await page.waitForFunction((reason) => new RegExp(reason).test(document.querySelector("glyph-editor").problem), reason.source);
    assert.match(await page.locator(".problem").innerText(), /^Not taken: .+The last good outline is kept\.$/s);
    assert.equal(await page.evaluate(() => document.querySelector("glyph-editor").path.toSVG({ precision: 2 })), good);
  }
  await data(page).fill("M0 0H40V40H0Z M10 10V30H30V10Z");
  await data(page).blur();
  await page.waitForFunction(() => document.querySelector("glyph-editor").outline.length === 2);
  assert.equal((await outline(page)).area(), 1200);
  assert.equal(await page.locator(".problem").innerText(), "");
  const kept = await state(page);
  await page.reload();
  await page.waitForFunction((d) => document.querySelector("glyph-editor")?.path?.toSVG({ precision: 2 }) === d, kept.d);
});

test("glyph: quadratics within the tolerance, measured", async (t) => {
  const page = await open(t, "/glyph/");
  const before = await outline(page);
  for (const power of [0.5, -1]) {
    await slide(page, "Tolerance", power);
    const error = Number(await page.locator("td.error").getAttribute("data-error"));
    assert.ok(error > 0 && error <= 10 ** power * 1.01, `${error}`);
    await page.getByRole("button", { name: "Make it quadratic" }).click();
    const quadratic = await outline(page);
    assert.ok(quadratic.subpaths.every((spline) => spline.degrees.every((degree) => degree <= 2)));
    assert.equal(Number(await page.locator("td.theirs").innerText()), quadratic.subpaths.reduce((sum, spline) => sum + spline.controlPoints().length / 2, 0));
    const far = before.evenly(900).map(({ subpath, t }) => quadratic.nearest(Object.values(before.subpaths[subpath].eval(t))).distance);
    close(Math.max(...far), error, 0.05 * error);
    await page.getByRole("button", { name: "Undo" }).click();
  }
});

test("glyph: any closeness, by buttons and keys, and back", async (t) => {
  const page = await open(t, "/glyph/");
  await page.getByRole("slider", { name: "Contour 1, point 5, x" }).focus();
  for (let i = 0; i < 4; i++) await page.getByRole("button", { name: "Close-up" }).click();
  await page.locator(".sheet").focus();
  await page.keyboard.press("+");
  const units = () => page.evaluate(() => document.querySelector("glyph-editor").seen.units);
  assert.ok((await units()) < 1, String(await units()));
  assert.equal(await page.locator(".handle").count(), 1, "only what is in the picture has a handle");
  await page.keyboard.press("0");
  assert.ok((await units()) > 400);
});

test("glyph: where boxes for fingers overlap, the nearest handle is taken", async (t) => {
  const page = await open(t, "/glyph/", PHONE);
  const first = page.locator(".handle").first();
  await first.scrollIntoViewIfNeeded();
  const centres = await page.locator(".handle").evaluateAll((handles) => handles.map((handle) => {
    const { x, y, width, height } = handle.getBoundingClientRect();
    return { x: x + width / 2, y: y + height / 2, width, name: handle.querySelector("input").ariaLabel };
  }));
  assert.ok(centres.length > 30 && centres[0].width >= 44, "boxes for fingers");
  const seen = centres.filter(({ y }) => y > 0 && y < 740).slice(0, 16);
  for (const { x, y, name } of seen) {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.up();
    assert.equal(await page.evaluate(() => document.querySelector("glyph-editor").shadowRoot.activeElement.ariaLabel), name);
  }
});
