// How many complete pictures a second the page shows while the camera turns.

import assert from "node:assert/strict";
import { test } from "node:test";
import { launch, open, rendered, set } from "./browser.js";
import { serve } from "./server.js";

/** Far below what a machine of today does alone, since one that tests may have others' work to do. */
const LEAST = 3;
const TURNS = 24;

/** Milliseconds from a key that turns the camera to the complete picture, for one key after the other. */
function latencies(turns) {
  const canvas = document.querySelector("canvas");
  const isDone = () => canvas.getAttribute("aria-busy") === "false";
  const complete = () => new Promise((resolve) => {
    const observer = new MutationObserver(() => isDone() && (observer.disconnect(), resolve()));
    observer.observe(canvas, { attributeFilter: ["aria-busy"] });
  });
  const turn = async (times) => {
    if (times.length === turns) return times;
    const begin = performance.now();
    const done = complete();
    canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft", cancelable: true }));
    await done;
    return turn([...times, performance.now() - begin]);
  };
  return turn([]);
}

test("the showcase is complete often enough while it turns in 320x240", async () => {
  const server = await serve();
  const browser = await launch();
  try {
    const page = await open(browser, `${server.url}/examples/web/`);
    await page.waitForSelector("#scene:enabled");
    await page.locator("#compare").uncheck();
    await set(page, { width: 320, height: 240, samples: 1 });
    await rendered(page);
    const times = (await page.evaluate(latencies, TURNS)).sort((a, b) => a - b);
    const rate = 1000 / times[TURNS / 2];
    console.log(`showcase, 320x240, f32, 1 sample: ${rate.toFixed(1)} complete pictures a second`);
    assert.ok(rate >= LEAST, `${rate} a second, expected at least ${LEAST}`);
    assert.deepEqual(page.problems, []);
  } finally {
    await browser.close();
    server.close();
  }
});
