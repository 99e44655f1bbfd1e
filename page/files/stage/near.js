// Which limits the tool is near to: the stage shows them there, and nowhere else. Pure.

import { forward } from "./links.js";

/** @typedef {import("./view.js").Joints} Joints */
/** @typedef {import("./view.js").Limits} Limits */
/** @typedef {import("./view.js").Tool} Tool */
/** @typedef {"base" | "rear" | "fore" | "servo" | "opening" | "x" | "y" | "z" | "reach"} Quantity */

/**
 * A bound of a quantity that is near: how near, from 0 (20 mm or 5 degrees off) to 1 (there, or beyond it).
 * @typedef {{ quantity: Quantity, bound: number, closeness: number }} Near
 */

export const NEAR_MM = 20;
export const NEAR_DEG = 5;

/**
 * @param {Joints} joints
 * @param {Tool} kind
 * @param {Limits} limits
 * @returns {Near[]}
 */
export function nearLimits(joints, kind, { joints: turns, workspace }) {
  const { x_mm, y_mm, z_mm } = forward(joints, kind);
  return [
    ...ends("base", joints.base_deg, turns.base_deg, NEAR_DEG),
    ...ends("rear", joints.rear_deg, turns.rear_deg, NEAR_DEG),
    ...ends("fore", joints.fore_deg, turns.fore_deg, NEAR_DEG),
    ...ends("servo", joints.servo_deg, turns.servo_deg, NEAR_DEG),
    ...ends("opening", joints.rear_deg - joints.fore_deg, turns.opening_deg, NEAR_DEG),
    ...ends("x", x_mm, workspace.x_mm, NEAR_MM),
    ...ends("y", y_mm, workspace.y_mm, NEAR_MM),
    ...ends("z", z_mm, workspace.z_mm, NEAR_MM),
    ...ends("reach", Math.hypot(x_mm, y_mm), workspace.reach_mm, NEAR_MM),
  ];
}

/**
 * @param {Quantity} quantity
 * @param {number} value
 * @param {readonly number[]} bounds
 * @param {number} within
 * @returns {Near[]}
 */
function ends(quantity, value, [min = -Infinity, max = Infinity], within) {
  const near = [{ bound: min, room: value - min }, { bound: max, room: max - value }];
  return near.filter(({ room }) => room < within).map(({ bound, room }) => ({ quantity, bound, closeness: Math.min(1, 1 - room / within) }));
}

/**
 * How near a place is to a keep-out, as above; 0 where it is not near.
 * @param {import("./view.js").Box | import("./view.js").Cylinder} keepOut
 * @param {readonly [number, number, number]} at
 */
export function nearKeepOut(keepOut, [x, y, z]) {
  const off = "box" in keepOut
    ? Math.hypot(beside(x, keepOut.box.x_mm), beside(y, keepOut.box.y_mm), beside(z, keepOut.box.z_mm))
    : Math.hypot(
        Math.max(0, Math.hypot(x - keepOut.cylinder.x_mm, y - keepOut.cylinder.y_mm) - keepOut.cylinder.radius_mm),
        beside(z, keepOut.cylinder.z_mm),
      );
  return Math.max(0, 1 - off / NEAR_MM);
}

/**
 * @param {number} value
 * @param {readonly number[]} bounds
 */
const beside = (value, [min = 0, max = 0]) => Math.max(min - value, value - max, 0);
