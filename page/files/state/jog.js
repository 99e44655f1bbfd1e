// Settings of the jog buttons, and the result of the last press.

/** @typedef {"linear" | "joint"} Frame */
/** A jog axis, such as `y_plus` or `base_minus`. @typedef {string} Axis */

/**
 * @typedef {object} Jog
 * @property {Frame} frame The jog frame: the tip in straight lines, or one joint.
 * @property {number | null} step Step of a press in mm or degrees; null for continuous motion.
 * @property {number} speed_percent
 * @property {Axis | null} held
 * @property {{ axis: Axis, detail: string } | null} refused Why the last press was refused, until the next press.
 */

/** @type {Jog} */
export const NO_JOG = { frame: "linear", step: null, speed_percent: 30, held: null, refused: null };

/** @typedef {{ type: "jog_set", set: Partial<Pick<Jog, "frame" | "step" | "speed_percent">> }
 * | { type: "jog_held", axis: Axis | null }
 * | { type: "jog_refused", axis: Axis, detail: string }} JogMessage */

/** @param {Jog} jog @param {import("./message.js").Message} message @returns {Jog} */
export function reduceJog(jog, message) {
  switch (message.type) {
    case "jog_set":
      return { ...jog, ...message.set };
    case "jog_held":
      return { ...jog, held: message.axis, refused: message.axis ? null : jog.refused };
    case "jog_refused":
      return { ...jog, refused: { axis: message.axis, detail: message.detail } };
    default:
      return jog;
  }
}
