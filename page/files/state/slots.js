// Whose time it is at an arm, as its station tells it. Pure.

/** @typedef {import("./types.js").Schemas} Schemas */
/** @typedef {Schemas["TimeSlot"]} TimeSlot */
/** A time slot that is under way. @typedef {{ student: string, left_s: number, free_in_s: number }} TimeNow */

/** Whether two names are those of one person, as the station compares them. @param {string} one @param {string} other */
export const isSamePerson = (one, other) => one.trim().toLowerCase() === other.trim().toLowerCase();

/** Whose time it is, for how long, and in how long the arm is free. @param {Pick<import("./types.js").Station, "slots" | "at_s"> | null} station @returns {TimeNow | null} */
export function timeNow(station) {
  const now = station?.slots?.now;
  if (!station || !now) return null;
  const left_s = now.ends_s - station.at_s;
  return { student: now.student, left_s, free_in_s: (station.slots?.free_s ?? now.ends_s) - station.at_s };
}

/** Whose time comes next, and in how long. @param {Pick<import("./types.js").Station, "slots" | "at_s"> | null} station */
export function timeNext(station) {
  const next = station?.slots?.next;
  return station && next ? { student: next.student, in_s: next.starts_s - station.at_s } : null;
}
