// Work in short slices, each a task of its own: what the browser has to do comes in between, and when there is nothing, the
// next slice begins at once.

/** Milliseconds of a slice. */
const SLICE = 8;

export class Slices {
  /** `work` is called with the milliseconds that it may take. */
  constructor(work) {
    this.channel = new MessageChannel(); // Other than timers, messages are not put off.
    this.isAsked = false;
    this.channel.port1.onmessage = () => {
      this.isAsked = false;
      work(SLICE);
    };
  }

  /** Asks for one slice, soon. */
  ask() {
    if (this.isAsked) return;
    this.isAsked = true;
    this.channel.port2.postMessage(null);
  }
}
