// Area and resolution of the picture of the marks. Pure.

/** @typedef {import("./view.js").View} View */
/** @typedef {{ from_mm: [number, number], to_mm: [number, number] }} Area */

/** Finer than that no eye sees; and no more in all than the card of a small computer has room for. */
const FINE_PX_MM = 10;
const SIDE_PX = 4096;
const ALL_PX = 8e6;
/** It grows by whole steps, since growing means to draw all again. */
const STEP_MM = 40;

/**
 * The area that holds the one there was, and the marks from one on; the same object where that one is large enough.
 * @param {Area | null} area
 * @param {readonly number[]} ends_mm
 * @param {number} from
 * @returns {Area | null}
 */
export function areaOf(area, ends_mm, from) {
  let [x0, y0, x1, y1] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let n = from; n + 1 < ends_mm.length; n += 2) {
    const x = ends_mm[n] ?? 0, y = ends_mm[n + 1] ?? 0;
    x0 = Math.min(x0, x), x1 = Math.max(x1, x), y0 = Math.min(y0, y), y1 = Math.max(y1, y);
  }
  if (x0 > x1) return area;
  if (area && x0 >= area.from_mm[0] && y0 >= area.from_mm[1] && x1 <= area.to_mm[0] && y1 <= area.to_mm[1]) return area;
  const least = (/** @type {number} */ value) => Math.floor(value / STEP_MM - 0.1) * STEP_MM;
  const most = (/** @type {number} */ value) => Math.ceil(value / STEP_MM + 0.1) * STEP_MM;
  return {
    from_mm: [Math.min(least(x0), area?.from_mm[0] ?? Infinity), Math.min(least(y0), area?.from_mm[1] ?? Infinity)],
    to_mm: [Math.max(most(x1), area?.to_mm[0] ?? -Infinity), Math.max(most(y1), area?.to_mm[1] ?? -Infinity)],
  };
}

/**
 * Returns the resolution in pixels per millimetre.
 * @param {Area} area
 */
export function fineness({ from_mm: [x0, y0], to_mm: [x1, y1] }) {
  const [wide, tall] = [x1 - x0, y1 - y0];
  return Math.min(FINE_PX_MM, SIDE_PX / Math.max(wide, tall), Math.sqrt(ALL_PX / (wide * tall)));
}
