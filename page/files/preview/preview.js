// @ts-check
// The preview: a person goes to any moment of a drawing before it is made. The file stays in this browser.

import { boundsOf, clock, errorNames, heightFor, inkOfColumns, lookOfErrors, lookOfPasses, passName, viewOf } from "./look.js";
import { Sketch } from "./sketch.js";
import { placeAt } from "./timeline.js";

/** @typedef {import("./timeline.js").Timeline} Timeline */
/** @typedef {import("./timeline.js").Place} Place */
/** @typedef {import("./look.js").Look} Look */

const MOST_NAMED = 12;
/** A page that slept does not leap. */
const MOST_STEP_S = 0.25;

/** @type {Timeline | undefined} */ let timeline;
/** @type {{x: number[], y: number[]}} */ let bounds;
/** @type {Look} */ let look;
/** @type {Sketch | undefined} */ let sketch;
/** @type {Worker | undefined} */ let reader;
let t_s = 0;
let playing = false;
let paintedAt = 0;
let painting = false;

/** @template {HTMLElement} [T=HTMLElement] @param {string} name @returns {T} */
function part(name) {
  return /** @type {T} */ (document.getElementById(`preview-${name}`));
}

/** @param {string} name @param {string} text */
function write(name, text) {
  const found = part(name);
  if (found.textContent !== text) found.textContent = text;
}

/** @param {string} name @returns {HTMLInputElement} */
function input(name) {
  return part(name);
}

/** The value of the radio button that is chosen. @param {string} name */
function chosen(name) {
  return /** @type {HTMLInputElement} */ (document.querySelector(`input[name="preview-${name}"]:checked`)).value;
}

// --- A file ----------------------------------------------------------------------

/** @param {File} file */
function read(file) {
  reader?.terminate();
  reader = new Worker(new URL("reader.js", import.meta.url), { type: "module" });
  reader.onmessage = ({ data }) => (data.timeline ? take(file.name, data.timeline) : refuse(file.name, data.refused));
  reader.onerror = (event) => {
    event.preventDefault();
    refuse(file.name, "cannot be read now; expected are a station that answers and enough memory: try again, or make the timeline of a part of the drawing.");
  };
  reader.postMessage(file);
  part("problem").hidden = true;
  write("name", `reading ${file.name}…`);
}

/** @param {string} name @param {string} why */
function refuse(name, why) {
  finishReading();
  write("why", `${name} ${why}`);
  part("problem").hidden = false;
  write("name", part("shown").dataset.name ?? "");
}

/** @param {string} name @param {Timeline} read */
function take(name, read) {
  finishReading();
  timeline = read;
  bounds = boundsOf(read);
  part("shown").dataset.name = name;
  write("name", name);
  part("problem").hidden = true;
  part("empty").hidden = true;
  part("shown").hidden = false;
  input("time").max = String(read.duration_s);
  play(false);
  goTo(0);
  recolor();
}

function finishReading() {
  reader?.terminate();
  reader = undefined;
}

// --- How it looks ------------------------------------------------------------------

/** What the colours mean was changed, or the drawing. */
function recolor() {
  if (!timeline) return;
  const errors = chosen("colors") === "errors";
  const tolerance = input("tolerance");
  part("tolerance-row").hidden = !errors;
  if (errors && !tolerance.validity.valid) return;
  look = errors ? lookOfErrors(timeline, tolerance.valueAsNumber) : lookOfPasses(timeline);
  drawLegend(errors ? errorNames(tolerance.valueAsNumber) : timeline.passes.map(passName));
  resize();
}

/** @param {string[]} names */
function drawLegend(names) {
  const items = names.slice(0, MOST_NAMED).map((name, i) => entry(name, look.styles[i]));
  if (names.length > MOST_NAMED) items.push(entry(`and ${names.length - MOST_NAMED} more`));
  const travel = entry("travel");
  travel.className = "travel";
  part("legend").replaceChildren(travel, ...items);
}

/** A name, and the line that it stands for. @param {string} name @param {{color: string, width_mm: number}} [style] */
function entry(name, style) {
  const item = document.createElement("li");
  item.textContent = name;
  if (style) item.style.setProperty("--color", style.color);
  if (style) item.style.setProperty("--width", `${9 * style.width_mm}px`);
  return item;
}

