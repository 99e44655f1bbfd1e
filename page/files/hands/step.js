// @ts-check
// A step of the jog buttons: where the arm goes when a button means a distance, not a time.

/** @typedef {import("../api").components["schemas"]} Schemas */
/** @typedef {Extract<Schemas["Command"], {type: "move_to"} | {type: "move_joints"}>} Step */

/** @type {Record<string, string>} */
const FIELDS = { x: "x_mm", y: "y_mm", z: "z_mm", base: "base_deg", rear: "rear_deg", fore: "fore_deg", servo: "servo_deg" };

/** The target that is the place itself. @param {Schemas["ArmView"]} arm @param {"linear" | "joint"} frame @returns {Step} */
function here(arm, frame) {
  const { suction, gripper_deg } = arm;
  if (frame === "linear") {
    const { x_mm, y_mm, z_mm, rotation_deg } = arm;
    return { type: "move_to", x_mm, y_mm, z_mm, rotation_deg, suction, gripper_deg, mode: "movl", pause_s: 0 };
  }
  const { base_deg, rear_deg, fore_deg, servo_deg } = arm;
  return { type: "move_joints", base_deg, rear_deg, fore_deg, servo_deg, suction, gripper_deg, mode: "movj", pause_s: 0 };
}

/**
 * The command for one step. The turn of the tool is that of its rotation where the tip moves, and of the servo where a
 * joint does. While an earlier step is under way the next one begins where that one ends.
 * @param {Schemas["ArmView"]} arm @param {"linear" | "joint"} frame @param {string} axis as `x_plus`
 * @param {number} by millimetres or degrees @param {Step} [before] the step that is under way
 * @returns {Step}
 */
export function step(arm, frame, axis, by, before) {
  const begin = here(arm, frame);
  const from = before?.type === begin.type ? before : begin;
  const [name = "", way] = axis.split("_");
  const field = frame === "linear" && name === "servo" ? "rotation_deg" : FIELDS[name];
  const value = Number(/** @type {Record<string, unknown>} */ (from)[field ?? ""]) + (way === "plus" ? by : -by);
  return { ...from, suction: arm.suction, gripper_deg: arm.gripper_deg, [field ?? ""]: value };
}
