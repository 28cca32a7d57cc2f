// A plugin for Vite: while the site is being worked on, the Rust documentation under /rust/ is made at the first request for
// one of its pages. The built site has it from scripts/build.js.
import { spawn } from "node:child_process";
import { readFile } from "node:fs/promises";
import { extname } from "node:path";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../..", import.meta.url));

/** @type {Record<string, string>} */
const TYPES = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".css": "text/css; charset=utf-8",
  ".svg": "image/svg+xml",
  ".woff2": "font/woff2",
};

/** Runs `cargo doc` with the flags of the driver. @returns {Promise<void>} */
function makeDocs() {
  const args = ["doc", "--quiet", "--no-deps", "--package", "casteljau", "--features", "serde,kurbo"];
  const cargo = spawn("cargo", args, { cwd: root, stdio: ["ignore", "inherit", "inherit"] });
  return new Promise((resolve, reject) =>
    cargo
      .once("error", reject)
      .once("exit", (code) => (code === 0 ? resolve() : reject(new Error(`cargo doc ended with ${code}`)))),
  );
}

/** @returns {import("vite").Plugin} */
export function rustDocs() {
  /** @type {Promise<void> | undefined} */
  let made;
  return {
    name: "rust-docs",
    configureServer({ middlewares, config }) {
      middlewares.use("/rust/", async (request, response, next) => {
        const path = new URL(request.url ?? "/", "http://localhost").pathname;
        const file = new URL(`../../target/doc${path.endsWith("/") ? `${path}index.html` : path}`, import.meta.url);
        try {
          if (!made) config.logger.info("making the Rust documentation (cargo doc)");
          made ??= makeDocs();
          await made;
          const bytes = await readFile(file);
          response.setHeader("Content-Type", TYPES[extname(file.pathname)] ?? "application/octet-stream");
          response.end(bytes);
        } catch (error) {
          if (/** @type {{ code?: string }} */ (error).code === "ENOENT") return next();
          made = undefined; // the next request tries again
          next(error);
        }
      });
    },
  };
}
