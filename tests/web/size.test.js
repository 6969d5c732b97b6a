// How large the modules are, as cargo leaves them and after wasm-opt, and that both do the same.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { launch, open, pixels, rendered, set } from "./browser.js";
import { modules, serve, simdModules } from "./server.js";

/** The most bytes of each module. The aims are 32 KiB for `web` and 6 KiB for `web_card`, after wasm-opt. */
const LIMITS = {
  web: { plain: 170_000, optimised: 122_000 },
  web_f64: { plain: 189_000, optimised: 137_800 },
  web_fast: { plain: 176_800, optimised: 128_100 },
  web_q20: { plain: 167_500, optimised: 118_500 },
  web_nff: { plain: 61_500, optimised: 51_500 },
  web_card: { plain: 14_650, optimised: 12_100 },
};
/** Of `web` for speed, with SIMD. */
const SIMD_LIMITS = { plain: 188_800, optimised: 141_500 };

/** What the compiler's target has; where a module says so itself, it is cut off by `strip`. */
const FEATURES = ["bulk-memory", "multivalue", "mutable-globals", "nontrapping-float-to-int", "reference-types", "sign-ext"];

const folder = mkdtempSync(join(tmpdir(), "whit-web-"));
const optimised = (name) => join(folder, `${name}.wasm`);

function optimise(from, to, features) {
  const tool = fileURLToPath(new URL("node_modules/.bin/wasm-opt", import.meta.url));
  const options = ["-Oz", "--strip-debug", "--strip-producers", "--strip-target-features"];
  execFileSync(tool, [...options, ...features.map((feature) => `--enable-${feature}`), from, "-o", to]);
}

/** Prints the sizes of a module as it was left and as it was optimised, and compares both. */
function compare(name, files, limits) {
  const [plain, small] = files.map((file) => statSync(file).size);
  console.log(`${name}: ${plain} bytes, ${small} after wasm-opt`);
  assert.ok(plain <= limits.plain, `${name}: ${plain} bytes, the limit is ${limits.plain}`);
  assert.ok(small <= limits.optimised, `${name} after wasm-opt: ${small} bytes, the limit is ${limits.optimised}`);
}

before(() => {
  for (const name of Object.keys(LIMITS)) optimise(join(modules, `${name}.wasm`), optimised(name), FEATURES);
});

after(() => rmSync(folder, { recursive: true }));

test("no module is larger than its limit", () => {
  for (const [name, limits] of Object.entries(LIMITS)) {
    compare(name, [join(modules, `${name}.wasm`), optimised(name)], limits);
  }
  const [plain, small] = [join(simdModules, "web.wasm"), optimised("web_simd")];
  optimise(plain, small, [...FEATURES, "simd"]);
  compare("web with SIMD", [plain, small], SIMD_LIMITS);
});

test("optimised modules render the same", async () => {
  const path = (name) => `/target/wasm32-unknown-unknown/small/examples/${name}.wasm`;
  const replaced = Object.fromEntries(Object.keys(LIMITS).map((name) => [path(name), optimised(name)]));
  const browser = await launch();
  const found = [];
  for (const files of [{}, replaced]) {
    const server = await serve(files);
    const page = await open(browser, `${server.url}/examples/web/`);
    await page.waitForSelector("#scene:enabled");
    for (const scene of [0, 4, 7]) {
      for (const maths of ["f32", "f64", "fast", "q20"]) {
        await set(page, { scene, maths, width: 64, height: 48, samples: 1 });
        await rendered(page);
        found.push((await pixels(page)).data);
      }
    }
    assert.deepEqual(page.problems, []);
    server.close();
  }
  await browser.close();
  const count = found.length / 2;
  for (let i = 0; i < count; i++) assert.ok(found[i].equals(found[i + count]), `picture ${i} differs`);
});