/** The canvas got another size, or the page other colours. */
function resize() {
  const canvas = /** @type {HTMLCanvasElement} */ (part("canvas"));
  const width = Math.floor(part("sheet").clientWidth);
  if (!timeline || width === 0) return;
  const ratio = Math.min(2, window.devicePixelRatio || 1);
  const height = heightFor(bounds, width, Math.max(260, 0.56 * window.innerHeight));
  [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
  canvas.style.setProperty("height", `${height}px`);
  sketch = new Sketch(timeline, look, viewOf(bounds, { width, height, ratio }), theme());
  drawStrip(width * ratio);
  repaint();
}

function theme() {
  const style = getComputedStyle(part("sheet"));
  /** @param {string} name */
  const color = (name) => style.getPropertyValue(name).trim();
  return { sheet: color("--sheet"), travel: color("--travel"), tool: color("--tool"), words: color("--sheet-words") };
}

/** Above the scrub bar: when there is ink, in its colour. @param {number} width */
function drawStrip(width) {
  const canvas = /** @type {HTMLCanvasElement} */ (part("strip"));
  [canvas.width, canvas.height] = [Math.round(width), 1];
  const context = canvas.getContext("2d");
  if (!timeline) return;
  const inks = inkOfColumns(timeline, look, canvas.width);
  inks.forEach((ink, column) => {
    if (!context || ink < 0) return;
    context.fillStyle = look.styles[ink].color;
    context.fillRect(column, 0, 1, 1);
  });
}

// --- A moment ------------------------------------------------------------------------

/** @param {number} to_s */
function goTo(to_s) {
  if (!timeline) return;
  t_s = Math.min(timeline.duration_s, Math.max(0, to_s));
  if (t_s === timeline.duration_s) play(false);
  repaint();
}

/** @param {boolean} on */
function play(on) {
  if (on && timeline && t_s >= timeline.duration_s) t_s = 0;
  playing = on;
  write("play", on ? "Pause" : "Play");
  repaint();
}

/** Once for each picture of the screen, however much has changed. */
function repaint() {
  if (painting) return;
  painting = true;
  requestAnimationFrame(paint);
}

/** @param {number} now_ms */
function paint(now_ms) {
  painting = false;
  const step_s = Math.min(MOST_STEP_S, (now_ms - paintedAt) / 1000);
  paintedAt = now_ms;
  if (!timeline || !sketch) return;
  if (playing) goTo(t_s + step_s * Number(chosen("speed")));
  const place = placeAt(timeline, t_s);
  const whole = sketch.advance(place.row);
  const context = /** @type {HTMLCanvasElement} */ (part("canvas")).getContext("2d");
  if (context) sketch.show(context, place);
  tell(place, timeline);
  if (playing || !whole) repaint();
}

/** @param {Place} place @param {Timeline} timeline */
function tell(place, { duration_s, passes }) {
  const does = t_s >= duration_s ? "done" : place.kind;
  const time = `${clock(t_s)} of ${clock(duration_s)}`;
  input("time").value = String(t_s);
  input("time").setAttribute("aria-valuetext", `${time}, ${does}`);
  write("now", clock(t_s));
  write("whole", clock(duration_s));
  write("does", does);
  const pass = passName(passes[place.pass], place.pass);
  write("pass", passes.length > 1 ? `${place.pass + 1} of ${passes.length}: ${pass}` : pass);
  for (const axis of /** @type {const} */ (["x_mm", "y_mm", "z_mm"])) write(axis, place[axis].toFixed(2));
}

// --- Hands -----------------------------------------------------------------------------

/** Arrows go a second, with Shift a tenth; page keys a twentieth of the whole. Space is STOP everywhere, so Enter plays. @param {KeyboardEvent} event */
function step(event) {
  if (!timeline || event.ctrlKey || event.altKey || event.metaKey) return;
  if (event.key === "Enter" && !event.repeat) play(!playing);
  const one = event.shiftKey ? 0.1 : 1;
  const page = timeline.duration_s / 20;
  /** @type {Record<string, number>} */
  const steps = { ArrowRight: one, ArrowUp: one, ArrowLeft: -one, ArrowDown: -one, PageUp: page, PageDown: -page, Home: -Infinity, End: Infinity };
  if (steps[event.key] === undefined) return;
  event.preventDefault();
  play(false);
  goTo(t_s + steps[event.key]);
}

/** A file that is dropped beside the panel must not take this page, and STOP, away. */
function listenToDrops() {
  /** @param {DragEvent} event */
  const hasFile = (event) => event.dataTransfer?.types.includes("Files") ?? false;
  /** @param {boolean} over */
  const mark = (over) => document.getElementById("preview")?.classList.toggle("is-over", over);
  addEventListener("dragover", (event) => {
    if (!hasFile(event)) return;
    event.preventDefault();
    mark(true);
  });
  addEventListener("dragleave", (event) => event.relatedTarget === null && mark(false));
  addEventListener("drop", (event) => {
    mark(false);
    if (!hasFile(event)) return;
    event.preventDefault();
    const files = event.dataTransfer?.files ?? [];
    if (files.length === 1) read(files[0]);
    else refuse(`${files.length} files`, "were dropped; expected is one, a timeline.");
  });
}

function listen() {
  const file = input("file");
  part("choose").addEventListener("click", () => file.click());
  file.addEventListener("change", () => {
    if (file.files?.[0]) read(file.files[0]);
    // The same file again is a change, too: it may have been made anew.
    file.value = "";
  });
  part("problem-close").addEventListener("click", () => (part("problem").hidden = true));
  part("play").addEventListener("click", () => play(!playing));
  input("time").addEventListener("input", () => {
    play(false);
    goTo(input("time").valueAsNumber);
  });
  input("time").addEventListener("keydown", step);
  part("colors").addEventListener("change", recolor);
  input("tolerance").addEventListener("input", recolor);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", resize);
  // Its height is this page's own choice.
  new ResizeObserver(() => part("sheet").clientWidth !== sketch?.view.frame.width && resize()).observe(part("sheet"));
  listenToDrops();
}

listen();
