// The repository as any file server would serve it.

import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";

export const root = fileURLToPath(new URL("../..", import.meta.url));

/** Where the page finds the modules, and where cargo leaves them. */
export const MODULES = "/target/wasm32-unknown-unknown/small/examples";
const target = process.env.CARGO_TARGET_DIR || join(root, "target");
export const modules = fileFor(MODULES);
/** Those that need SIMD. */
export const simdModules = fileFor(MODULES.replace("/target/", "/target/simd/"));

/** Where the page looks for settings that were measured, and the file that it gets here unless a test has another. */
export const FRONTIER = "/examples/web/frontier.json";
export const sample = join(root, "tests/web/frontier.json");

const types = {
  ".html": "text/html; charset=utf-8",
  ".css": "text/css",
  ".js": "text/javascript",
  ".json": "application/json",
  ".wasm": "application/wasm",
};

/** Starts a server on a port of its own; `replaced` gives other files for some paths. */
export async function serve(replaced = {}) {
  const server = createServer(async (request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url, "http://localhost").pathname));
    const file = { [FRONTIER]: sample, ...replaced }[path] ?? fileFor(path.endsWith("/") ? `${path}index.html` : path);
    try {
      const body = await readFile(file);
      response.writeHead(200, { "content-type": types[extname(file)] ?? "application/octet-stream" });
      response.end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
  return { url: `http://127.0.0.1:${server.address().port}`, close: () => server.close() };
}

function fileFor(path) {
  return path.startsWith("/target/") ? join(target, path.slice("/target".length)) : join(root, path);
}
