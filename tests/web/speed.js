// How large modules of the page are, and how fast: nanoseconds of processor time a ray, and the ratio to the first module.
//
//     node tests/web/speed.js MODULE.wasm...

import { readFileSync, statSync } from "node:fs";

const SCENES = ["showcase", "card", "glass", "bubble"];

async function instance(file) {
  const { instance } = await WebAssembly.instantiate(readFileSync(file));
  return instance.exports;
}

function names(module) {
  const names = [];
  for (let length; (length = module.scene_name(names.length)); ) {
    names.push(Buffer.from(module.memory.buffer, module.text(), length).toString());
  }
  return names;
}

function nanoseconds(module, scene) {
  module.open_scene(names(module).indexOf(scene));
  const begin = process.cpuUsage().user;
  module.start(160, 120, 4, false, 8, 0, 0, 0);
  while (module.step(100_000) > 0);
  return ((process.cpuUsage().user - begin) * 1000) / module.rays();
}

const files = process.argv.slice(2);
for (const file of files) console.log(`${file}: ${statSync(file).size} bytes`);
const modules = await Promise.all(files.map(instance));
for (const scene of SCENES) {
  // The best of three, each after the others' turn.
  const best = modules.map(() => Infinity);
  for (let round = 0; round < 3; round++) {
    modules.forEach((module, i) => (best[i] = Math.min(best[i], nanoseconds(module, scene))));
  }
  console.log(scene, ...best.map((time) => `${time.toFixed(0)} ns (${(time / best[0]).toFixed(2)})`));
}
