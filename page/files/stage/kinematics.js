// Positions of the arm's links: its two parallelograms. Pure; the lengths come from the station.
//
// The whole arm rotates about Z; these functions calculate in its plane, as `[reach, z]` in mm from the rear arm's pivot.
// The rear arm and a parallel rod carry a plate at the elbow that stays level; the forearm and a parallel rod carry
// the wrist, which stays level with that plate. A crank at the shoulder and a third rod move the forearm.

/** @typedef {import("./view.js").Joints} Joints */
/** @typedef {import("./view.js").Pose} Pose */
/** @typedef {import("./view.js").ArmShape} ArmShape */
/** @typedef {[number, number]} InPlane Reach and z. */

/**
 * Returns all joints in the arm's plane.
 * @param {Joints} joints
 * @param {ArmShape} shape
 */
export function links({ rear_deg, fore_deg }, { rear_arm_mm, forearm_mm, crank_mm, rear_rod_at_mm, front_rod_at_mm, reach_mm }) {
  const rear = rad(rear_deg), fore = rad(fore_deg);
  /** @type {InPlane} */ const along = [Math.cos(fore), -Math.sin(fore)];
  /** @type {InPlane} */ const elbow = [rear_arm_mm * Math.sin(rear), rear_arm_mm * Math.cos(rear)];
  const wrist = plus(elbow, along, forearm_mm);
  return {
    elbow,
    wrist,
    /** Above the tip of the tool, at the height of the wrist. */
    tool: plus(wrist, [1, 0], reach_mm),
    /** The end of the crank, and the tail of the forearm: a rod as long as the rear arm is between them. */
    crank: plus([0, 0], along, -crank_mm),
    tail: plus(elbow, along, -crank_mm),
    rearRod: /** @type {[InPlane, InPlane]} */ ([plus([0, 0], rear_rod_at_mm, 1), plus(elbow, rear_rod_at_mm, 1)]),
    frontRod: /** @type {[InPlane, InPlane]} */ ([plus(elbow, front_rod_at_mm, 1), plus(wrist, front_rod_at_mm, 1)]),
  };
}

/**
 * Returns the tool pose for joint angles.
 * @param {Joints} joints
 * @param {ArmShape} shape
 * @returns {Pose}
 */
export function forward(joints, shape) {
  const [reach, z_mm] = links(joints, shape).tool;
  const base = rad(joints.base_deg);
  return { x_mm: reach * Math.cos(base), y_mm: reach * Math.sin(base), z_mm, rotation_deg: joints.base_deg + joints.servo_deg };
}

/**
 * The joints that bring the tool to a pose, elbow up; nothing where the links are too short or too long. Limits are not looked at.
 * @param {Pose} pose
 * @param {ArmShape} shape
 * @returns {Joints | null}
 */
export function inverse({ x_mm, y_mm, z_mm, rotation_deg }, { rear_arm_mm: rear, forearm_mm: fore, reach_mm }) {
  const across = Math.hypot(x_mm, y_mm) - reach_mm;
  const distance = Math.hypot(across, z_mm);
  if (!(distance >= fore - rear && distance <= fore + rear)) return null;
  const elevation = Math.atan2(z_mm, across);
  const alpha = Math.acos((distance ** 2 + rear ** 2 - fore ** 2) / (2 * rear * distance));
  const gamma = Math.acos((distance ** 2 + fore ** 2 - rear ** 2) / (2 * fore * distance));
  const base_deg = deg(Math.atan2(y_mm, x_mm));
  return { base_deg, rear_deg: 90 - deg(elevation + alpha), fore_deg: deg(gamma - elevation), servo_deg: rotation_deg - base_deg };
}

/**
 * @param {readonly number[]} from
 * @param {readonly number[]} direction
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
