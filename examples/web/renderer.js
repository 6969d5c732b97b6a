// The modules of the page, as classes. Each instance has its own memory, which never moves.

const folder = new URL(document.documentElement.dataset.modules, document.baseURI);
const modules = new Map();

function compiled(name) {
  if (!modules.has(name)) {
    const module = fetchModule(name);
    modules.set(name, module);
    module.catch(() => modules.delete(name)); // To be tried again.
  }
  return modules.get(name);
}

async function fetchModule(name) {
  const url = new URL(`${name}.wasm`, folder);
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url.pathname}: ${response.status} ${response.statusText}; was it built?`);
  return WebAssembly.compile(await response.arrayBuffer());
}

async function exportsOf(name) {
  return (await WebAssembly.instantiate(await compiled(name))).exports;
}

/** What is written at `text`, or null when there is nothing. */
function textOf(module, length) {
  return length ? new TextDecoder().decode(new Uint8Array(module.memory.buffer, module.text(), length)) : null;
}

/** Reads scene files. */
export class Reader {
  static async load() {
    return Object.assign(new Reader(), { module: await exportsOf("web_nff") });
  }

  /** The records of a file, which any renderer takes; an error says which line is wrong. */
  read(bytes) {
    const { module } = this;
    if (bytes.length > module.file_capacity()) {
      throw new Error(`${bytes.length} bytes, but there is room for ${module.file_capacity()}`);
    }
    new Uint8Array(module.memory.buffer).set(bytes, module.file());
    const problem = textOf(module, module.read_file(bytes.length));
    if (problem) throw new Error(problem);
    return new Uint8Array(module.memory.buffer, module.records(), module.records_length()).slice();
  }
}

/** Renders one picture at a time. */
export class Renderer {
  /** For a number type: "f32", or what is after `web_` in the name of a module. */
  static async load(maths) {
    const module = await exportsOf(maths === "f32" ? "web" : `web_${maths}`);
    return Object.assign(new Renderer(), { module, scene: null, size: null });
  }

  /** The names of the built-in scenes. */
  sceneNames() {
    const names = [];
    for (let name; (name = textOf(this.module, this.module.scene_name(names.length))); ) names.push(name);
    return names;
  }

  /** Opens `{ index }` of a built-in scene, or `{ records }` of a file; gives the scene's own pose. */
  open(scene) {
    const { module } = this;
    if (scene.records) {
      new Uint8Array(module.memory.buffer).set(scene.records, module.file());
      module.open_file(scene.records.length);
    } else {
      module.open_scene(scene.index);
    }
    this.scene = scene;
    return this.#pose().slice();
  }

  /** Begins a picture. After an error the one before goes on. */
  start(pose, { width, height, samples, isGrid, depth, cutoff, termination, fresnel }) {
    this.#pose().set(pose);
    const length = this.module.start(width, height, samples, isGrid, depth, cutoff, termination, fresnel);
    const problem = textOf(this.module, length);
    if (problem) throw new Error(problem);
    this.size = { width, height };
  }

  /** Traces about so many rays more and gives the number of pixels that are left. */
  step(rays) {
    return this.module.step(rays);
  }

  get rays() {
    return this.module.rays() >>> 0;
  }

  get image() {
    const { width, height } = this.size;
    const bytes = new Uint8ClampedArray(this.module.memory.buffer, this.module.pixels(), width * height * 4);
    return new ImageData(bytes, width, height);
  }

  /** Linear light: red, green and blue of each pixel. */
  get values() {
    const { width, height } = this.size;
    return new Float32Array(this.module.memory.buffer, this.module.values(), width * height * 3);
  }

  #pose() {
    return new Float32Array(this.module.memory.buffer, this.module.pose(), 10);
  }
}
