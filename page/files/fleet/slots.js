// Time slots for a class. Pure.

import { problemOf } from "./outcome.js";

/** @typedef {import("../state/slots.js").TimeSlot} TimeSlot */
/** @typedef {import("./members.js").Member} Member */
/** @typedef {import("./state.js").MemberAnswer} MemberAnswer */
/** The slots of one arm. @typedef {{ name: string, id: string, slots: TimeSlot[] }} Share */

/** Names as a teacher writes them, one per line. @param {string} text */
export const namesOf = (text) => text.split("\n").map((name) => name.trim()).filter(Boolean);

/**
 * Deals names over arms in turn; at each arm one comes after the other, from now on.
 * @param {readonly string[]} names @param {number} minutes @param {readonly Member[]} members @param {string | null} group @returns {Share[]}
 */
export function deal(names, minutes, members, group) {
  const each_s = 60 * minutes;
  const slot = (/** @type {string} */ student, /** @type {number} */ turn) => ({ student, ...(group && { group }), starts_in_s: turn * each_s, ends_in_s: (turn + 1) * each_s });
  const shares = members.map(({ name, id }, n) => ({ name, id, slots: names.filter((_, it) => it % members.length === n).map(slot) }));
  // An arm for which no name is left keeps what it has.
  return shares.filter(({ slots }) => slots.length > 0);
}

/** The slots of each station that has successful them, by its number. @param {readonly MemberAnswer[]} answers @returns {Record<string, readonly TimeSlot[]>} */
export function listsOf(answers) {
  const successful = answers.filter(({ answer }) => !problemOf(answer));
  return Object.fromEntries(successful.map(({ id, answer }) => [id, /** @type {{ slots?: TimeSlot[] }} */ (answer.body).slots ?? []]));
}
