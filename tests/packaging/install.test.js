// The code on the site's page "Installation", as it stands there, with the installed tarball.
import assert from "node:assert/strict";
import { build as esbuild } from "esbuild";
import { readFile, symlink } from "node:fs/promises";
import { join } from "node:path";
import { after, test } from "node:test";
import { compile } from "svelte/compiler";
import { build as vite } from "vite";
import { compileScript, parse } from "vue/compiler-sfc";
import webpack from "webpack";
import { Spline } from "casteljau";
import { frames, openPage, root } from "../page/browser.js";
import { serve } from "../page/server.js";
import { installed, run } from "./fixture.js";

const text = await readFile(join(root, "www/install/index.md"), "utf8");
const fixture = await installed();
after(fixture.remove);

/** The blocks of code below a heading of the page. @param {string} id */
function codeOf(id) {
  const section = text.split(/^## .*(?=\{#)/m).find((part) => part.startsWith(`{#${id}}`)) ?? "";
  const blocks = [...section.matchAll(/^```\w*\n([\s\S]*?)^```$/gm)].map(([, code]) => code);
  assert.ok(blocks.length, `code below the heading #${id}`);
  return blocks;
}

const POINTS = [
  [0, 0],
  [1, 2],
  [2, 0],
];
const PATH = Spline.interpolate(POINTS).toSVG();
/** The length of the curve of several examples: a parabola. */
const LENGTH = Math.sqrt(5) + Math.asinh(2) / 2;
const isLength = (printed) => assert.ok(Math.abs(Number(printed) - LENGTH) < 1e-9, printed);

/** Bundles a program with the packages of this repository, and casteljau from the tarball. */
async function bundle(name, code, options = {}) {
  const outfile = join(fixture.folder, `out/${name}`);
  const entry = await fixture.write(`src/${name}.jsx`, code);
  await esbuild({
    entryPoints: [entry],
    outfile,
    bundle: true,
    format: "esm",
    jsx: "automatic",
    nodePaths: [join(root, "node_modules")],
    logLevel: "silent",
    ...options,
  });
  return outfile;
}

/** Bundles for Node and runs it. */
const runBundle = async (name, code, plugins = []) =>
  run(process.execPath, [await bundle(name, code, { platform: "node", format: "cjs", plugins })]);

/** Opens a folder's index.html, and gives back the page and what it prints first. */
async function visit(t, folder) {
  const server = await serve({ "/": folder });
  t.after(server.close);
  const page = await openPage(t, "about:blank", { baseURL: server.url });
  const printed = page.waitForEvent("console", (message) => message.type() === "log");
  await page.goto("/index.html");
  return { page, printed: (await printed).text() };
}

const document = (body) => `<!doctype html><html lang="en"><title>A page</title><body>${body}</body></html>`;

test("npm: the first program prints what its comment says", async () => {
  const [command, code] = codeOf("npm");
  assert.equal(command.trim(), "npm install casteljau");
  const printed = await run(process.execPath, [await fixture.write("first.mjs", code)]);
  assert.equal(printed, code.match(/\/\/ (\{.*\})/)?.[1]);
});

test("script tag: a classic script, and a module with an import map", async (t) => {
  const [classic, module] = codeOf("script-tag");
  await fixture.write("node_modules/casteljau/dist/index.html", document(classic));
  isLength((await visit(t, join(fixture.installed, "dist"))).printed);
  await fixture.write("node_modules/index.html", document(module));
  isLength((await visit(t, join(fixture.folder, "node_modules"))).printed);
});

/** Builds with webpack into a folder with a page. */
async function packed(name, code) {
  const path = join(fixture.folder, `out/${name}`);
  /** @type {import("webpack").Configuration} */
  const options = {
    entry: await fixture.write(`src/${name}.mjs`, code),
    mode: "production",
    output: { path, filename: "main.js", publicPath: "auto" },
  };
  const stats = await new Promise((done, failed) =>
    webpack(options, (error, result) => (error ? failed(error) : done(result))),
  );
  assert.equal(stats.toString({ all: false, errors: true }), "");
  await fixture.write(`out/${name}/index.html`, document('<script src="main.js"></script>'));
  return path;
}

test("slim: the module as a file, in webpack and in Vite", async (t) => {
  const [example] = codeOf("slim");
  isLength((await visit(t, await packed("slim", example))).printed);

  const [forVite, forWebpack] = codeOf("bundlers")[0].split("// webpack");
  const [imports, rest] = example.split(/^await init.*$/m);
  isLength((await visit(t, await packed("slim-line", `${imports}${forWebpack}${rest}`))).printed);
  await fixture.write("src/slim-vite.js", `${imports}${forVite}${rest}`);
  await fixture.write("index.html", document('<script type="module" src="/src/slim-vite.js"></script>'));
  const outDir = join(fixture.folder, "out/slim-vite");
  await vite({ root: fixture.folder, configFile: false, logLevel: "error", build: { outDir, target: "esnext" } });
  isLength((await visit(t, outDir)).printed);
});

test("server: an SVG of text", async () => {
  const [code] = codeOf("server");
  const printed = await run(process.execPath, [await fixture.write("server.mjs", `${code}\nconsole.log(html);`)]);
  assert.match(printed, /<path d="M10,90 C40,10 60,10 90,90" fill="none"/);
  const without = 'import "casteljau/elements";\nconsole.log("nothing happened");';
  assert.equal(await run(process.execPath, [await fixture.write("elements.mjs", without)]), "nothing happened");
});

test("React: a component with a curve, on the server", async () => {
  const code = `import { renderToStaticMarkup } from "react-dom/server";
${codeOf("react")[0]}
console.log(renderToStaticMarkup(<Line points={${JSON.stringify(POINTS)}} />));`;
  assert.equal(await runBundle("react.cjs", code), `<path d="${PATH}" fill="none" stroke="currentColor"></path>`);
});

/**
 * Runs a program in a page, in which an element shows three points and prints changed ones.
 *
 * @param {import("node:test").TestContext} t
 * @param {string} name of a folder
 * @param {string} program shows the element with POINTS_GIVEN, and calls show(points)
 * @param {import("esbuild").Plugin[]} [plugins]
 */
async function testElement(t, name, program, plugins = []) {
  const code = `${program}
const element = () => document.querySelector("bezier-applet");
const look = () => element()?.points?.length === 3 ? console.log("ready") : requestAnimationFrame(look);
look();`;
  const define = {
    "process.env.NODE_ENV": '"production"',
    __VUE_OPTIONS_API__: "true",
    __VUE_PROD_DEVTOOLS__: "false",
    __VUE_PROD_HYDRATION_MISMATCH_DETAILS__: "false",
  };
  await bundle(`${name}/main.js`, code, { define, format: "iife", plugins, conditions: ["browser"] });
  await fixture.write(`out/${name}/index.html`, document('<main></main><script src="main.js"></script>'));
  const { page, printed } = await visit(t, join(fixture.folder, "out", name));
  assert.equal(printed, "ready");
  const changed = page.waitForEvent("console", (message) => message.text().startsWith("["));
  await page.locator('bezier-applet [data-index="0"] input').first().focus();
  await page.keyboard.press("ArrowRight");
  await frames(page);
  const points = JSON.parse((await changed).text());
  assert.ok(points[0][0] > 0 && points[0][1] === 0, JSON.stringify(points));
}

const SHOW = `const given = [[0, 0], [100, 0], [200, 100]];
const show = (points) => console.log(JSON.stringify(points));`;

test("React: an element gets points and tells changes", (t) =>
  testElement(
    t,
    "react",
    `import { createRoot } from "react-dom/client";
${codeOf("react")[1]}
${SHOW}
createRoot(document.querySelector("main")).render(<Figure points={given} onPoints={show} />);`,
  ));

/** Type checks a component against the installed package; an error in it is found, too. */
async function testTypes(checker, name, text, mistake) {
  const folder = join(fixture.folder, `types-${name}`);
  await fixture.write(
    `types-${name}/tsconfig.json`,
    JSON.stringify({
      compilerOptions: {
        strict: true,
        noEmit: true,
        target: "es2023",
        module: "esnext",
        moduleResolution: "bundler",
        lib: ["es2023", "dom", "dom.iterable"],
        types: [],
        skipLibCheck: true,
      },
      vueCompilerOptions: { strictTemplates: true },
      include: ["."],
    }),
  );
  const library = join(fixture.folder, "node_modules", name);
  await symlink(join(root, "node_modules", name), library, "junction").catch(() => {});
  const check = () =>
    run(process.execPath, ["--require", join(root, "tests/packaging/typescript-6.cjs"), ...checker], { cwd: folder });
  const file = `types-${name}/Figure.${name}`;
  await fixture.write(file, text);
  await check();
  assert.ok(text.includes(mistake[0]));
  await fixture.write(file, text.replace(...mistake));
  await assert.rejects(check, /not assignable/);
}

test("Vue: an element is type checked, gets points and tells changes", async (t) => {
  const text = codeOf("vue")[1];
  const checker = [join(root, "node_modules/vue-tsc/bin/vue-tsc.js"), "-p", "."];
  await testTypes(checker, "vue", text, [':points="points"', ':points="changed"']);
  const isCustomElement = (tag) => tag.startsWith("bezier-");
  const plugin = {
    name: "vue",
    setup: (build) =>
      build.onLoad({ filter: /\.vue$/ }, async ({ path }) => {
        const { descriptor } = parse(await readFile(path, "utf8"), { filename: path });
        const templateOptions = { compilerOptions: { isCustomElement } };
        const { content } = compileScript(descriptor, { id: "figure", inlineTemplate: true, templateOptions });
        return { contents: content, loader: "ts" };
      }),
  };
  await fixture.write("src/vue/Figure.vue", text);
  const program = `import { createApp } from "vue";
import Figure from "./Figure.vue";
${SHOW}
createApp(Figure, { points: given, onPoints: show }).mount("main");`;
  await testElement(t, "vue", program, [plugin]);
});

test("Svelte: an element is type checked, gets points and tells changes", async (t) => {
  const text = codeOf("svelte")[1];
  const checker = [join(root, "node_modules/svelte-check/bin/svelte-check"), "--tsconfig", "tsconfig.json"];
  await testTypes(checker, "svelte", text, ["{points}", "points={onPoints}"]);
  const plugin = {
    name: "svelte",
    setup: (build) =>
      build.onLoad({ filter: /\.svelte$/ }, async ({ path }) => {
        const { js } = compile(await readFile(path, "utf8"), { generate: "client", filename: path });
        return { contents: js.code, loader: "js" };
      }),
  };
  await fixture.write("src/svelte/Figure.svelte", text);
  const program = `import { mount } from "svelte";
import Figure from "./Figure.svelte";
${SHOW}
mount(Figure, { target: document.querySelector("main"), props: { points: given, onPoints: show } });`;
  await testElement(t, "svelte", program, [plugin]);
});

test("Vue: a component with a curve, on the server", async () => {
  const plugin = {
    name: "vue",
    setup: (build) =>
      build.onLoad({ filter: /\.vue$/ }, async ({ path }) => {
        const { descriptor } = parse(await readFile(path, "utf8"), { filename: path });
        const templateOptions = { ssr: true, ssrCssVars: [] };
        const { content } = compileScript(descriptor, { id: "line", inlineTemplate: true, templateOptions });
        return { contents: content, loader: "js" };
      }),
  };
  await fixture.write("src/Line.vue", codeOf("vue")[0]);
  const code = `import { createSSRApp } from "vue";
import { renderToString } from "vue/server-renderer";
import Line from "./Line.vue";
renderToString(createSSRApp(Line, { points: ${JSON.stringify(POINTS)} })).then(console.log);`;
  assert.equal(
    await runBundle("vue.cjs", code, [plugin]),
    `<path d="${PATH}" fill="none" stroke="currentColor"></path>`,
  );
});

test("Svelte: a component with a curve, on the server", async () => {
  const plugin = {
    name: "svelte",
    setup: (build) =>
      build.onLoad({ filter: /\.svelte$/ }, async ({ path }) => {
        const { js } = compile(await readFile(path, "utf8"), { generate: "server", filename: path });
        return { contents: js.code, loader: "js" };
      }),
  };
  await fixture.write("src/Line.svelte", codeOf("svelte")[0]);
  const code = `import { render } from "svelte/server";
import Line from "./Line.svelte";
console.log(render(Line, { props: { points: ${JSON.stringify(POINTS)} } }).body);`;
  assert.match(await runBundle("svelte.cjs", code, [plugin]), new RegExp(`<path d="${PATH}" fill="none"`));
});
