// A slider from fast to exact: the settings of a scene that are worth their time, and what was measured of them.

const FILE = "frontier.json";

/** Sets the controls of the page and follows them: where they are at none of the settings, they are custom. */
export class Tuning {
  #element;
  #changed;
  #scene = null;
  #measured = null; // By scene, or null until the file is there.
  #problem = `${FILE} is loading.`;
  #entries = [];

  /** The setting that the controls are at, or null. */
  entry = null;

  constructor(element, changed) {
    this.#element = element;
    this.#changed = changed;
    const { quality } = element;
    quality.addEventListener("input", () => this.#choose());
    // Where the controls are custom, the slider can be used without being moved.
    const isKey = /^(Arrow|Home|End|Page)/;
    quality.addEventListener("keyup", (event) => isKey.test(event.key) && this.#take());
    quality.addEventListener("pointerup", () => this.#take());
  }

  async load() {
    try {
      const response = await fetch(new URL(FILE, document.baseURI));
      if (!response.ok) throw new Error(`There is no ${FILE}.`);
      const measured = await response.json();
      if (measured === null || typeof measured !== "object") throw new Error(`${FILE}: expected an object.`);
      this.#measured = measured;
    } catch (error) {
      this.#problem = error instanceof SyntaxError ? `${FILE}: ${error.message}.` : error.message;
    }
    if (this.#scene) this.open(this.#scene);
  }

  /** Takes the settings of a scene. */
  open(scene) {
    this.#scene = scene;
    const { quality, measured, unmeasured, reason, remedy } = this.#element;
    const all = this.#all();
    const problems = all.map((entry) => this.#problemOf(entry));
    this.#entries = all.filter((_, i) => problems[i] === null);
    const left = all.length - this.#entries.length;
    const first = problems.find((problem) => problem !== null);
    const leftOut = left > 0 ? `${left} of ${all.length} settings left out: ${first}.` : "";
    const isEmpty = this.#entries.length === 0;
    reason.textContent = leftOut || this.#lack();
    unmeasured.hidden = !isEmpty && left === 0;
    remedy.hidden = !isEmpty || Boolean(scene.records);
    measured.hidden = quality.disabled = isEmpty;
    quality.max = Math.max(this.#entries.length - 1, 0);
    this.follow();
  }

  /** Finds the setting that the controls are at. */
  follow() {
    const { quality } = this.#element;
    const place = this.#entries.findIndex((entry) => this.#isAt(entry));
    this.entry = this.#entries[place] ?? null;
    if (this.entry) quality.value = place;
    quality.classList.toggle("custom", this.entry === null);
    this.#tell();
    this.show(null);
  }

  /** Tells how long a picture took, when it is done and at the setting. */
  show(job) {
    const isIts = this.entry !== null && job?.entry === this.entry && job.isDone;
    this.#element.here.value = isIts ? `${job.milliseconds.toFixed(0)} ms` : "–";
  }

  #take() {
    if (!this.entry) this.#choose();
  }

  /** Sets the controls as the slider says. */
  #choose() {
    const entry = this.#entries[this.#element.quality.valueAsNumber];
    if (!entry) return;
    for (const [id, value] of Object.entries(this.#values(entry))) {
      const control = this.#element[id];
      control.value = value;
      if (control.value === value) continue;
      control.append(new Option(value, value)); // A number of samples that is not in the list.
      control.value = value;
    }
    this.#changed();
  }

  /** Why there are no settings. */
  #lack() {
    const { name, records } = this.#scene;
    if (records) return "Files are not measured.";
    return this.#measured ? `${FILE} has no entry for ${name}.` : this.#problem;
  }

  #all() {
    const { name, records } = this.#scene;
    const isThere = !records && this.#measured && Object.hasOwn(this.#measured, name);
    return isThere && Array.isArray(this.#measured[name]) ? this.#measured[name] : [];
  }

  #values({ number, depth, cutoff, samples, termination }) {
    return {
      maths: number,
      depth: String(depth),
      cutoff: String(cutoff),
      samples: String(samples),
      termination: this.#terminations().get(termination),
      fresnel: "0",
    };
  }

  #terminations() {
    return new Map([...this.#element.termination.options].map(({ text, value }) => [text, value]));
  }

  #isAt(entry) {
    return Object.entries(this.#values(entry)).every(([id, value]) => {
      const control = this.#element[id];
      return control.type === "number" ? control.valueAsNumber === Number(value) : control.value === value;
    });
  }

  /** Why the page cannot be set so, or null. */
  #problemOf(entry) {
    const numbers = [...this.#element.maths.options].map(({ value }) => value);
    const isAmount = (value) => Number.isFinite(value) && value >= 0;
    const { depth, samples } = entry ?? {};
    const isOne = {
      number: numbers.includes(entry?.number),
      depth: Number.isInteger(depth) && depth >= 0 && depth <= Number(this.#element.depth.max),
      cutoff: isAmount(entry?.cutoff),
      samples: (Number.isInteger(samples) && samples > 0) || /^([1-9]\d*)x\1$/.test(samples),
      termination: this.#terminations().has(entry?.termination),
      error: isAmount(entry?.error),
      time: isAmount(entry?.time),
    };
    const wrong = Object.keys(isOne).find((key) => !isOne[key]);
    return wrong === undefined ? null : `${wrong} ${JSON.stringify(entry?.[wrong])} is not for this page`;
  }

  #tell() {
    const { quality, place, error, ratio } = this.#element;
    const isThere = this.entry !== null;
    const [rmse, times] = isThere ? [this.entry.error, this.entry.time].map(rounded) : [];
    const custom = quality.disabled ? "–" : "custom";
    place.value = isThere ? `${quality.valueAsNumber + 1} of ${this.#entries.length}` : custom;
    error.value = isThere ? rmse : "–";
    ratio.value = isThere ? `${times} × default` : "–";
    const text = isThere ? `${place.value}: error ${rmse}, ${times} times as long as by default` : custom;
    quality.setAttribute("aria-valuetext", text);
  }
}

/** To three digits, without an exponent where that is shorter. */
const rounded = (x) => String(Number(x.toPrecision(3)));
