// Frames a second of 320x240 pixels with 1 sample in headless Chromium, by builds of the page's module `web`: of each the
// median while the camera goes around, and the ratio to the first build. `alone` is what is rendered without a pause, `page`
// what the page completes when a key turns the camera as soon as the picture before is done.
//
//     node tests/web/frames.js MODULE.wasm...

import { resolve } from "node:path";
import { launch, open, rendered, set } from "./browser.js";
import { MODULES, serve } from "./server.js";

const SCENES = ["showcase", "card", "flake"];
const ROUNDS = 16;
const FRAMES = 4;
const SETTINGS = {
  width: 320, height: 240, samples: 1, isGrid: false, depth: 8, cutoff: 1 / 255, termination: 0, fresnel: 0,
};

/** Milliseconds of frames one after the other, each rendered without a pause and put on a canvas, after so many turns. */
async function renderAlone([scene, turns, frames, settings]) {
  const names = ["job", "orbit", "renderer"];
  const [{ Job }, { Orbit }, { Renderer }] = await Promise.all(names.map((name) => import(`/examples/web/${name}.js`)));
  window.renderer ??= await Renderer.load("f32");
  const { renderer } = window;
  const canvas = Object.assign(document.createElement("canvas"), { width: settings.width, height: settings.height });
  const context = canvas.getContext("2d", { alpha: false });
  const orbit = new Orbit(canvas, () => {});
  orbit.home = renderer.open({ index: renderer.sceneNames().indexOf(scene) });
  const turn = () => canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" }));
  for (let i = 0; i < turns; i++) turn();
  return Array.from({ length: frames }, () => {
    turn();
    const begin = performance.now();
    new Job(renderer, orbit.pose, settings).work(Infinity);
    context.putImageData(renderer.image, 0, 0);
    return performance.now() - begin;
  });
}

/** Milliseconds from a key that turns the camera to the complete picture, for one key after the other. */
function renderOnPage(frames) {
  const canvas = document.querySelector("canvas");
  const isDone = () => canvas.getAttribute("aria-busy") === "false";
  const complete = () => new Promise((resolve) => {
    const observer = new MutationObserver(() => isDone() && (observer.disconnect(), resolve()));
    observer.observe(canvas, { attributeFilter: ["aria-busy"] });
  });
  const turn = async (times) => {
    if (times.length === frames) return times;
    const begin = performance.now();
    const done = complete();
    canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft", cancelable: true }));
    await done;
    return turn([...times, performance.now() - begin]);
  };
  return turn([]);
}

async function prepare(page, scene) {
  await page.waitForSelector("#scene:enabled");
  await page.locator("#compare").uncheck();
  const { width, height, samples, depth } = SETTINGS;
  const index = await page.evaluate((name) => [...document.querySelector("#scene").options].findIndex((o) => o.text === name), scene);
  await set(page, { scene: index, width, height, samples, depth });
  await rendered(page);
}

const median = (numbers) => numbers.sort((a, b) => a - b)[numbers.length >> 1];

function print(name, times) {
  const rates = times.map((all) => 1000 / median(all));
  console.log(name, ...rates.map((rate) => `${rate.toFixed(1)} (${(rate / rates[0]).toFixed(2)})`));
}

const browser = await launch();
const servers = await Promise.all(process.argv.slice(2).map((file) => serve({ [`${MODULES}/web.wasm`]: resolve(file) })));
const pages = [];
for (const server of servers) pages.push(await open(browser, `${server.url}/examples/web/`));
for (const scene of SCENES) {
  for (const page of pages) await prepare(page, scene);
  const [alone, onPage] = [pages.map(() => []), pages.map(() => [])];
  for (let round = 0; round < ROUNDS; round++) {
    for (const [i, page] of pages.entries()) {
      alone[i].push(...(await page.evaluate(renderAlone, [scene, FRAMES * round, FRAMES, SETTINGS])));
      onPage[i].push(...(await page.evaluate(renderOnPage, FRAMES)));
    }
  }
  print(`${scene}, alone:`, alone);
  print(`${scene}, page:`, onPage);
}
await browser.close();
for (const server of servers) server.close();
