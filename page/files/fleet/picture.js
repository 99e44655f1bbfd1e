// A small picture of an arm, seen from the front right, so that reach, height and direction are visible together. It is cheap
// enough for a hundred of them; the calculations are pure functions.

import { links, rad } from "../stage/kinematics.js";
import { css, colorsOf } from "../stage/colors.js";

/** @typedef {import("../stage/view.js").Joints} Joints */
/** @typedef {import("../stage/view.js").Point} Point */
/** @typedef {[number, number]} Place To the right and down, in px. */
/** @typedef {{ width: number, height: number, density: number }} Size */
/** @typedef {import("../state/types.js").Facts} Facts */
/** @typedef {{ facts: Facts, joints: Joints | null, dark: boolean, old: boolean, laser: import("../stage/view.js").View["laser"], size: Size }} Shown */

/** From where it is seen: about the Z axis, and above the table. */
const AZIMUTH = rad(-58), ELEVATION = rad(24);
const RIGHT = [-Math.sin(AZIMUTH), Math.cos(AZIMUTH), 0];
const UP = [-Math.cos(AZIMUTH) * Math.sin(ELEVATION), -Math.sin(AZIMUTH) * Math.sin(ELEVATION), Math.cos(ELEVATION)];
/** The visible area in mm: right and up. */
const ROOM = { right: [-318, 335], up: [-236, 205] };

/** A point as it is seen, in mm to the right and up. @param {Point} point @returns {[number, number]} */
export const seen = (point) => /** @type {[number, number]} */ ([RIGHT, UP].map((axis) => axis.reduce((sum, it, n) => sum + it * (point[n] ?? 0), 0)));

/** Positions of the arm's joints and of the tip of its first tool. @param {Joints} joints @param {Facts} facts */
export function armAt(joints, { dimensions, tools: [tool] }) {
  const it = links(joints, { ...dimensions, reach_mm: tool?.reach_mm ?? 0 }), base = rad(joints.base_deg);
  const at = ([r = 0, z = 0]) => /** @type {Point} */ ([r * Math.cos(base), r * Math.sin(base), z]);
  return {
    shoulder: at([0, 0]),
    elbow: at(it.elbow),
    wrist: at(it.wrist),
    tool: at(it.tool),
    tip: at([it.tool[0], it.tool[1] - (tool?.length_mm ?? 0)]),
    tail: at(it.tail),
    crank: at(it.crank),
    rods: [it.rearRod, it.frontRod].map((rod) => rod.map(at)),
  };
}

/** @param {Size} size @returns {(point: Point) => Place} */
export function placer({ width, height }) {
  const { right: [r0 = 0, r1 = 0], up: [u0 = 0, u1 = 0] } = ROOM;
  const scale = Math.min(width / (r1 - r0), height / (u1 - u0));
  return (point) => {
    const [right, up] = seen(point);
    return [width / 2 + (right - (r0 + r1) / 2) * scale, height / 2 - (up - (u0 + u1) / 2) * scale];
  };
}

/** The border of what the arm reaches on the table. @param {Facts} facts @returns {Point[]} */
function reach({ dimensions, joints, workspace }) {
  const [near = 0, far = 0] = workspace.reach_mm, [least = 0, most = 0] = joints.base_deg;
  const arc = (/** @type {number} */ radius) => Array.from({ length: 37 }, (_, n) => {
    const turn = rad(least + ((most - least) * n) / 36);
    return /** @type {Point} */ ([radius * Math.cos(turn), radius * Math.sin(turn), -dimensions.pivot_above_table_mm]);
  });
  return [...arc(far), ...arc(near).reverse()];
}

/** Calculated once for all pictures. @type {WeakMap<Facts, Point[]>} */ const grounds = new WeakMap();

/** @param {Facts} facts */
function groundOf(facts) {
  const ground = grounds.get(facts) ?? reach(facts);
  grounds.set(facts, ground);
  return ground;
}

/** @param {CanvasRenderingContext2D} pen @param {Shown} shown */
export function paint(pen, { facts, joints, dark, old, laser, size }) {
  /** The ground below a point. @param {Point} point @returns {Point} */
  const below = ([x, y]) => [x, y, -facts.dimensions.pivot_above_table_mm];
  const look = colorsOf(dark), at = placer(size), thick = Math.max(3, size.height / 17);
  /** @param {readonly Point[]} points @param {number} color @param {number} wide @param {number} [alpha] */
  const line = (points, color, wide, alpha = 1) => {
    path(points);
    pen.globalAlpha = alpha;
    pen.strokeStyle = css(color);
    pen.lineWidth = wide;
    pen.stroke();
    pen.globalAlpha = 1;
  };
  const path = (/** @type {readonly Point[]} */ points) => {
    pen.beginPath();
    for (const point of points) pen.lineTo(...at(point));
  };
  const dot = (/** @type {Point} */ point, /** @type {number} */ radius, /** @type {number} */ color) => {
    pen.beginPath();
    pen.arc(...at(point), radius, 0, 2 * Math.PI);
    pen.fillStyle = css(color);
    pen.fill();
  };
  pen.setTransform(size.density, 0, 0, size.density, 0, 0);
  pen.clearRect(0, 0, size.width, size.height);
  pen.lineCap = pen.lineJoin = "round";
  path(groundOf(facts));
  pen.closePath();
  pen.fillStyle = css(look.table);
  pen.fill();
  pen.strokeStyle = css(look.tableEdge);
  pen.lineWidth = 1;
  pen.stroke();
  if (!joints) return;
  const arm = armAt(joints, facts);
  const metal = old ? look.pin : look.metal, joint = old ? look.pin : look.accent, rim = look.dark;
  // The shadow shows height and direction.
  line([arm.shoulder, arm.elbow, arm.wrist, arm.tool].map(below), 0x000000, thick, dark ? 0.3 : 0.13);
  line([arm.tip, below(arm.tip)], look.grid, 1, 0.8);
  dot(below(arm.tip), 2, look.grid);
  // The column, and the arm with a rim, so that it stands out on the table in both themes.
  line([below(arm.shoulder), arm.shoulder], rim, thick * 2.1);
  for (const rod of arm.rods) line(rod, look.grid, Math.max(1, thick / 4));
  for (const part of [[arm.tail, arm.elbow, arm.wrist], [arm.shoulder, arm.elbow]]) {
    line(part, rim, thick + 1.5);
    line(part, metal, thick);
  }
  line([arm.wrist, arm.tool], rim, thick * 0.8);
  line([arm.tool, arm.tip], joint, thick * 0.55);
  for (const point of [arm.shoulder, arm.elbow, arm.wrist]) dot(point, thick * 0.42, joint);
  if (laser === "burning") {
    line([arm.tip, below(arm.tip)], look.beam, 2);
    dot(below(arm.tip), 3.5, look.beam);
  }
}
