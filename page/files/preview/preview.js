// @ts-check
// The player: shows any moment of a drawing before it is drawn.

import { boundsOf, clock, errorNames, heightFor, inkOfColumns, lookOfErrors, lookOfPasses, passName, viewOf } from "./appearance.js";
import { Sketch } from "./sketch.js";
import { placeAt } from "./timeline.js";

/** @typedef {import("./timeline.js").Timeline} Timeline */
/** @typedef {import("./timeline.js").Place} Place */
/** @typedef {import("./appearance.js").Look} Look */

const MOST_NAMED = 12;
/** A page that slept does not leap. */
const MOST_STEP_S = 0.25;

/** Taken from the page; the panel that shows it puts it where it belongs. */
const root = /** @type {HTMLElement} */ (document.getElementById("preview"));
root.remove();
root.hidden = false;

/** The texts and labels of its parts. @type {Record<string, import("../i18n/i18n.js").TextKey>} */
const TEXTS = { title: "play", "colors-title": "play.colors", "by-pass": "play.by_pass", "by-error": "play.by_error", "tolerance-title": "play.tolerance", "speed-title": "play.speed", of: "play.of", "does-title": "play.tool", "pass-title": "play.pass", hint: "play.hint" };
/** @type {Record<string, import("../i18n/i18n.js").TextKey>} */
const LABELS = { canvas: "play.canvas", time: "play.time" };

/** @type {Timeline | undefined} */ let timeline;
/** @type {{x: number[], y: number[]}} */ let bounds;
/** @type {Look} */ let look;
/** @type {Sketch | undefined} */ let sketch;
/** @type {import("../state/draw.js").Draw["timeline"]} */ let shown = null;
/** @type {string | null} */ let language = null;
/** @type {import("../i18n/i18n.js").Translate} */ let t;
let t_s = 0;
let playing = false;
let paintedAt = 0;
let painting = false;

/** @template {HTMLElement} [T=HTMLElement] @param {string} name @returns {T} */
function part(name) {
  return /** @type {T} */ (root.querySelector(`#preview-${name}`));
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
  return /** @type {HTMLInputElement} */ (root.querySelector(`input[name="preview-${name}"]:checked`)).value;
}

// --- What is shown -----------------------------------------------------------------

/** The player, with what the state has to show in it. @param {import("../views/context.js").Context} context @returns {HTMLElement} */
export function player(context) {
  if (context.page.language !== language) {
    [language, t] = [context.page.language, context.t];
    translate();
  }
  const wanted = context.page.draw.timeline;
  if (wanted && wanted !== shown) {
    shown = wanted;
    take(wanted.timeline);
  }
  return root;
}

/** Translates the texts of the player. */
function translate() {
  for (const [name, word] of Object.entries(TEXTS)) part(name).textContent = t(word);
  for (const [name, word] of Object.entries(LABELS)) part(name).setAttribute("aria-label", t(word));
  write("play", t(playing ? "play.pause" : "play.play"));
  recolor();
}

/** @param {Timeline} read */
function take(read) {
  timeline = read;
  bounds = boundsOf(read);
  input("time").max = String(read.duration_s);
  play(false);
  goTo(0);
  recolor();
}

// --- How it looks ------------------------------------------------------------------

/** The colour mode or the drawing changed. */
function recolor() {
  if (!timeline) return;
  const errors = chosen("colors") === "errors";
  const tolerance = input("tolerance");
  part("tolerance-row").hidden = !errors;
  if (errors && !tolerance.validity.valid) return;
  look = errors ? lookOfErrors(timeline, tolerance.valueAsNumber) : lookOfPasses(timeline);
  drawLegend(errors ? errorNames(t, tolerance.valueAsNumber) : timeline.passes.map((pass, n) => passName(t, pass, n)));
  resize();
}

/** @param {string[]} names */
function drawLegend(names) {
  const items = names.slice(0, MOST_NAMED).map((name, i) => entry(name, look.styles[i]));
  if (names.length > MOST_NAMED) items.push(entry(t("draw.more", { count: names.length - MOST_NAMED })));
  const travel = entry(t("play.does.travel"));
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

/** Draws the ink over time above the time bar. @param {number} width */
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
  write("play", t(on ? "play.pause" : "play.play"));
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
  const does = t(doing(t_s >= duration_s ? "done" : place.kind));
  const time = `${clock(t_s)} ${t("play.of")} ${clock(duration_s)}`;
  input("time").value = String(t_s);
  input("time").setAttribute("aria-valuetext", `${time}, ${does}`);
  write("now", clock(t_s));
  write("whole", clock(duration_s));
  write("does", does);
  const pass = passName(t, passes[place.pass], place.pass);
  write("pass", passes.length > 1 ? `${place.pass + 1} / ${passes.length}: ${pass}` : pass);
  for (const axis of /** @type {const} */ (["x_mm", "y_mm", "z_mm"])) write(axis, place[axis].toFixed(2));
}

/** Returns the text key of a move kind. @param {string} kind */
const doing = (kind) => /** @type {import("../i18n/i18n.js").TextKey} */ (`play.does.${kind}`);

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

function listen() {
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
}

listen();
