// Headless Chromium, and what the tests do with the page.

import { existsSync } from "node:fs";
import { chromium } from "playwright-core";

const executablePath = process.env.CHROMIUM || ["/usr/bin/chromium", "/usr/bin/google-chrome"].find(existsSync);

export async function launch() {
  if (!executablePath) throw new Error("there is no Chromium: set CHROMIUM to its path");
  const quiet = ["quic", "background-networking", "component-update", "sync"].map((name) => `--disable-${name}`);
  const args = ["--no-sandbox", "--disable-gpu", "--no-first-run", ...quiet];
  return chromium.launch({ executablePath, args });
}

/** A page, with everything that went wrong in it in `page.problems`. */
export async function open(browser, url, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(60_000);
  page.problems = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) page.problems.push(message.text());
  });
  page.on("pageerror", (error) => page.problems.push(String(error)));
  page.on("requestfailed", (request) => page.problems.push(`${request.url()}: failed`));
  page.on("response", (response) => {
    if (response.status() >= 400) page.problems.push(`${response.url()}: ${response.status()}`);
  });
  await page.goto(url);
  return page;
}

/** Waits until the picture is complete. */
export async function rendered(page) {
  await page.waitForSelector("canvas[aria-busy=false]");
}

/** The bytes of the canvas: red, green, blue and alpha of each pixel. */
export async function pixels(page) {
  const { width, height, text } = await page.evaluate(() => {
    const canvas = document.querySelector("canvas");
    const { width, height } = canvas;
    const { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
    let text = "";
    for (let i = 0; i < data.length; i += 8192) text += String.fromCharCode(...data.subarray(i, i + 8192));
    return { width, height, text: btoa(text) };
  });
  return { width, height, data: Buffer.from(text, "base64") };
}

/** Sets controls as a user would, and waits for the picture. */
export async function set(page, values) {
  for (const [id, value] of Object.entries(values)) {
    const control = page.locator(`#${id}`);
    if ((await control.evaluate((e) => e.tagName)) === "SELECT") {
      await control.selectOption(String(value));
    } else {
      await control.fill(String(value));
      await control.blur();
    }
  }
}
