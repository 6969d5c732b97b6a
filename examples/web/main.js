// The page: controls, a picture that is rendered in short slices of time, and what it cost.

import { Job, difference } from "./job.js";
import { Orbit } from "./orbit.js";
import { Reader, Renderer } from "./renderer.js";
import { Slices } from "./slices.js";
import { Tuning } from "./tuning.js";

/** Milliseconds after which a picture in the making is shown again. */
const PAUSE = 40;
/** What a picture is compared with; the samples and the depth are the picture's own if those are more. */
const REFERENCE = { maths: "f64", samples: 16, isGrid: false, depth: 12, cutoff: 0, termination: 0, fresnel: 0 };

const element = Object.fromEntries([...document.querySelectorAll("[id]")].map((e) => [e.id, e]));
const { canvas } = element;
const context = canvas.getContext("2d", { alpha: false, willReadFrequently: true });
const orbit = new Orbit(canvas, () => restart());
const tuning = new Tuning(element, () => restart());
const slices = new Slices(work);

const renderers = new Map(); // By number type, for the pictures.
let referee = null; // The renderer of the reference.
let reader = null;
let scene = null;
let job = null;
let reference = null; // The job of the reference, with the `key` of its view and settings.
let painted = 0; // When, in milliseconds.
let isWaiting = false; // To begin anew, until the picture at hand can be seen.
let turn = 0; // Counts what was asked for, so that what loads slowly does not undo what came after.

async function begin() {
  tuning.load();
  const first = await rendererFor("f32");
  element.scene.append(...first.sceneNames().map((name, index) => new Option(name, index)));
  element.scene.disabled = false;
  for (const control of element.controls.querySelectorAll("select, input[type=number]")) {
    control.addEventListener("change", () => (control === element.scene ? chooseScene() : restart()));
  }
  element.controls.addEventListener("submit", (event) => event.preventDefault());
  element.compare.addEventListener("change", () => {
    if (job) showError();
    slices.ask();
  });
  element.home.addEventListener("click", () => (orbit.reset(), restart()));
  element.file.addEventListener("change", () => {
    openFile(element.file.files[0]);
    element.file.value = ""; // So that the same file can be chosen again.
  });
  new ResizeObserver(fit).observe(canvas);
  listenForDrops();
  chooseScene();
}

async function rendererFor(maths) {
  if (!renderers.has(maths)) renderers.set(maths, await Renderer.load(maths));
  return renderers.get(maths);
}

function chooseScene() {
  const option = element.scene.selectedOptions[0];
  open(option.scene ?? { index: Number(option.value), name: option.text });
}

function open(next) {
  scene = next;
  reference = null;
  tuning.open(scene);
  orbit.home = renderers.get("f32").open(scene);
  job = null;
  element.rmse.value = element.off.value = "–"; // They were of the picture before, which may stay.
  restart();
}

/** Begins the picture anew with what the controls say; if they say nonsense, what there is goes on. */
async function restart() {
  tuning.follow();
  isWaiting = job !== null && !job.isVisible;
  if (isWaiting) return slices.ask();
  const mine = ++turn;
  canvas.setAttribute("aria-busy", "true");
  try {
    const wishes = readControls();
    const { entry } = tuning;
    const renderer = await rendererFor(element.maths.value);
    if (mine !== turn) return;
    if (renderer.scene !== scene) renderer.open(scene);
    job = new Job(renderer, orbit.pose, wishes, entry);
    tell(null);
    showError();
    slices.ask();
  } catch (error) {
    canvas.setAttribute("aria-busy", String(job !== null && !job.isDone));
    tell(error.message);
  }
}

function readControls() {
  const wishes = {};
  for (const id of ["width", "height", "samples", "depth", "cutoff", "termination", "fresnel"]) {
    // A grid of samples is 2x2.
    wishes[id] = element[id].type === "number" ? element[id].valueAsNumber : Number.parseInt(element[id].value, 10);
    const isWhole = id === "cutoff" || Number.isInteger(wishes[id]);
    // What is below 0 or not whole cannot be handed over as it is.
    if (isWhole && wishes[id] >= 0) continue;
    throw new Error(`${id}: expected a ${id === "cutoff" ? "" : "whole "}number of at least 0`);
  }
  wishes.isGrid = element.samples.value.includes("x");
  return wishes;
}

/** One slice of time: for the picture, and when it is done for the reference. */
function work(milliseconds) {
  if (!job) return;
  if (!job.isDone) {
    job.work(milliseconds);
    if (job.isVisible && isDue()) paint();
  } else if (reference && !reference.isDone && element.compare.checked) {
    reference.work(milliseconds);
    showError();
  }
  if (isWaiting && job.isVisible) restart();
  else if (!job.isDone) slices.ask();
  else if (element.compare.checked) compare();
}

