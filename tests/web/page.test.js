// The page in a browser: it renders what the host renders, and does what the controls say.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { launch, open, pixels, rendered, set } from "./browser.js";
import { complaint, render } from "./host.js";
import { root, serve } from "./server.js";

const SMALL = { width: 96, height: 72, samples: 1, depth: 8 };
const folder = mkdtempSync(join(tmpdir(), "whit-web-"));
let server, browser;

before(async () => {
  server = await serve();
  browser = await launch();
});

after(async () => {
  await browser?.close();
  server?.close();
  rmSync(folder, { recursive: true });
});

/** Opens the page with a small picture, hands it to `check`, and sees to it that nothing went wrong. */
async function withPage(check, options) {
  const page = await open(browser, `${server.url}/examples/web/`, options);
  try {
    await page.waitForSelector("#scene:enabled");
    await set(page, SMALL);
    await rendered(page);
    await check(page);
    assert.deepEqual(page.problems, []);
  } finally {
    await page.context().close();
  }
}

async function picture(page) {
  await rendered(page);
  return (await pixels(page)).data;
}

function assertSame(found, expected, what) {
  assert.equal(found.width, expected.width, what);
  assert.equal(found.height, expected.height, what);
  assert.ok(found.data.equals(expected.data), `${what}: the pixels differ`);
}

async function openFile(page, name, text) {
  const before = await page.locator("#scene").inputValue();
  const file = { name, mimeType: "text/plain", buffer: Buffer.from(text) };
  await page.locator("#file").setInputFiles(file);
  await page.waitForFunction(
    (before) => !message.hidden || scene.value !== before || scene.value === "file",
    before,
  );
}

test("every built-in scene has the host's pixels", async () => {
  await withPage(async (page) => {
    const names = await page.locator("#scene option").allTextContents();
    assert.ok(names.length >= 14 && names.includes("showcase"), String(names));
    for (const name of names) {
      await page.locator("#scene").selectOption({ label: name });
      await rendered(page);
      assertSame(await pixels(page), render(name, "--size", "96x72", "--samples", "1", "--depth", "8"), name);
    }
  });
});

test("settings do what they do on the host", async () => {
  await withPage(async (page) => {
    await set(page, { width: 75, height: 41, samples: 4, depth: 3, cutoff: 0.05, termination: 2 });
    await rendered(page);
    const options = ["--size", "75x41", "--samples", "4", "--depth", "3", "--cutoff", "0.05", "--termination", "1,0,1"];
    assertSame(await pixels(page), render("showcase", ...options), "showcase");
  });
});

test("each control changes the picture", async () => {
  await withPage(async (page) => {
    const changes = {
      depth: 1, cutoff: 0.3, termination: 2, fresnel: 1, samples: "2x2", maths: "f64", scene: 1, width: 97, height: 71,
    };
    for (const [id, value] of Object.entries(changes)) {
      // Where every control has something to do.
      const usual = { scene: 0, ...SMALL, depth: 2, cutoff: 0.01, termination: 0, fresnel: 0, maths: "f32" };
      await set(page, usual);
      const old = await picture(page);
      await set(page, { [id]: value });
      assert.ok(!(await picture(page)).equals(old), `${id} changed nothing`);
      await set(page, usual);
      assert.ok((await picture(page)).equals(old), `${id} cannot be taken back`);
    }
  });
});

test("mouse, wheel and keys turn the camera", async () => {
  await withPage(async (page) => {
    const home = await picture(page);
    const { x, y, width, height } = await page.locator("canvas").boundingBox();
    const [left, top] = [x + width / 2, y + height / 2];
    const moves = {
      drag: async () => {
        await page.mouse.move(left, top);
        await page.mouse.down();
        await page.mouse.move(left + 60, top + 20, { steps: 4 });
        await page.mouse.up();
      },
      wheel: () => page.mouse.wheel(0, 100),
      ...Object.fromEntries(
        ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "+", "-"].map((key) => [key, () => page.keyboard.press(key)]),
      ),
    };
    await page.locator("canvas").click();
    for (const [name, move] of Object.entries(moves)) {
      await move();
      const moved = await picture(page);
      assert.ok(!moved.equals(home), `${name} changed nothing`);
      await page.keyboard.press("Home");
      assert.ok((await picture(page)).equals(home), `Home did not take back ${name}`);
    }
    await page.keyboard.press("ArrowLeft");
    await rendered(page);
    await page.locator("#home").click();
    assert.ok((await picture(page)).equals(home));
  });
});

