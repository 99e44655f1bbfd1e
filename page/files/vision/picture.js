// What a picture shows: markers with exact corners, a blob of a colour, and whether it is sharp. Pure.

import { onSheet } from "./geometry.js";

/** A picture, four bytes a pixel. @typedef {{ width: number, height: number, data: Uint8ClampedArray }} Picture */
/** @typedef {import("./geometry.js").Pair} Pair */

/** How far from a rough edge the exact one is searched, in pixels. */
const NEAR_PX = 3;
/** The places along an edge at which it is measured, away from its ends. */
const PLACES = 16, ENDS = 0.12;
/** A pixel of one colour: how far its hue may be off, and how strong and light it is at least. */
const HUE_DEG = 20, STRONG = 0.45, LIGHT = 0.2;
/** The least share of the sheet's pixels that is an object. */
const LEAST_BLOB = 0.0015;

/** The brightness of each pixel. @param {Picture} picture */
export function brightness({ width, height, data }) {
  const light = new Float32Array(width * height);
  for (let n = 0; n < light.length; n += 1) light[n] = 0.299 * data[4 * n] + 0.587 * data[4 * n + 1] + 0.114 * data[4 * n + 2];
  return light;
}

/** The brightness between pixels. @param {Float32Array} light @param {number} width @param {number} height @param {number} x @param {number} y */
export function lightAt(light, width, height, x, y) {
  // The middle of the first pixel is at 0.5.
  const [u, v] = [Math.min(Math.max(x - 0.5, 0), width - 1.001), Math.min(Math.max(y - 0.5, 0), height - 1.001)];
  const [i, j] = [Math.floor(u), Math.floor(v)], [a, b] = [u - i, v - j], at = j * width + i;
  return (light[at] * (1 - a) + light[at + 1] * a) * (1 - b) + (light[at + width] * (1 - a) + light[at + width + 1] * a) * b;
}

/**
 * The exact corners of a marker: where lines through its edges meet. The rough ones, if an edge cannot be measured.
 * @param {Float32Array} light @param {number} width @param {number} height @param {readonly Pair[]} rough @returns {Pair[]}
 */
export function exactCorners(light, width, height, rough) {
  const lines = rough.map((from, n) => edge(light, width, height, from, rough[(n + 1) % 4]));
  return rough.map((corner, n) => {
    const [before, after] = [lines[(n + 3) % 4], lines[n]];
    const met = before && after && meet(before, after);
    return met && Math.hypot(met[0] - corner[0], met[1] - corner[1]) < 2 * NEAR_PX ? met : corner;
  });
}

/** A line: a point on it and its direction. @typedef {{ at: Pair, along: Pair }} Line */

/** @param {Float32Array} light @param {number} width @param {number} height @param {Pair} from @param {Pair} to @returns {Line | null} */
function edge(light, width, height, from, to) {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]], length = Math.hypot(dx, dy);
  // Out of the marker: it is black, and its corners go clockwise.
  const out = [dy / length, -dx / length];
  /** @type {Pair[]} */ const points = [];
  for (let n = 0; n < PLACES; n += 1) {
    const part = ENDS + ((1 - 2 * ENDS) * n) / (PLACES - 1);
    const [x, y] = [from[0] + part * dx, from[1] + part * dy];
    const slopes = [];
    for (let away = -NEAR_PX; away <= NEAR_PX; away += 0.5) {
      const after = lightAt(light, width, height, x + out[0] * (away + 0.5), y + out[1] * (away + 0.5));
      slopes.push(Math.max(0, after - lightAt(light, width, height, x + out[0] * (away - 0.5), y + out[1] * (away - 0.5))));
    }
    const best = slopes.indexOf(Math.max(...slopes));
    // The middle of the slope around its steepest place.
    let [sum, moment] = [0, 0];
    for (let k = Math.max(0, best - 3); k <= Math.min(slopes.length - 1, best + 3); k += 1) [sum, moment] = [sum + slopes[k], moment + slopes[k] * k];
    if (sum < 20) continue;
    const away = -NEAR_PX + moment / sum / 2;
    points.push([x + out[0] * away, y + out[1] * away]);
  }
  return points.length < PLACES / 2 ? null : throughPoints(points);
}

