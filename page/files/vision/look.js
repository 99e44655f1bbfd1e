// What a camera sees: the sheet, the objects on it, and what is wrong with the picture. Pure but for the memory of `createLook`.

import { AR } from "../vendor/js-aruco2/dictionary.js";
import { inPicture, onSheet, viewOf } from "./geometry.js";
import { blobOfHue, brightness, exactCorners, lightAt, quality } from "./picture.js";

/** @typedef {import("./geometry.js").Found} Found */
/** @typedef {import("./geometry.js").SheetView} SheetView */
/** @typedef {import("./geometry.js").Pair} Pair */
/** What is wrong: the end of a text key. @typedef {"few_corners" | "blurred" | "glare" | "sheet_moved" | "camera_moved"} Trouble */
/** What a picture shows. `blob` is the middle of the largest blob of the hue that was asked for. @typedef {{ view: SheetView | null, markers: readonly Found[], blob: Pair | null, troubles: readonly Trouble[] }} Seen */

/** The markers that are recognised: the first fifty of the dictionary. */
const COUNT = 50;
/** Pictures less sharp are blurred; with more overexposed pixels there is glare. */
const SHARP = 0.33, OVEREXPOSED = 0.02;
/** What moved farther in the picture has moved, in widths of it. */
const MOVED = 0.006;
/** The grid on which the surroundings are compared, and the difference in brightness that is a change. */
const GRID = 24, CHANGED = 12;

/** Finds markers with exact corners. */
export function createDetector() {
  const name = "ARUCO_4X4_1000";
  AR.DICTIONARIES[name].codeList = AR.DICTIONARIES[name].codeList.slice(0, COUNT);
  // A damaged marker is none: it might be another one.
  const detector = new AR.Detector({ dictionaryName: name, maxHammingDistance: 1 });
  /** @param {import("./picture.js").Picture} picture @param {Float32Array} light @returns {Found[]} */
  return (picture, light) => detector.detect(picture).map((/** @type {{ id: number, corners: { x: number, y: number }[] }} */ { id, corners }) => ({
    id,
    corners: exactCorners(light, picture.width, picture.height, corners.map(({ x, y }) => /** @type {Pair} */ ([x + 0.5, y + 0.5]))),
  }));
}

/** @param {import("./geometry.js").SheetMarkers} sheet */
export function createLook(sheet) {
  const detect = createDetector();
  /** Where the sheet and its surroundings were. @type {{ view: SheetView, around: Float32Array } | null} */ let first = null;
  const corners = sheet.flat();
  const [ahead, left] = [0, 1].map((axis) => corners.map((corner) => corner[axis]));
  const [low, high] = /** @type {[Pair, Pair]} */ ([[Math.min(...ahead), Math.min(...left)], [Math.max(...ahead), Math.max(...left)]]);

  return {
    /** The sheet lies where it belongs: what moves from now on is reported. */
    forget: () => void (first = null),
    /** @param {import("./picture.js").Picture} picture @param {number | null} [hue_deg] @returns {Seen} */
    look(picture, hue_deg = null) {
      const light = brightness(picture), { width, height } = picture;
      const markers = detect(picture, light);
      const view = viewOf(markers, sheet, [width, height]);
      const { sharpness, overexposed } = quality(picture, light);
      /** @type {Trouble[]} */ const troubles = [];
      if (!view) troubles.push("few_corners");
      if (sharpness < SHARP) troubles.push("blurred");
      if (overexposed > OVEREXPOSED) troubles.push("glare");
      if (view && !first && troubles.length === 0) first = { view, around: aroundOf(light, width, height) };
      const moved = view && first && movedFrom(first, view, light, corners);
      if (moved) troubles.push(moved);
      const blob = view && hue_deg !== null ? blobOfHue(picture, view, hue_deg, [low, high]) : null;
      return { view, markers, blob, troubles };
    },
  };
}

/** The brightness of the picture on a coarse grid. @param {Float32Array} light @param {number} width @param {number} height */
function aroundOf(light, width, height) {
  const around = new Float32Array(GRID * GRID);
  for (let n = 0; n < around.length; n += 1) around[n] = lightAt(light, width, height, ...gridPlace(n, width, height));
  return around;
}

/** @param {number} n @param {number} width @param {number} height @returns {Pair} */
const gridPlace = (n, width, height) => [((n % GRID) + 0.5) * (width / GRID), (Math.floor(n / GRID) + 0.5) * (height / GRID)];

/**
 * Whether sheet or camera moved: with the camera, what surrounds the sheet moves too.
 * @param {{ view: SheetView, around: Float32Array }} first @param {SheetView} view @param {Float32Array} light @param {readonly Pair[]} corners
 * @returns {"sheet_moved" | "camera_moved" | null}
 */
function movedFrom(first, view, light, corners) {
  const [width, height] = view.size;
  const far = corners.reduce((sum, corner) => {
    const [before, now] = [first.view, view].map((of) => inPicture(of, corner));
    return sum + Math.hypot(now[0] - before[0], now[1] - before[1]) / corners.length;
  }, 0);
  if (far < MOVED * width) return null;
  const isPaper = (/** @type {Pair} */ pixel) => [first.view, view].some((of) => {
    const [x, y] = onSheet(of, pixel);
    return x > EDGES[0] && x < EDGES[1] && Math.abs(y) < EDGES[2];
  });
  let [count, changed] = [0, 0];
  const now = aroundOf(light, width, height);
  for (let n = 0; n < now.length; n += 1) {
    if (isPaper(gridPlace(n, width, height))) continue;
    count += 1;
    if (Math.abs(now[n] - first.around[n]) > CHANGED) changed += 1;
  }
  return count > 0 && changed > count * 0.2 ? "camera_moved" : "sheet_moved";
}

/** The edges of the paper with some room, in mm: near, far, and to the sides. */
const EDGES = /** @type {const} */ ([85, 315, 160]);
