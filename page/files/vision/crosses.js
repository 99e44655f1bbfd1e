// The crosses that an arm drew on the sheet, in a photo of it. Pure. `dobot_arm/vision.py` has the same functions, tested with the same
// photos.

import { inPicture, viewOf } from "./geometry.js";
import { createDetector } from "./look.js";
import { brightness, lightAt } from "./picture.js";

/** @typedef {import("./geometry.js").Pair} Pair */

/** How far from where it should be a cross is searched. */
const WITHIN_MM = 14;
/** The grid on which the surroundings of a cross are seen from above, and how far from its middle a cross is dark. */
const STEP_MM = 0.1, ARM_MM = 3.6;
/** Half the length and half the width of a line, and what is left out around the middle, in steps. */
const HALF = Math.round(ARM_MM / STEP_MM), THIN = 2, MIDDLE = Math.round(1 / STEP_MM);
const LEAST_MATCH = 0.45;

/**
 * Where crosses lie, each near a wanted position; null for one that is not found. Null without three corners of the sheet.
 * @param {import("./picture.js").Picture} picture @param {import("./geometry.js").SheetMarkers} sheet @param {readonly Pair[]} wanted @returns {(Pair | null)[] | null}
 */
export function crossesIn(picture, sheet, wanted) {
  const light = brightness(picture), { width, height } = picture;
  const view = viewOf(createDetector()(picture, light), sheet, [width, height]);
  return view && wanted.map((place) => cross((at) => lightAt(light, width, height, ...inPicture(view, at)), place));
}

/** @param {(place: Pair) => number} lightOf @param {Pair} wanted @returns {Pair | null} */
function cross(lightOf, [x, y]) {
  const reach = Math.round((WITHIN_MM + ARM_MM) / STEP_MM), size = 2 * reach + 1;
  // Rows go along the first line of the cross, columns along the second one: both are at 45 degrees.
  const place = (/** @type {number} */ a, /** @type {number} */ b) => /** @type {Pair} */ ([x + ((a + b) * STEP_MM) / Math.SQRT2, y + ((a - b) * STEP_MM) / Math.SQRT2]);
  const above = new Float64Array(size * size);
  for (let row = 0; row < size; row += 1) for (let column = 0; column < size; column += 1) above[row * size + column] = lightOf(place(row - reach, column - reach));
  const paper = median(above);
  const dark = above.map((light) => Math.max(0, paper - light));
  const best = match(dark, size);
  if (!best) return null;
  const [row, column] = best;
  // The profile of each line, without the middle where they cross; the mean of its darkness is exact to a hundredth of a mm.
  const offset = (/** @type {(along: number, across: number) => number} */ darkness) => {
    let [sum, moment] = [0, 0];
    for (let across = -MIDDLE; across <= MIDDLE; across += 1) {
      for (let along = -HALF; along <= HALF; along += 1) {
        if (Math.abs(along) <= MIDDLE) continue;
        sum += darkness(along, across);
        moment += darkness(along, across) * across;
      }
    }
    return moment / sum;
  };
  const a = offset((along, across) => dark[(row + across) * size + column + along]);
  const b = offset((along, across) => dark[(row + along) * size + column + across]);
  return place(row - reach + a, column - reach + b);
}

/** Where a cross matches best: its row and column; null if it matches badly. @param {Float64Array} dark @param {number} size @returns {[number, number] | null} */
function match(dark, size) {
  const sums = table(dark, size), squares = table(dark.map((value) => value * value), size);
  const length = 2 * HALF + 1, width = 2 * THIN + 1, count = length * length, line = 2 * length * width - width * width, share = line / count;
  const weight = Math.sqrt(line * (1 - share));
  /** @type {[number, number] | null} */ let best = null;
  let most = LEAST_MATCH;
  for (let row = HALF; row < size - HALF; row += 1) {
    for (let column = HALF; column < size - HALF; column += 1) {
      const all = sums(row, column, HALF, HALF);
      const lines = sums(row, column, THIN, HALF) + sums(row, column, HALF, THIN) - sums(row, column, THIN, THIN);
      const spread = squares(row, column, HALF, HALF) - (all * all) / count;
      const found = (lines - share * all) / (weight * Math.sqrt(Math.max(spread, 1e-9)));
      if (found > most) [most, best] = [found, [row, column]];
    }
  }
  return best;
}

/** Returns the sum of the values around a place. @param {Float64Array} values @param {number} size */
function table(values, size) {
  const wide = size + 1, sums = new Float64Array(wide * wide);
  for (let row = 0; row < size; row += 1) for (let column = 0; column < size; column += 1) sums[(row + 1) * wide + column + 1] = values[row * size + column] + sums[row * wide + column + 1] + sums[(row + 1) * wide + column] - sums[row * wide + column];
  return (/** @type {number} */ row, /** @type {number} */ column, /** @type {number} */ high, /** @type {number} */ far) => {
    const [top, bottom, left, right] = [row - high, row + high + 1, column - far, column + far + 1];
    return sums[bottom * wide + right] - sums[top * wide + right] - sums[bottom * wide + left] + sums[top * wide + left];
  };
}

/** @param {Float64Array} values */
const median = (values) => values.slice().sort()[values.length >> 1];
