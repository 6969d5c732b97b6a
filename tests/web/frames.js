// Frames a second of 320x240 pixels with 1 sample in headless Chromium, by builds of the page's module `web`: of each the
// median while the camera goes around, and the ratio to the first build.
//
//     node tests/web/frames.js MODULE.wasm...

import { resolve } from "node:path";
import { launch, open } from "./browser.js";
import { MODULES, serve } from "./server.js";

const SCENES = ["showcase", "card", "flake"];
const ROUNDS = 8;
const FRAMES = 4;
const SETTINGS = {
  width: 320, height: 240, samples: 1, isGrid: false, depth: 8, cutoff: 1 / 255, termination: 0, fresnel: 0,
};

/** Milliseconds of frames one after the other, each rendered without a pause and put on a canvas, after so many turns. */
async function measure([scene, turns, frames, settings]) {
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

const median = (numbers) => numbers.sort((a, b) => a - b)[numbers.length >> 1];

const browser = await launch();
const servers = await Promise.all(process.argv.slice(2).map((file) => serve({ [`${MODULES}/web.wasm`]: resolve(file) })));
const pages = [];
for (const server of servers) pages.push(await open(browser, `${server.url}/examples/web/card.html`));
for (const scene of SCENES) {
  const times = pages.map(() => []);
  for (let round = 0; round < ROUNDS; round++) {
    for (const [i, page] of pages.entries()) {
      times[i].push(...(await page.evaluate(measure, [scene, FRAMES * round, FRAMES, SETTINGS])));
    }
  }
  const rates = times.map((all) => 1000 / median(all));
  console.log(scene, ...rates.map((rate) => `${rate.toFixed(1)} (${(rate / rates[0]).toFixed(2)})`));
}
await browser.close();
for (const server of servers) server.close();
