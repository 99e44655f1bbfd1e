// Settings of the jog buttons, and the result of the last press.

/** @typedef {"linear" | "joint"} Frame */
/** A jog axis, such as `y_plus` or `base_minus`. @typedef {string} Axis */

/**
 * @typedef {object} Jog
 * @property {Frame} frame The jog frame: the tip in straight lines, or one joint.
 * @property {boolean} floats Whether the pad is unfolded over the picture, beside the panels in which the arm is positioned.
 * @property {number | null} step Step of a press in mm or degrees; null for continuous motion.
 * @property {number} speed_percent
 * @property {Axis | null} held
 * @property {number | null} waits_until_s While the arm comes to rest after an earlier motion: until when the press waits at most, by the station's clock.
 * @property {{ axis: Axis, problem: import("./types.js").Problem } | null} refused Why the last press was refused, until the next press.
 */

/** @type {Jog} */
export const NO_JOG = { frame: "linear", floats: false, step: null, speed_percent: 30, held: null, waits_until_s: null, refused: null };

/** @typedef {{ type: "jog_set", set: Partial<Pick<Jog, "frame" | "floats" | "step" | "speed_percent">> }
 * | { type: "jog_held", axis: Axis | null, waits_until_s?: number | null }
 * | { type: "jog_refused", axis: Axis, problem: import("./types.js").Problem }} JogMessage */

/** @param {Jog} jog @param {import("./message.js").Message} message @returns {Jog} */
export function reduceJog(jog, message) {
  switch (message.type) {
    case "jog_set":
      return { ...jog, ...message.set };
    case "jog_held":
      return { ...jog, held: message.axis, waits_until_s: message.waits_until_s ?? null, refused: message.axis ? null : jog.refused };
    case "jog_refused":
      return { ...jog, refused: { axis: message.axis, problem: message.problem } };
    case "state": {
      const { arm, at_s } = message.station;
      return jog.waits_until_s !== null && (!arm?.moving || at_s > jog.waits_until_s) ? { ...jog, waits_until_s: null } : jog;
    }
    default:
      return jog;
  }
}
