// The number types and the samples of the modules, without a page.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { modules } from "./server.js";

const SIZE = [96, 72];
/** What fixed point refuses, and why. */
const BENT = "expected nothing that bends light, in fixed point";
const REFUSED = {
  window: "object 2: min: expected a number from -64 to 64",
  mirage: `scene: profiles: ${BENT}`,
  ship: `scene: profiles: ${BENT}`,
  sunset: `scene: profiles: ${BENT}`,
  lenses: `scene: profiles: ${BENT}`,
  hole: `scene: black_hole: ${BENT}`,
};

async function load(name) {
  return (await WebAssembly.instantiate(readFileSync(join(modules, `${name}.wasm`)))).instance.exports;
}

const said = (module, length) => Buffer.from(module.memory.buffer, module.text(), length).toString();

function names(module) {
  const names = [];
  for (let length; (length = module.scene_name(names.length)); ) names.push(said(module, length));
  return names;
}

/** The values of a picture, or why there is none. */
function values(module, scene, { size: [width, height] = SIZE, samples = 1, isGrid = false } = {}) {
  module.open_scene(names(module).indexOf(scene));
  const problem = said(module, module.start(width, height, samples, isGrid, 8, 0, 0, 0));
  if (problem) return problem;
  while (module.step(100_000) > 0);
  return new Float32Array(module.memory.buffer, module.values(), width * height * 3).slice();
}

function rmse(a, b) {
  return Math.sqrt(a.reduce((sum, x, i) => sum + (x - b[i]) ** 2, 0) / a.length);
}

test("every scene is nearly the same in every number type, or refused in the library's words", async () => {
  const exact = await load("web_f64");
  const limits = { web: 0.005, web_fast: 0.005, web_q20: 0.05 };
  for (const [name, limit] of Object.entries(limits)) {
    const module = await load(name);
    const refused = {};
    for (const scene of names(module)) {
      const found = values(module, scene);
      if (typeof found === "string") {
        refused[scene] = found;
        continue;
      }
      const error = rmse(found, values(exact, scene));
      assert.ok(error <= limit, `${name} ${scene}: RMSE ${error}`);
    }
    assert.deepEqual(refused, name === "web_q20" ? REFUSED : {}, name);
  }
});

test("a grid of samples is the mean of a picture with that many more pixels", async () => {
  const module = await load("web");
  const [width, height] = SIZE;
  const found = values(module, "spheres", { samples: 2, isGrid: true });
  const large = values(module, "spheres", { size: [2 * width, 2 * height] });
  const mean = found.map((_, i) => {
    const [channel, x, y] = [i % 3, Math.floor(i / 3) % width, Math.floor(i / 3 / width)];
    const at = (dx, dy) => large[((2 * y + dy) * 2 * width + 2 * x + dx) * 3 + channel];
    return (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)) / 4;
  });
  assert.ok(rmse(found, mean) < 1e-3, `RMSE ${rmse(found, mean)}`);
  assert.ok(rmse(found, values(module, "spheres", { samples: 4 })) > 1e-3);
  assert.match(values(module, "spheres", { samples: 0, isGrid: true }), /samples: expected at least 1/);
});
