// The stage: shows a `View` (see `view.js`) in two dimensions, and in three as soon as WebGL is ready. It draws only when
// something changed and it is visible. Its only own state is the camera and the last reports.

import { createScene2d } from "./scene_2d.js";
import { Motion } from "./motion.js";
import { createFrameBudget, createFrames, nextTask } from "../parts/frame_budget.js";
import { BUSY_MS } from "../station/keep_alive.js";
import { createLimit, createRenderQuality } from "./render_quality.js";

/** @typedef {import("./view.js").View} View */
/** @typedef {import("./view.js").Preset} Preset */
/** @typedef {ReturnType<typeof import("./scene_3d.js").createScene3d>} Scene3d */
/** @typedef {Scene3d | ReturnType<typeof createScene2d>} AnyScene */

/** @type {readonly Preset[]} */
export const PRESETS = ["iso", "top", "side", "tool"];
const TURN_DEG = 8;
const SHIFT_PX = 40;
const NEARER = 1.2;
/** A frame of 3-D that takes longer while a button is held is reported, by the event `slow`: it may release the button. */
const SLOW_FRAME_MS = 0.8 * BUSY_MS;

/** @param {HTMLElement} element */
export function createStage(element) {
  const note = document.createElement("p");
  note.className = "stage-note";
  element.classList.add("stage");
  element.append(note);
  const motion = new Motion();
  const isDue = createLimit();
  const budget = createFrameBudget();
  let pace = createRenderQuality(true);
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  /** @type {View | null} */ let view = null;
  let inked = 0, inSight = true, isHeld = false, hasCard = false, isFlat = false, isLoading = false;
  /** @type {AnyScene} */ let drawing;
  /** The scene that is being prepared. @type {Scene3d | null} */ let next3d = null;

  const outside = {
    get still() {
      return still.matches;
    },
    changed() {
      if (inSight && !document.hidden) frames.ask(wait_ms());
    },
    /** @param {import("./view.js").Target} detail */
    target: (detail) => void element.dispatchEvent(new CustomEvent("target", { detail })),
  };

  /** How long a frame has to wait for input: without a graphics card, drawing takes the time of the page's thread. */
  const wait_ms = () => (isHeld || (drawing.kind === "3d" && !hasCard) ? budget.wait_ms() : 0);
  const frames = createFrames(draw);

  /** @param {number} now_ms */
  function draw(now_ms) {
    // The frame may have been asked for before the previous one was painted, and measured.
    if (wait_ms() > 0 || !isDue(now_ms)) return outside.changed();
    budget.begin(drawing.kind === "3d" && isHeld ? reportSlow : undefined);
    const at = motion.at(performance.now() / 1000);
    if (next3d) prepare(next3d, at?.joints ?? null);
    const { rendered, again: pending } = drawing.frame(at?.joints ?? null, performance.now() / 1000);
    const again = (at?.moving ?? false) || pending;
    if (rendered && !isHeld && pace.drawn(now_ms, again)) resize();
    if (again || next3d?.isReady) outside.changed();
  }

  /** @param {number} took_ms */
  function reportSlow(took_ms) {
    if (took_ms > SLOW_FRAME_MS) element.dispatchEvent(new CustomEvent("slow"));
  }

  /** Handles a change of visibility: pending changes are drawn when the stage is visible again. */
  function turnUp() {
    frames.cancel();
    outside.changed();
  }

  function resize() {
    const { clientWidth: width, clientHeight: height } = element;
    if (width === 0 || height === 0) return;
    size(drawing, pace);
    if (next3d) size(next3d, createRenderQuality(hasCard));
    outside.changed();
  }

  /** @param {AnyScene} scene @param {ReturnType<typeof createRenderQuality>} pace */
  function size(scene, pace) {
    const quality = pace.quality(devicePixelRatio);
    if (scene.kind === "3d") scene.refine(quality);
    scene.resize(element.clientWidth, element.clientHeight, quality.density);
  }

  /** Replaces what draws. @param {AnyScene} scene */
  function put(scene) {
    drawing?.end();
    drawing = scene;
    scene.canvas.setAttribute("aria-hidden", "true");
    element.prepend(scene.canvas);
    pace = createRenderQuality(scene.kind === "2d" || hasCard);
    element.dataset.shown = scene.kind;
    if (view) scene.show(view);
    resize();
    element.dispatchEvent(new CustomEvent("shown", { detail: scene.kind }));
  }

  /** Prepares three dimensions while two are shown: a page that waits for shaders would not hear STOP. */
  async function raise() {
    if (isFlat || next3d || isLoading) return;
    isLoading = true;
    const by = await findRenderer();
    // Half of all that a first visit loads; without it the stage stays flat.
    const loaded = by === "nothing" ? null : await import("./scene_3d.js").catch(() => null);
    await nextTask();
    isLoading = false;
    if (!loaded || isFlat) return;
    const { createScene3d } = loaded;
    hasCard = by === "card";
    const scene = next3d = createScene3d(element, outside, hasCard);
    scene.source.addEventListener("webglcontextlost", (event) => lost(event, scene));
    size(scene, createRenderQuality(hasCard));
    await nextTask();
    if (view) scene.show(view);
    await nextTask();
    await scene.compile();
    if (next3d !== scene) return scene.end();
    scene.isReady = true;
    outside.changed();
  }

  /** Draws the first frame of three dimensions, and shows it when it is finished. @param {Scene3d} scene @param {import("./view.js").Joints | null} joints */
  function prepare(scene, joints) {
    if (!scene.isReady) return;
    if (scene.frame(joints, performance.now() / 1000).again && !hasCard) return;
    next3d = null;
    put(scene);
  }

  /** Gives up the scene that is being prepared; while its shaders are compiled it ends afterwards. */
  function dropNext() {
    if (next3d?.isReady) next3d.end();
    next3d = null;
  }

  /** Shows two dimensions from now on. */
  function flatten() {
    isFlat = true;
    dropNext();
    if (drawing.kind === "3d") put(createScene2d(element, outside));
  }

  /** The graphics context was lost: shows two dimensions until it is restored. @param {Event} event @param {Scene3d} scene */
  function lost(event, scene) {
    event.preventDefault();
    scene.source.addEventListener("webglcontextrestored", () => void raise(), { once: true });
    if (next3d === scene) next3d = null;
    // Deferred, because the renderer listens too. The old canvas is kept: it receives the event when the card is back.
    queueMicrotask(() => drawing === scene && put(createScene2d(element, outside)));
  }

  /** @param {KeyboardEvent} event */
  function press(event) {
    if (drawing.kind !== "3d" || event.target !== element || event.altKey || event.metaKey) return;
    const preset = PRESETS[Number(event.key) - 1];
    const way = /** @type {Record<string, [number, number]>} */ ({ ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] })[event.key];
    if (preset && !event.ctrlKey) look(preset);
    else if (way && event.shiftKey) drawing.turn(way[0] * TURN_DEG, way[1] * TURN_DEG);
    else if (way && event.ctrlKey) drawing.shift(way[0] * SHIFT_PX, way[1] * SHIFT_PX);
    else if ((event.key === "+" || event.key === "=") && !event.ctrlKey) drawing.near(NEARER);
    else if (event.key === "-" && !event.ctrlKey) drawing.near(1 / NEARER);
    else return;
    event.preventDefault();
  }

  /** @param {Preset} preset */
  function look(preset) {
    if (drawing.kind === "3d") drawing.look(preset, performance.now() / 1000);
  }

  const watched = new ResizeObserver(resize);
  watched.observe(element);
  const sight = new IntersectionObserver((entries) => {
    inSight = entries.at(-1)?.isIntersecting ?? true;
    turnUp();
  });
  sight.observe(element);
  document.addEventListener("visibilitychange", turnUp);
  element.addEventListener("keydown", press);
  put(createScene2d(element, outside));
  // After the first picture of the page.
  requestAnimationFrame(() => setTimeout(() => void raise()));

  return {
    look,
    flatten,
    /** Whether a jog button is held: then drawing leaves time for input. @param {boolean} held */
    hold: (held) => void (isHeld = held),
    /** @param {View} next */
    show(next) {
      motion.status_s = next.status_s;
      if (next.arm && next.arm !== view?.arm) motion.add({ at_s: next.arm.at_s, joints: next.arm }, performance.now() / 1000);
      if (!next.arm) motion.clear();
      const ink = next.marks?.shades.length ?? 0;
      const changed = ink !== inked || !isSame(view, next);
      inked = ink;
      view = next;
      // Setting a property restyles the element even if the value is unchanged.
      if (note.textContent !== next.note) note.textContent = next.note;
      if (note.hidden !== (next.note === "")) note.hidden = !note.hidden;
      element.classList.toggle("is-old", next.old);
      if (element.ariaLabel !== next.label) element.ariaLabel = next.label;
      if (!changed) return;
      drawing.show(next);
      next3d?.show(next);
    },
    end() {
      frames.cancel();
      watched.disconnect();
      sight.disconnect();
      document.removeEventListener("visibilitychange", turnUp);
      element.removeEventListener("keydown", press);
      dropNext();
      drawing.end();
      note.remove();
    },
  };
}

