// The modules that need SIMD give the bytes that the usual ones give.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { launch, open, pixels, rendered, set } from "./browser.js";
import { MODULES, serve, simdModules } from "./server.js";

const NAMES = ["web", "web_f64", "web_fast", "web_q20", "web_card"];
const MATHS = ["f32", "f64", "fast", "q20"];
const SMALL = { width: 96, height: 72, samples: 1 };

/** The bytes of the card's page, and of every scene that the other page shows in a number type. */
async function pictures(browser, files) {
  const server = await serve(files);
  const found = new Map();
  const page = await open(browser, `${server.url}/examples/web/`);
  await page.waitForSelector("#scene:enabled");
  await page.locator("#compare").uncheck();
  await set(page, SMALL);
  const scenes = await page.locator("#scene option").allTextContents();
  for (const maths of MATHS) {
    await set(page, { maths });
    for (const [scene, name] of scenes.entries()) {
      await set(page, { scene });
      await rendered(page);
      if (await page.locator("#message").isVisible()) continue; // The type refuses it.
      found.set(`${name} in ${maths}`, (await pixels(page)).data);
    }
  }
  const card = await open(browser, `${server.url}/examples/web/card.html`);
  await rendered(card);
  found.set("card.html", (await pixels(card)).data);
  assert.deepEqual([...page.problems, ...card.problems], []);
  server.close();
  return found;
}

test("the modules need SIMD", () => {
  const tool = fileURLToPath(new URL("node_modules/.bin/wasm-opt", import.meta.url));
  const options = ["--all-features", "--disable-simd", join(simdModules, "web_card.wasm")];
  assert.throws(() => execFileSync(tool, options, { stdio: "pipe" }), /SIMD operations require SIMD/);
});

test("modules with SIMD give the same bytes in every scene and number type", async () => {
  const replaced = NAMES.map((name) => [`${MODULES}/${name}.wasm`, join(simdModules, `${name}.wasm`)]);
  const browser = await launch();
  try {
    const usual = await pictures(browser, {});
    const simd = await pictures(browser, Object.fromEntries(replaced));
    assert.deepEqual([...simd.keys()], [...usual.keys()]);
    assert.ok(usual.size > 4 * 14, String(usual.size));
    for (const [name, data] of usual) assert.ok(data.equals(simd.get(name)), `${name}: the bytes differ`);
  } finally {
    await browser.close();
  }
});
