// The pictures that the library makes on this machine, by the tool that renders to files.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import pngjs from "pngjs";
import { root } from "./server.js";

const target = process.env.CARGO_TARGET_DIR || join(root, "target");
const tool = join(target, "release/examples/render");

/** Width, height and the bytes of red, green, blue and alpha. */
export function render(scene, ...options) {
  const folder = mkdtempSync(join(tmpdir(), "whit-web-"));
  try {
    const file = join(folder, "picture.png");
    execFileSync(tool, [scene, "-o", file, ...options], { cwd: root, stdio: "pipe" });
    return pngjs.PNG.sync.read(readFileSync(file));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** What the tool says is wrong with a scene file. */
export function complaint(file) {
  try {
    render(file);
  } catch (error) {
    return error.stderr.toString().trim().replace(`render: ${file}: `, "");
  }
  throw new Error(`${file}: expected an error`);
}
