// The camera of the stage: it orbits a point. Pure.
//
// `around_deg` is measured counter-clockwise from the arm's forward direction, `up_deg` from the horizontal.

import { rad } from "./kinematics.js";

/** @typedef {import("./view.js").Preset} Preset */
/** @typedef {import("./view.js").Point} Point */
/** @typedef {{ at_mm: Point, around_deg: number, up_deg: number, away_mm: number }} Camera */

export const LENS_DEG = 26;
const NEAR_MM = 160;
const FAR_MM = 3200;
/** The middle of what is to be seen, and how far around it. @type {Point} */
const MIDDLE_MM = [120, 0, 6];
const AROUND_MM = 236;

/**
 * A preset that shows all of the arm in a window of this shape.
 * @param {Preset} name
 * @param {number} aspect width by height
 * @param {Point} tip where the tool is, for the view of it
 * @returns {Camera}
 */
export function preset(name, aspect, tip) {
  const away_mm = fit(AROUND_MM, aspect);
  switch (name) {
    case "top": return { at_mm: [150, 0, -60], around_deg: 180, up_deg: 89.9, away_mm: away_mm * 1.1 };
    case "side": return { at_mm: MIDDLE_MM, around_deg: -90, up_deg: 4, away_mm };
    case "tool": return { at_mm: [tip[0], tip[1], tip[2] + 18], around_deg: -32, up_deg: 20, away_mm: fit(118, aspect) };
    default: return { at_mm: MIDDLE_MM, around_deg: -52, up_deg: 27, away_mm };
  }
}

/**
 * From how far a ball fills the window.
 * @param {number} radius_mm
 * @param {number} aspect
 */
function fit(radius_mm, aspect) {
  const half = Math.tan(rad(LENS_DEG / 2)) * Math.min(1, aspect);
  return radius_mm / Math.sin(Math.atan(half));
}

/**
 * @param {Camera} camera
 * @returns {Point}
 */
export function place({ at_mm: [x, y, z], around_deg, up_deg, away_mm }) {
  const level = away_mm * Math.cos(rad(up_deg));
  return [x + level * Math.cos(rad(around_deg)), y + level * Math.sin(rad(around_deg)), z + away_mm * Math.sin(rad(up_deg))];
}

/**
 * Turns about what it looks at; never below the table's side, never over the top.
 * @param {Camera} camera
 * @param {number} around_deg
 * @param {number} up_deg
 */
export function orbit(camera, around_deg, up_deg) {
  return { ...camera, around_deg: camera.around_deg + around_deg, up_deg: clamp(camera.up_deg + up_deg, -8, 89.9) };
}

/**
 * @param {Camera} camera
 * @param {number} times more than 1 comes nearer
 */
export function zoom(camera, times) {
  return { ...camera, away_mm: clamp(camera.away_mm / times, NEAR_MM, FAR_MM) };
}

/**
 * Moves what is looked at, in the plane of the picture.
 * @param {Camera} camera
 * @param {number} right_mm
 * @param {number} up_mm
 * @returns {Camera}
 */
export function pan(camera, right_mm, up_mm) {
  const around = rad(camera.around_deg), up = rad(camera.up_deg);
  const [x, y, z] = camera.at_mm;
  const back = -up_mm * Math.sin(up);
  return {
    ...camera,
    at_mm: [
      clamp(x - right_mm * Math.sin(around) + back * Math.cos(around), -400, 500),
      clamp(y + right_mm * Math.cos(around) + back * Math.sin(around), -400, 400),
      clamp(z + up_mm * Math.cos(up), -150, 300),
    ],
  };
}

/**
 * Interpolates between two cameras along the shorter turn; `share` is 0 to 1.
 * @param {Camera} from
 * @param {Camera} to
 * @param {number} share
 * @returns {Camera}
 */
export function towards(from, to, share) {
  const eased = share * share * (3 - 2 * share);
  /** @param {number} a @param {number} b */
  const mix = (a, b) => a + (b - a) * eased;
  const turn = ((((to.around_deg - from.around_deg) % 360) + 540) % 360) - 180;
  return {
    at_mm: /** @type {Point} */ (from.at_mm.map((a, n) => mix(a, /** @type {number} */ (to.at_mm[n])))),
    around_deg: share >= 1 ? to.around_deg : from.around_deg + turn * eased,
    up_deg: mix(from.up_deg, to.up_deg),
    away_mm: mix(from.away_mm, to.away_mm),
  };
}

/**
 * @param {number} value
 * @param {number} min
 * @param {number} max
 */
const clamp = (value, min, max) => Math.min(Math.max(value, min), max);
