// A picture in the making.

/** So few that one step is far shorter than a slice of time. */
const RAYS = 1000;

export class Job {
  /** Of a setting that was measured, there is an `entry`. */
  constructor(renderer, pose, wishes, entry = null) {
    renderer.start(pose, wishes);
    this.renderer = renderer;
    this.pose = [...pose];
    this.wishes = wishes;
    this.entry = entry;
    this.pixels = this.left = wishes.width * wishes.height;
    // Every 8th pixel of every 8th row comes first; from then on, the picture covers its size.
    this.coarse = Math.ceil(wishes.width / 8) * Math.ceil(wishes.height / 8);
    this.milliseconds = 0;
  }

  get isDone() {
    return this.left === 0;
  }

  /** Whether there is something to show. */
  get isVisible() {
    return this.pixels - this.left >= this.coarse;
  }

  /** Goes on until it is done or the time is over. */
  work(milliseconds) {
    const start = performance.now();
    let now = start;
    while (this.left > 0 && now - start < milliseconds) {
      this.left = this.renderer.step(RAYS);
      now = performance.now();
    }
    this.milliseconds += now - start;
  }
}

/** How far two pictures differ: root of the mean square, and the share of pixels with a channel off by over 1/255. */
export function difference(values, reference) {
  let sum = 0;
  let off = 0;
  for (let i = 0; i < values.length; i += 3) {
    let largest = 0;
    for (let k = i; k < i + 3; k++) {
      const error = Math.abs(values[k] - reference[k]);
      sum += error * error;
      largest = Math.max(largest, error);
    }
    if (largest > 1 / 255) off++;
  }
  return { rmse: Math.sqrt(sum / values.length), off: (off * 3) / values.length };
}
