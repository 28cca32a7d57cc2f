// A small static server for the tests: folders, pages given as text, own headers.
import { createServer } from "node:http";
import { readFile, stat } from "node:fs/promises";
import { extname, join, normalize, resolve } from "node:path";

/** @type {Record<string, string>} */
const TYPES = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".css": "text/css; charset=utf-8",
  ".json": "application/json",
  ".svg": "image/svg+xml",
  ".png": "image/png",
  ".wasm": "application/wasm",
};

/**
 * Serves folders on a free port of this machine.
 *
 * @param {Record<string, string>} folders by URL prefix, such as { "/": "site", "/dist/": "dist" }
 * @param {Record<string, string>} [headers] sent with every answer
 * @returns {Promise<{ url: string, pages: Map<string, string>, close(): void }>} pages by path, served as HTML
 */
export async function serve(folders, headers = {}) {
  const pages = new Map();
  const server = createServer(async (request, response) => {
    const path = decodeURIComponent(new URL(request.url ?? "/", "http://localhost").pathname);
    const answer = await find(path, pages, folders);
    response.writeHead(answer.status, { "Content-Type": answer.type, "Cache-Control": "no-store", ...headers });
    response.end(answer.body);
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", () => done(undefined)));
  const address = /** @type {import("node:net").AddressInfo} */ (server.address());
  server.unref();
  const close = () => {
    server.closeAllConnections();
    return server.close();
  };
  return { url: `http://localhost:${address.port}`, pages, close };
}

/**
 * @param {string} path
 * @param {Map<string, string>} pages
 * @param {Record<string, string>} folders
 */
async function find(path, pages, folders) {
  if (pages.has(path)) return { status: 200, type: TYPES[".html"], body: pages.get(path) };
  if (path === "/favicon.ico") return { status: 204, type: "image/x-icon", body: "" }; // browsers ask unasked
  const prefixes = Object.keys(folders).sort((a, b) => b.length - a.length);
  const prefix = prefixes.find((candidate) => path.startsWith(candidate));
  const file = prefix === undefined ? "" : resolve(folders[prefix], normalize(`./${path.slice(prefix.length)}`));
  const body = prefix !== undefined && file.startsWith(resolve(folders[prefix])) && (await content(file));
  if (!body) return { status: 404, type: "text/plain", body: `no ${path}` };
  return { status: 200, type: TYPES[extname(body.name)] ?? "application/octet-stream", body: body.bytes };
}

/** @param {string} file */
async function content(file) {
  try {
    const name = (await stat(file)).isDirectory() ? join(file, "index.html") : file;
    return { name, bytes: await readFile(name) };
  } catch {
    return undefined;
  }
}