test("on a phone all is in reach, and fingers turn and zoom", async () => {
  const phone = { viewport: { width: 360, height: 640 }, deviceScaleFactor: 3, isMobile: true, hasTouch: true };
  await withPage(async (page) => {
    const { scrollWidth, clientWidth } = await page.evaluate(() => document.documentElement);
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(overflow <= 0, `${overflow} pixels too wide (${scrollWidth}, ${clientWidth})`);
    for (const control of await page.locator("#controls select, #controls input, #controls button").all()) {
      await control.scrollIntoViewIfNeeded();
      const { x, width } = await control.boundingBox();
      assert.ok(x >= 0 && x + width <= 360, await control.getAttribute("id"));
    }
    for (const control of await page.locator("select, input[type=number], button, .button, .check").all()) {
      const { height } = await control.boundingBox();
      assert.ok(height >= 44, `${await control.innerText()} is ${height} high`);
    }
    await page.evaluate(() => scrollTo(0, 0));
    const home = await picture(page);
    const { x, y, width, height } = await page.locator("canvas").boundingBox();
    const at = (dx, dy, id = 0) => ({ x: x + width / 2 + dx, y: y + height / 2 + dy, id });
    const touch = await page.context().newCDPSession(page);
    const send = (type, ...touchPoints) => touch.send("Input.dispatchTouchEvent", { type, touchPoints });
    await send("touchStart", at(0, 0));
    for (const step of [10, 20, 40]) await send("touchMove", at(step, 5));
    await send("touchEnd");
    const turned = await picture(page);
    assert.ok(!turned.equals(home), "a finger did not turn");
    await send("touchStart", at(-20, 0), at(20, 0, 1));
    for (const step of [30, 40, 60]) await send("touchMove", at(-step, 0), at(step, 0, 1));
    await send("touchEnd");
    assert.ok(!(await picture(page)).equals(turned), "two fingers did not zoom");
    assert.equal(await page.evaluate(() => scrollY), 0, "the page scrolled");
  }, phone);
});

test("scene files are read, by the button and by dropping", async () => {
  await withPage(async (page) => {
    for (const name of ["balls_s2", "every_entity", "gears_s1", "keyhole", "mount_s4", "rings_s1", "teapot_s1", "tetra_s3", "tree_s2"]) {
      const path = `tests/data/nff/${name}.nff`;
      await openFile(page, `${name}.nff`, readFileSync(join(root, path)));
      await page.waitForFunction((name) => scene.selectedOptions[0].text === name, `${name}.nff`);
      await rendered(page);
      assertSame(await pixels(page), render(path, "--size", "96x72", "--samples", "1", "--depth", "8"), name);
    }
    await page.evaluate(async (text) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([text], "dropped.nff"));
      document.body.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
    }, readFileSync(join(root, "tests/data/nff/balls_s1.nff"), "utf8"));
    await page.waitForFunction(() => scene.selectedOptions[0].text === "dropped.nff");
    const expected = render("tests/data/nff/balls_s1.nff", "--size", "96x72", "--samples", "1", "--depth", "8");
    await rendered(page);
    assertSame(await pixels(page), expected, "dropped");
    await set(page, { maths: "f64" }); // It takes the same records.
    assert.ok(!(await picture(page)).equals(Buffer.alloc(expected.data.length)));
  });
});

test("a broken scene file is refused in the library's words, and the old picture stays", async () => {
  await withPage(async (page) => {
    const old = await picture(page);
    const good = readFileSync(join(root, "tests/data/nff/balls_s1.nff"), "utf8");
    const broken = {
      word: good.replace(/^s .*$/m, "s 0 0 abc 1"),
      short: good.replace(/^s .*$/m, "s 0 0 0"),
      range: good.replace(/^angle .*$/m, "angle 200"),
      end: good.slice(0, 60),
      empty: "",
      bytes: Buffer.from([0x76, 0x0a, 0xff, 0xfe]),
      entity: `${good}\nteapot\n`,
    };
    for (const [name, text] of Object.entries(broken)) {
      const path = join(folder, `${name}.nff`);
      writeFileSync(path, text);
      await openFile(page, `${name}.nff`, text);
      const expected = `${name}.nff: ${complaint(path)}`;
      assert.match(expected, /line \d+: /);
      await page.waitForFunction((text) => message.textContent === text, expected, { timeout: 5000 }).catch(() => {});
      assert.equal(await page.locator("#message").textContent(), expected);
      assert.ok((await picture(page)).equals(old), `${name}: the picture changed`);
    }
    await openFile(page, "large.nff", "#".repeat(600_000));
    await page.waitForFunction(() => message.textContent.startsWith("large.nff"));
    assert.match(await page.locator("#message").textContent(), /600000 bytes, but there is room for 524288/);
    await openFile(page, "many.nff", `${good}${"s 0 0 0 1\n".repeat(5000)}`);
    await page.waitForFunction(() => message.textContent.startsWith("many.nff"));
    assert.match(await page.locator("#message").textContent(), /line \d+: 50\d\d objects, but there is room for 4096/);
    assert.equal(await page.locator("#scene").inputValue(), "0");
    assert.ok((await picture(page)).equals(old));
    await set(page, { depth: 2 }); // All goes on.
    await rendered(page);
    assert.ok(await page.locator("#message").isHidden());
  });
});

