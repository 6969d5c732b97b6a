// The slider from fast to exact, with a file of settings that were measured, without it, and with a broken one.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { launch, open, pixels, rendered, set } from "./browser.js";
import { render } from "./host.js";
import { FRONTIER, root, sample, serve } from "./server.js";

const { showcase } = JSON.parse(readFileSync(sample, "utf8"));
const folder = mkdtempSync(join(tmpdir(), "whit-web-"));
let browser;

before(async () => {
  browser = await launch();
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true });
});

/** Opens the page beside a file of settings; no such file, and it is missing. */
async function withPage(file, check) {
  const server = await serve({ [FRONTIER]: file });
  const page = await open(browser, `${server.url}/examples/web/`);
  try {
    await page.waitForSelector("#scene:enabled");
    await page.waitForFunction(() => !reason.textContent.includes("loading"));
    await set(page, { width: 96, height: 72 });
    await rendered(page);
    await check(page);
    assert.deepEqual(page.problems, []);
  } finally {
    await page.context().close();
    server.close();
  }
}

const text = (page, id) => page.locator(`#${id}`).textContent();

async function controls(page) {
  const values = {};
  for (const id of ["maths", "depth", "cutoff", "samples", "termination", "fresnel"]) {
    values[id] = await page.locator(`#${id}`).inputValue();
  }
  return values;
}

function expected({ number, depth, cutoff, samples, termination }) {
  const place = ["background", "black", "magenta"].indexOf(termination);
  const values = { maths: number, depth, cutoff, samples, termination: place, fresnel: 0 };
  return Object.fromEntries(Object.entries(values).map(([id, value]) => [id, String(value)]));
}

/** Sees to it that the page is at a setting of the list, and waits for its picture. */
async function assertAt(page, place) {
  const entry = showcase[place];
  assert.deepEqual(await controls(page), expected(entry));
  assert.equal(await text(page, "place"), `${place + 1} of ${showcase.length}`);
  assert.equal(await text(page, "error"), String(entry.error));
  assert.equal(await text(page, "ratio"), `${entry.time} × default`);
  await rendered(page);
  await page.waitForFunction(() => /^\d+ ms$/.test(here.value));
  assert.equal(await text(page, "here"), await text(page, "time"));
  assert.ok(await page.locator("#message").isHidden());
  assert.equal(await page.locator("#quality").getAttribute("aria-valuetext"),
    `${place + 1} of 5: error ${entry.error}, ${entry.time} times as long as by default`);
  return (await pixels(page)).data;
}

test("keys walk the settings from end to end, and each makes its picture", async () => {
  await withPage(sample, async (page) => {
    const slider = page.getByLabel("From fast to exact");
    assert.equal(await text(page, "place"), "custom");
    await slider.focus();
    const pictures = [];
    await page.keyboard.press("Home"); // Where it is already.
    pictures[0] = await assertAt(page, 0);
    for (let place = 1; place < showcase.length; place++) {
      await page.keyboard.press("ArrowRight");
      pictures[place] = await assertAt(page, place);
      assert.ok(!pictures[place].equals(pictures[place - 1]), `${place}: the picture is that before`);
    }
    const host = render("showcase", "--size", "96x72", "--samples", "8", "--depth", "5", "--cutoff", "0");
    assert.ok(pictures[3].equals(host.data), "the pixels differ from the host's");
    await page.keyboard.press("Home");
    assert.ok((await assertAt(page, 0)).equals(pictures[0]));
    await page.keyboard.press("End");
    assert.ok((await assertAt(page, 4)).equals(pictures[4]));
  });
});

test("the mouse moves the slider, and a control of one's own makes it custom", async () => {
  await withPage(sample, async (page) => {
    const slider = page.locator("#quality");
    const { x, y, width, height } = await slider.boundingBox();
    await page.mouse.click(x + width / 2, y + height / 2);
    await assertAt(page, 2);
    for (const [id, value] of Object.entries({ depth: 6, cutoff: 0.1, samples: 64, maths: "f64", termination: 1, fresnel: 1 })) {
      const old = (await controls(page))[id];
      await set(page, { [id]: value });
      await rendered(page);
      assert.equal(await text(page, "place"), "custom", id);
      assert.deepEqual([await text(page, "error"), await text(page, "ratio"), await text(page, "here")], ["–", "–", "–"]);
      assert.equal(await slider.getAttribute("aria-valuetext"), "custom");
      await set(page, { [id]: old });
      await assertAt(page, 2);
    }
    await set(page, { depth: 6 });
    await page.mouse.click(x + width / 2, y + height / 2); // Where it is already.
    await assertAt(page, 2);
    await set(page, { width: 64 }); // It is no part of a setting.
    await assertAt(page, 2);
  });
});

test("another scene has its own settings, or none", async () => {
  await withPage(sample, async (page) => {
    const quality = page.locator("#quality");
    await quality.fill("4");
    await assertAt(page, 4);
    await page.locator("#scene").selectOption({ label: "glass" });
    await rendered(page);
    assert.equal(await quality.getAttribute("max"), "1");
    assert.match(await text(page, "unmeasured"), /^1 of 3 settings left out: number "q16" is not for this page\./);
    assert.ok(await page.locator("#remedy").isHidden());
    await page.locator("#file").setInputFiles(join(root, "tests/data/nff/tetra_s3.nff"));
    await page.waitForFunction(() => scene.value === "file");
    await rendered(page);
    assert.equal((await page.locator("#unmeasured").innerText()).trim(), "Files are not measured.");
    await page.locator("#scene").selectOption({ label: "spheres" });
    await rendered(page);
    assert.ok(await quality.isDisabled());
    assert.match(await text(page, "unmeasured"), /^frontier\.json has no entry for spheres\. To measure and write it:\s+cargo run --release --example accuracy/);
    await page.locator("#scene").selectOption({ label: "showcase" });
    await assertAt(page, 4);
    assert.ok(await page.locator("#unmeasured").isHidden());
  });
});

test("without the file, or with a broken one, the slider is disabled and the page goes on", async () => {
  const broken = join(folder, "broken.json");
  const wrong = join(folder, "wrong.json");
  writeFileSync(broken, '{"showcase": [');
  const entry = showcase[2];
  const changes = [
    { depth: 1.5 }, { depth: 99 }, { cutoff: -1 }, { cutoff: "0" }, { samples: 0 }, { samples: "2x3" }, { termination: "pink" },
    { error: null }, { time: "1" },
  ];
  writeFileSync(wrong, JSON.stringify({ showcase: [...changes.map((change) => ({ ...entry, ...change })), null, 7] }));
  const cases = [
    [join(folder, "none.json"), /^There is no frontier\.json\. To measure and write it:\s+cargo run --release --example accuracy/],
    [broken, /^frontier\.json: .*JSON.*\. To measure and write it:\s+cargo run/],
    [wrong, /^11 of 11 settings left out: depth 1\.5 is not for this page\. To measure/],
  ];
  for (const [file, line] of cases) {
    await withPage(file, async (page) => {
      assert.match(await text(page, "unmeasured"), line);
      assert.ok(await page.locator("#unmeasured").isVisible());
      assert.ok(await page.locator("#quality").isDisabled());
      assert.equal(await text(page, "place"), "–");
      await set(page, { depth: 2 });
      await rendered(page);
      assert.ok(await page.locator("#message").isHidden());
      if (file.endsWith("none.json")) page.problems = page.problems.filter((problem) => !/404|frontier\.json: failed/.test(problem));
    });
  }
});
