// Where the links of the arm are: its two parallelograms as they are built. Pure.
//
// The arm turns about Z as a whole; what is calculated here lies in its own plane, as `[reach, z]` in mm from the rear arm's
// pivot. The rear arm and a rod beside it carry a plate at the elbow that stays level; the forearm and a rod beside it carry
// the wrist, which stays level by that plate. A crank at the shoulder and a third rod turn the forearm.

/** @typedef {import("./view.js").Joints} Joints */
/** @typedef {import("./view.js").Pose} Pose */
/** @typedef {import("./view.js").Tool} Tool */
/** @typedef {[number, number]} InPlane Reach and z. */

/** From pivot to elbow, in mm. */
export const REAR_MM = 135;
/** From elbow to wrist, in mm. */
export const FORE_MM = 160;
/** From the crank's pivot to its end, and from the elbow to the tail of the forearm. */
export const CRANK_MM = 42;
/** From the shoulder to where the rear rod is held, and the same at the elbow. @type {InPlane} */
export const REAR_ROD_AT_MM = [-27, 22];
/** From the elbow to where the front rod is held, and the same at the wrist. @type {InPlane} */
export const FRONT_ROD_AT_MM = [20, 22];

/** From the wrist to the tool's axis, level. @type {Record<Tool, number>} */
const BEYOND_MM = { suction_cup: 55.07, gripper: 55.07, pen: 55.07, laser: 49.57 };

/** @param {Tool} kind */
export const beyondWrist = (kind) => BEYOND_MM[kind];

/**
 * All joints of the arm in its plane.
 * @param {Joints} joints
 * @param {Tool} kind
 */
export function links({ rear_deg, fore_deg }, kind) {
  const rear = rad(rear_deg), fore = rad(fore_deg);
  /** @type {InPlane} */ const along = [Math.cos(fore), -Math.sin(fore)];
  /** @type {InPlane} */ const elbow = [REAR_MM * Math.sin(rear), REAR_MM * Math.cos(rear)];
  const wrist = plus(elbow, along, FORE_MM);
  return {
    elbow,
    wrist,
    /** Above the tip of the tool, at the height of the wrist. */
    tool: plus(wrist, [1, 0], BEYOND_MM[kind]),
    /** The end of the crank, and the tail of the forearm: a rod as long as the rear arm is between them. */
    crank: plus([0, 0], along, -CRANK_MM),
    tail: plus(elbow, along, -CRANK_MM),
    rearRod: /** @type {[InPlane, InPlane]} */ ([REAR_ROD_AT_MM, plus(elbow, REAR_ROD_AT_MM, 1)]),
    frontRod: /** @type {[InPlane, InPlane]} */ ([plus(elbow, FRONT_ROD_AT_MM, 1), plus(wrist, FRONT_ROD_AT_MM, 1)]),
  };
}

/**
 * Where the joints bring the tool.
 * @param {Joints} joints
 * @param {Tool} kind
 * @returns {Pose}
 */
export function forward(joints, kind) {
  const [reach, z_mm] = links(joints, kind).tool;
  const base = rad(joints.base_deg);
  return { x_mm: reach * Math.cos(base), y_mm: reach * Math.sin(base), z_mm, rotation_deg: joints.base_deg + joints.servo_deg };
}

/**
 * The joints that bring the tool to a pose, elbow up; nothing where the links are too short or too long. Limits are not looked at.
 * @param {Pose} pose
 * @param {Tool} kind
 * @returns {Joints | null}
 */
export function inverse({ x_mm, y_mm, z_mm, rotation_deg }, kind) {
  const across = Math.hypot(x_mm, y_mm) - BEYOND_MM[kind];
  const distance = Math.hypot(across, z_mm);
  if (!(distance >= FORE_MM - REAR_MM && distance <= FORE_MM + REAR_MM)) return null;
  const elevation = Math.atan2(z_mm, across);
  const alpha = Math.acos((distance ** 2 + REAR_MM ** 2 - FORE_MM ** 2) / (2 * REAR_MM * distance));
  const gamma = Math.acos((distance ** 2 + FORE_MM ** 2 - REAR_MM ** 2) / (2 * FORE_MM * distance));
  const base_deg = deg(Math.atan2(y_mm, x_mm));
  return { base_deg, rear_deg: 90 - deg(elevation + alpha), fore_deg: deg(gamma - elevation), servo_deg: rotation_deg - base_deg };
}

/**
 * @param {readonly number[]} from
 * @param {readonly number[]} way
 * @param {number} times
 * @returns {InPlane}
 */
function plus([r = 0, z = 0], [dr = 0, dz = 0], times) {
  return [r + dr * times, z + dz * times];
}

/** @param {number} degrees */
export const rad = (degrees) => (degrees * Math.PI) / 180;
/** @param {number} radians */
export const deg = (radians) => (radians * 180) / Math.PI;