test("settings that cannot be are refused, and the old picture stays", async () => {
  await withPage(async (page) => {
    const old = await picture(page);
    const wrong = [
      ["width", 0, "size: expected 1 to 1048576 pixels a side"],
      ["height", 19200, "size: there is room for 307200 pixels"],
      ["width", "", "width: expected a whole number of at least 0"],
      ["depth", 40, "depth 40: the tracer's stack has room for 34"],
      ["depth", 1.5, "depth: expected a whole number of at least 0"],
      ["cutoff", -1, "cutoff: expected a number of at least 0"],
      ["cutoff", "1e39", "cutoff: expected a finite number of at least 0"],
    ];
    for (const [id, value, expected] of wrong) {
      const usual = await page.locator(`#${id}`).inputValue();
      await set(page, { [id]: value });
      await page.waitForFunction((text) => message.textContent === text, expected);
      assert.ok((await picture(page)).equals(old), `${id} ${value}: the picture changed`);
      await set(page, { [id]: usual });
      await page.waitForSelector("#message", { state: "hidden" });
    }
  });
});

test("a scene that fixed point refuses is told in the library's words, and all goes on", async () => {
  await withPage(async (page) => {
    const told = (text) => page.waitForFunction((text) => message.textContent === text, text);
    const choose = (label) => page.locator("#scene").selectOption({ label });
    await set(page, { maths: "q20" });
    const old = await picture(page);
    const refused = {
      window: "object 2: min: expected a number from -64 to 64",
      mirage: "scene: profiles: expected nothing that bends light, in fixed point",
      hole: "scene: black_hole: expected nothing that bends light, in fixed point",
    };
    for (const [name, text] of Object.entries(refused)) {
      await choose(name);
      await told(text);
      assert.ok((await picture(page)).equals(old), `${name}: the picture changed`);
      await page.locator("canvas").press("ArrowLeft");
      await set(page, { depth: 3 });
      await told(text);
      assert.ok((await picture(page)).equals(old));
      await set(page, { depth: SMALL.depth, maths: "f32" });
      await page.waitForSelector("#message", { state: "hidden" });
      await page.locator("#home").click();
      await rendered(page);
      assertSame(await pixels(page), render(name, "--size", "96x72", "--samples", "1", "--depth", "8"), name);
      await choose("showcase");
      await set(page, { maths: "q20" });
      assert.ok((await picture(page)).equals(old), `${name}: it cannot be taken back`);
    }
    await set(page, { width: 2000, height: 10 });
    await told("size: expected 1 to 1023 pixels a side");
    await set(page, { ...SMALL, scene: 4 }); // A scene with a lens, and a light that is a square.
    await rendered(page);
    const now = await picture(page);
    await choose("hole"); // Fixed point refuses it, and then the scene before is asked for again.
    await told(refused.hole);
    await choose("card");
    assert.ok((await picture(page)).equals(now));
  });
});

test("the error is that against the reference setting", async () => {
  await withPage(async (page) => {
    const error = async () => {
      await rendered(page);
      await page.waitForFunction(() => off.value.includes("%"));
      return { rmse: Number(await page.locator("#rmse").textContent()), off: parseFloat(await page.locator("#off").textContent()) };
    };
    await set(page, { scene: 1, width: 48, height: 36 });
    const one = await error();
    assert.ok(one.rmse > 0 && one.off > 0 && one.off < 100, JSON.stringify(one));
    await set(page, { samples: 16, depth: 12, cutoff: 0 });
    const same = await error();
    assert.ok(same.rmse < one.rmse / 10, `${JSON.stringify(same)} after ${JSON.stringify(one)}`);
    await set(page, { maths: "f64" });
    assert.deepEqual(await error(), { rmse: 0, off: 0 });
    await page.locator("#compare").uncheck();
    assert.equal(await page.locator("#rmse").textContent(), "–");
  });
});

test("the page answers while it renders", async () => {
  await withPage(async (page) => {
    await set(page, { width: 640, height: 480, samples: 16 });
    const gaps = await page.evaluate(async () => {
      const times = [];
      for (let i = 0; i < 60; i++) times.push(await new Promise(requestAnimationFrame));
      return times.slice(1).map((time, i) => time - times[i]).sort((a, b) => a - b);
    });
    assert.equal(await page.locator("canvas").getAttribute("aria-busy"), "true");
    assert.ok(gaps[Math.floor(gaps.length * 0.9)] < 100, `milliseconds between frames: ${gaps}`);
    assert.ok(Number(await page.locator("#progress").getAttribute("value")) < 1);
    await set(page, SMALL); // It does not have to be waited for.
    await rendered(page);
  });
});

test("a module that is not there is named, and the page goes on", async () => {
  const page = await open(browser, `${server.url}/examples/web/`);
  await page.route("**/web_f64.wasm", (route) => route.fulfill({ status: 404 }));
  await set(page, { ...SMALL, maths: "f64" });
  await page.waitForSelector("#message:not([hidden])");
  assert.match(await page.locator("#message").textContent(), /web_f64\.wasm: 404/);
  await set(page, { maths: "f32" });
  await rendered(page);
  await page.context().close();
});