/** The line through points, without those that are far off it. @param {readonly Pair[]} points @returns {Line} */
function throughPoints(points) {
  const count = points.length;
  const [mx, my] = [0, 1].map((axis) => points.reduce((sum, point) => sum + point[axis], 0) / count);
  let [xx, xy, yy] = [0, 0, 0];
  for (const [x, y] of points) [xx, xy, yy] = [xx + (x - mx) ** 2, xy + (x - mx) * (y - my), yy + (y - my) ** 2];
  const turn = Math.atan2(2 * xy, xx - yy) / 2;
  const line = /** @type {Line} */ ({ at: [mx, my], along: [Math.cos(turn), Math.sin(turn)] });
  const off = (/** @type {Pair} */ [x, y]) => Math.abs((x - mx) * line.along[1] - (y - my) * line.along[0]);
  const kept = points.filter((point) => off(point) < 0.6);
  return kept.length < count && kept.length >= PLACES / 2 ? throughPoints(kept) : line;
}

/** @param {Line} a @param {Line} b @returns {Pair | null} */
function meet(a, b) {
  const sine = a.along[0] * b.along[1] - a.along[1] * b.along[0];
  if (Math.abs(sine) < 0.1) return null;
  const far = ((b.at[0] - a.at[0]) * b.along[1] - (b.at[1] - a.at[1]) * b.along[0]) / sine;
  return [a.at[0] + far * a.along[0], a.at[1] + far * a.along[1]];
}

/** How sharp a picture is, from 0 to about 1, and which share of it is overexposed. @param {Picture} picture @param {Float32Array} light */
export function quality({ width, data }, light) {
  const slopes = new Uint32Array(256), levels = new Uint32Array(256);
  for (let n = 1; n < light.length - 1; n += 1) {
    if (n % width === 0 || n % width === width - 1) continue;
    slopes[Math.min(255, Math.abs(light[n + 1] - light[n - 1])) | 0] += 1;
    levels[light[n] | 0] += 1;
  }
  const range = level(levels, 0.99) - level(levels, 0.01);
  let over = 0;
  for (let n = 0; n < data.length; n += 4) if (data[n] > 252 && data[n + 1] > 252 && data[n + 2] > 252) over += 1;
  return { sharpness: level(slopes, 0.998) / Math.max(range, 30), overexposed: over / light.length };
}

/** The value that a share of all does not exceed. @param {Uint32Array} counts @param {number} share */
function level(counts, share) {
  const wanted = share * counts.reduce((sum, count) => sum + count, 0);
  let sum = 0;
  return counts.findIndex((count) => (sum += count) >= wanted);
}

/**
 * The largest blob of a hue on the sheet: its middle in pixels; null if there is none.
 * @param {Picture} picture @param {import("./geometry.js").SheetView} view @param {number} hue_deg @param {readonly [Pair, Pair]} area the corners of the sheet to look at, in mm
 * @returns {Pair | null}
 */
export function blobOfHue({ width, height, data }, view, hue_deg, [low, high]) {
  const STEP = 2, wide = Math.floor(width / STEP), tall = Math.floor(height / STEP);
  const fits = new Uint8Array(wide * tall);
  let inside = 0;
  for (let n = 0; n < fits.length; n += 1) {
    const [x, y] = [(n % wide) * STEP, Math.floor(n / wide) * STEP], at = 4 * (y * width + x);
    const [ahead, left] = onSheet(view, [x + 0.5, y + 0.5]);
    if (ahead < low[0] || ahead > high[0] || left < low[1] || left > high[1]) continue;
    inside += 1;
    if (hasHue(data[at], data[at + 1], data[at + 2], hue_deg)) fits[n] = 1;
  }
  /** @type {{ count: number, x: number, y: number }} */ let best = { count: 0, x: 0, y: 0 };
  for (let start = 0; start < fits.length; start += 1) {
    if (fits[start] !== 1) continue;
    const blob = { count: 0, x: 0, y: 0 }, open = [start];
    fits[start] = 2;
    for (let n = open.pop(); n !== undefined; n = open.pop()) {
      blob.count += 1;
      blob.x += (n % wide) * STEP + STEP / 2;
      blob.y += Math.floor(n / wide) * STEP + STEP / 2;
      for (const next of [n - 1, n + 1, n - wide, n + wide]) if (fits[next] === 1) (fits[next] = 2), open.push(next);
    }
    if (blob.count > best.count) best = blob;
  }
  return best.count > inside * LEAST_BLOB ? [best.x / best.count, best.y / best.count] : null;
}

/** @param {number} red @param {number} green @param {number} blue @param {number} hue_deg */
function hasHue(red, green, blue, hue_deg) {
  const most = Math.max(red, green, blue), spread = most - Math.min(red, green, blue);
  if (most < LIGHT * 255 || spread < STRONG * most) return false;
  const sixth = most === red ? (green - blue) / spread : most === green ? 2 + (blue - red) / spread : 4 + (red - green) / spread;
  const off = Math.abs(((sixth * 60 - hue_deg + 540) % 360) - 180);
  return off <= HUE_DEG;
}