/** Asks a thread what draws three dimensions: the page would have to wait for the first context. @returns {Promise<import("./webgl_worker.js").Renderer>} */
function findRenderer() {
  if (!("OffscreenCanvas" in window && "WebGL2RenderingContext" in window)) return Promise.resolve("nothing");
  const worker = new Worker(new URL("webgl_worker.js", import.meta.url), { type: "module" });
  return new Promise((found) => {
    worker.onmessage = ({ data }) => found(data);
    worker.onerror = () => found("nothing");
  }).finally(() => worker.terminate());
}

/** View properties that are not drawn. */
const UNSEEN = new Set(["arm", "note", "label"]);

/** Whether two views look the same: an arm at rest keeps reporting the same. @param {View | null} before @param {View} next */
function isSame(before, next) {
  if (!before || (before.arm === null) !== (next.arm === null)) return false;
  const names = /** @type {(keyof View)[]} */ (Object.keys(next));
  if (names.some((name) => !UNSEEN.has(name) && !isAlike(before[name], next[name]))) return false;
  return isAlike({ ...before.arm, at_s: 0 }, { ...next.arm, at_s: 0 });
}

/** Whether two values are identical, or objects with equal primitive values. @param {unknown} a @param {unknown} b */
function isAlike(a, b) {
  if (a === b) return true;
  if (typeof a !== "object" || typeof b !== "object" || !a || !b || Array.isArray(a)) return false;
  const [left, right] = [Object.entries(a), /** @type {Record<string, unknown>} */ (b)];
  return left.length === Object.keys(b).length && left.every(([name, value]) => value === right[name]);
}
