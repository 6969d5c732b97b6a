// The camera goes around its target: by mouse, touch and keyboard.

const STEP = Math.PI / 36;
const ZOOM_STEP = 1.1;
/** Just short of straight above and below, where up would be the line of sight. */
const STEEPEST = (89 * Math.PI) / 180;

export class Orbit {
  #home = new Float32Array(10);
  #yaw = 0;
  #pitch = 0;
  #zoom = 1;
  #pointers = new Map();
  #changed;

  constructor(canvas, changed) {
    this.canvas = canvas;
    this.#changed = changed;
    canvas.addEventListener("pointerdown", (event) => this.#down(event));
    canvas.addEventListener("pointermove", (event) => this.#move(event));
    for (const type of ["pointerup", "pointercancel"]) {
      canvas.addEventListener(type, (event) => this.#pointers.delete(event.pointerId));
    }
    canvas.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
    canvas.addEventListener("keydown", (event) => this.#key(event));
  }

  /** Starts from a scene's own pose. */
  set home(pose) {
    this.#home = pose;
    this.reset();
  }

  reset() {
    [this.#yaw, this.#pitch, this.#zoom] = [0, 0, 1];
  }

  /** Eye, target, up, distance in focus. Where nothing was turned, it is the scene's own to the last bit. */
  get pose() {
    if (this.#yaw === 0 && this.#pitch === 0 && this.#zoom === 1) return this.#home;
    const [eye, target, up] = [0, 3, 6].map((i) => [...this.#home.slice(i, i + 3)]);
    const axis = scaled(up, 1 / length(up));
    const offset = eye.map((x, i) => x - target[i]);
    const distance = length(offset);
    const height = dot(offset, axis);
    const flat = offset.map((x, i) => x - axis[i] * height);
    const ahead = scaled(flat, 1 / length(flat));
    const aside = cross(axis, ahead);
    const elevation = clamp(Math.asin(clamp(height / distance, 1)) + this.#pitch, STEEPEST);
    const [across, upwards] = [Math.cos(elevation), Math.sin(elevation)];
    const [a, b] = [across * Math.cos(this.#yaw), across * Math.sin(this.#yaw)];
    const moved = target.map(
      (x, i) => x + distance * this.#zoom * (a * ahead[i] + b * aside[i] + upwards * axis[i]),
    );
    return Float32Array.of(...moved, ...target, ...axis, this.#home[9] * this.#zoom);
  }

  #turn(yaw, pitch) {
    this.#yaw += yaw;
    this.#pitch = clamp(this.#pitch + pitch, 2 * STEEPEST);
    this.#changed();
  }

  #scale(factor) {
    this.#zoom = Math.min(Math.max(this.#zoom * factor, 0.05), 20);
    this.#changed();
  }

  #down(event) {
    if (event.button !== 0) return;
    this.canvas.setPointerCapture(event.pointerId);
    this.#pointers.set(event.pointerId, [event.clientX, event.clientY]);
  }

  #move(event) {
    const last = this.#pointers.get(event.pointerId);
    if (!last) return;
    const before = this.#spread();
    this.#pointers.set(event.pointerId, [event.clientX, event.clientY]);
    if (this.#pointers.size === 1) {
      const unit = Math.PI / this.canvas.clientWidth;
      this.#turn((last[0] - event.clientX) * unit, (event.clientY - last[1]) * unit);
    } else if (before > 0) {
      this.#scale(before / Math.max(this.#spread(), 1));
    }
  }

  /** How far apart the first two fingers are. */
  #spread() {
    const [a, b] = this.#pointers.values();
    return b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 0;
  }

  /** Unless it has been clicked, the wheel scrolls the page. */
  #wheel(event) {
    if (document.activeElement !== this.canvas && !event.ctrlKey) return;
    event.preventDefault();
    this.#scale(event.deltaY > 0 ? ZOOM_STEP : 1 / ZOOM_STEP);
  }

  #key(event) {
    const actions = {
      ArrowLeft: () => this.#turn(-STEP, 0),
      ArrowRight: () => this.#turn(STEP, 0),
      ArrowUp: () => this.#turn(0, STEP),
      ArrowDown: () => this.#turn(0, -STEP),
      "+": () => this.#scale(1 / ZOOM_STEP),
      "=": () => this.#scale(1 / ZOOM_STEP),
      "-": () => this.#scale(ZOOM_STEP),
      Home: () => (this.reset(), this.#changed()),
    };
    if (event.ctrlKey || event.altKey || event.metaKey || !actions[event.key]) return;
    event.preventDefault();
    actions[event.key]();
  }
}

const clamp = (x, most) => Math.min(Math.max(x, -most), most);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const length = (a) => Math.hypot(...a);
const scaled = (a, factor) => a.map((x) => x * factor);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
