// Time slots as reported by the station. Pure.

/** @typedef {import("./types.js").Schemas} Schemas */
/** @typedef {Schemas["TimeSlot"]} TimeSlot */
/** The current time slot. @typedef {{ student: string, left_s: number, free_in_s: number }} TimeNow */

/** Whether two names belong to one person, compared as the station does. @param {string} one @param {string} other */
export const isSamePerson = (one, other) => one.trim().toLowerCase() === other.trim().toLowerCase();

/** The current time slot, its remaining time, and the time until the arm is free. @param {Pick<import("./types.js").Station, "slots" | "at_s"> | null} station @returns {TimeNow | null} */
export function timeNow(station) {
  const now = station?.slots?.now;
  if (!station || !now) return null;
  const left_s = now.ends_s - station.at_s;
  return { student: now.student, left_s, free_in_s: (station.slots?.free_s ?? now.ends_s) - station.at_s };
}

/** The next time slot, and the time until it starts. @param {Pick<import("./types.js").Station, "slots" | "at_s"> | null} station */
export function timeNext(station) {
  const next = station?.slots?.next;
  return station && next ? { student: next.student, in_s: next.starts_s - station.at_s } : null;
}
