// Buttons that people have added, for all pages of the station.

/** @typedef {import("./types.js").Schemas} Schemas */
/** @typedef {import("./types.js").Problem} Problem */
/** @typedef {Schemas["CustomButton"]} CustomButton */

/**
 * @typedef {object} Buttons
 * @property {readonly CustomButton[]} all
 * @property {boolean} edits Whether buttons are being added and removed.
 * @property {Problem | null} refused Why the last change was refused.
 */

/** @type {Buttons} */
export const NO_BUTTONS = { all: [], edits: false, refused: null };

/** The colours; red is that of STOP. @type {readonly CustomButton["color"][]} */
export const COLORS = ["grey", "blue", "green", "yellow", "purple"];

/** The effects that a new button can have. */
export const EFFECTS = /** @type {const} */ (["position", "program", "suction_on", "suction_off"]);
/** @typedef {typeof EFFECTS[number]} Effect */

/** @typedef {{ type: "buttons", all: readonly CustomButton[] }
 * | { type: "buttons_edited", edits: boolean }
 * | { type: "button_refused", problem: Problem }} ButtonsMessage */

/** @param {Buttons} buttons @param {import("./message.js").Message} message @returns {Buttons} */
export function reduceButtons(buttons, message) {
  switch (message.type) {
    case "buttons":
      return { ...buttons, all: message.all, refused: null };
    case "buttons_edited":
      return { ...buttons, edits: message.edits, refused: null };
    case "button_refused":
      return { ...buttons, refused: message.problem };
    default:
      return buttons;
  }
}

/** Why no button with this effect can be added now: the end of a text key. @param {Effect} effect @param {import("./state.js").Page} page @returns {"no_arm" | "moving" | "no_program" | null} */
export function lacks(effect, { station, teach }) {
  if (effect === "program") return teach.text.trim() === "" ? "no_program" : null;
  if (effect !== "position") return null;
  if (!station?.arm) return "no_arm";
  return station.arm.moving ? "moving" : null;
}

/** The effect of a new button: the position is that of the arm, the program that of Teach. @param {Effect} effect @param {import("./state.js").Page} page @returns {CustomButton["action"]} */
export function actionOf(effect, { station, target, teach }) {
  switch (effect) {
    case "position": {
      const { x_mm = 0, y_mm = 0, z_mm = 0, rotation_deg = 0 } = station?.arm ?? {};
      const mode = target.path === "vector" ? "movl" : target.path;
      return { type: "position", x_mm, y_mm, z_mm, rotation_deg, mode };
    }
    case "program":
      return { type: "program", text: teach.text };
    default:
      return { type: "command", command: { type: "joint_jog", axis: effect, speed_percent: 0 } };
  }
}
