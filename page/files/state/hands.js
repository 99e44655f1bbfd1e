// A hand in front of the camera that moves the arm.

/**
 * @typedef {object} Hands
 * @property {"closed" | "not_installed" | "asking" | "loading" | "on" | "refused"} view
 * @property {string | null} refused Why there is no camera, or why the last packet was refused: the end of a text key, or words.
 * @property {import("../vision/hand.js").Meaning["state"]} state
 * @property {number} share How much of the time until the hand takes control is over, in tenths.
 * @property {boolean} closed Whether the hand is pinched.
 */

/** @type {Hands} */
export const NO_HANDS = { view: "closed", refused: null, state: "none", share: 0, closed: false };

/** @typedef {{ type: "hands_set", set: Partial<Hands> }} HandsMessage */

/** @param {Hands} hands @param {import("./message.js").Message} message @returns {Hands} */
export function reduceHands(hands, message) {
  if (message.type !== "hands_set") return hands;
  const next = { ...hands, ...message.set };
  return /** @type {(keyof Hands)[]} */ (Object.keys(next)).every((key) => next[key] === hands[key]) ? hands : next;
}