/** Whether to show the picture at hand: it is whole, another is to follow, or there was none for a while. */
function isDue() {
  return job.isDone || isWaiting || performance.now() - painted >= PAUSE;
}

/** Goes on with the reference, begins it, or does nothing if it is known. */
async function compare() {
  const key = referenceKey();
  if (referee?.scene === scene && reference?.key === key) {
    return reference.isDone ? showError() : slices.ask();
  }
  const mine = turn;
  try {
    referee ??= await Renderer.load(REFERENCE.maths);
    if (mine !== turn) return;
    if (referee.scene !== scene) referee.open(scene);
    reference = new Job(referee, job.pose, referenceFor(job.wishes));
    reference.key = key;
    showError();
    slices.ask();
  } catch (error) {
    element.reference.textContent = `No reference: ${error.message}`;
  }
}

function paint() {
  const { width, height } = job.renderer.size;
  if (canvas.width !== width || canvas.height !== height) {
    [canvas.width, canvas.height] = [width, height];
    canvas.style.setProperty("--ratio", width / height);
    fit();
  }
  context.putImageData(job.renderer.image, 0, 0);
  canvas.setAttribute("aria-label", `Picture of ${scene.name}`);
  if (job.isDone) canvas.setAttribute("aria-busy", "false");
  painted = performance.now();
  showCost();
}

/** Pixels that are much larger than the screen's are shown as squares. */
function fit() {
  canvas.classList.toggle("enlarged", canvas.clientWidth * devicePixelRatio >= 3 * canvas.width);
}

function showCost() {
  const { rays } = job.renderer;
  tuning.show(job);
  element.progress.value = 1 - job.left / job.pixels;
  element.time.value = `${job.milliseconds.toFixed(0)} ms`;
  element.rays.value = rays.toLocaleString("en");
  element.pace.value = `${((job.milliseconds * 1e6) / rays).toFixed(0)} ns`;
}

function showError() {
  const { samples, depth } = referenceFor(job.wishes);
  const setting = `f64, exact Fresnel, depth ${depth}, cutoff 0, ${samples} samples`;
  const isAsked = element.compare.checked;
  element.reference.textContent = isAsked
    ? `Errors are in linear light, pixels off by more than 1/255; against ${setting}.`
    : "";
  element.rmse.value = element.off.value = "–";
  if (!isAsked || !job.isDone || reference?.key !== referenceKey()) return;
  if (!reference.isDone) {
    element.rmse.value = `at ${((1 - reference.left / reference.pixels) * 100).toFixed(0)} %`;
    return;
  }
  const { rmse, off } = difference(job.renderer.values, reference.renderer.values);
  element.rmse.value = rmse === 0 ? "0" : rmse.toPrecision(3);
  element.off.value = `${(100 * off).toFixed(2)} %`;
}

/** The settings of the picture that this one is compared with. */
function referenceFor(wishes) {
  const { samples: count, isGrid, depth } = wishes;
  const samples = isGrid ? count * count : count;
  return { ...wishes, ...REFERENCE, samples: Math.max(REFERENCE.samples, samples), depth: Math.max(REFERENCE.depth, depth) };
}

/** What must be the same for a reference to be used again. */
function referenceKey() {
  const { width, height, samples, depth } = referenceFor(job.wishes);
  return JSON.stringify([job.pose, width, height, samples, depth]);
}

async function openFile(file) {
  if (!file) return;
  const mine = ++turn;
  try {
    const bytes = new Uint8Array(await file.arrayBuffer());
    reader ??= await Reader.load();
    const records = reader.read(bytes);
    if (mine !== turn) return;
    const option = new Option(file.name, "file");
    option.scene = { name: file.name, records };
    element.scene.querySelector("[value=file]")?.remove();
    element.scene.append(option);
    element.scene.value = "file";
    open(option.scene);
  } catch (error) {
    tell(`${file.name}: ${error.message}`);
  }
}

function listenForDrops() {
  addEventListener("dragover", (event) => {
    event.preventDefault();
    document.body.classList.add("dropping");
  });
  addEventListener("dragleave", (event) => {
    if (!event.relatedTarget) document.body.classList.remove("dropping");
  });
  addEventListener("drop", (event) => {
    event.preventDefault();
    document.body.classList.remove("dropping");
    openFile(event.dataTransfer.files[0]);
  });
}

function tell(message) {
  element.message.textContent = message ?? "";
  element.message.hidden = message === null;
}

begin().catch((error) => tell(error.message));
