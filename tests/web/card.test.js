// The smallest page.

import assert from "node:assert/strict";
import { test } from "node:test";
import { launch, open, pixels, rendered } from "./browser.js";
import { render } from "./host.js";
import { serve } from "./server.js";

test("the card has the host's pixels", async () => {
  const server = await serve();
  const browser = await launch();
  try {
    const page = await open(browser, `${server.url}/examples/web/card.html`, { viewport: { width: 360, height: 640 } });
    await rendered(page);
    const found = await pixels(page);
    const expected = render("card", "--size", "256x256", "--samples", "64", "--depth", "15");
    assert.ok(found.data.equals(expected.data), "the pixels differ");
    assert.deepEqual(page.problems, []);
  } finally {
    await browser.close();
    server.close();
  }
});
