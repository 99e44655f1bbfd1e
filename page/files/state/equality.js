// Whether two states of the page look the same: a station keeps reporting an arm that rests. Pure.

import { silence_ms } from "./selectors.js";

/** @typedef {import("./state.js").Page} Page */
/** @typedef {import("./types.js").Station} Station */

/** Compared by what is read of them. */
const COMPARED_APART = new Set(["station", "received_ms", "now_ms", "history"]);
/** How long a time slot lasts is counted by the station's clock: it is written so often in a second. */
const SLOTS_PER_S = 4;

/** What is read of a station; the numbers of its link are not read anywhere but in Watch. @param {Station | null} station @param {boolean} watched */
function read(station, watched) {
  if (!station) return "";
  const { at_s, link, slots } = station;
  const shownLink = { ...link, statuses_per_s: link.statuses_per_s.toFixed(1), latency_ms: watched ? link.latency_ms : null };
  return JSON.stringify({ ...station, at_s: slots ? Math.floor(at_s * SLOTS_PER_S) : 0, link: shownLink });
}

/** @param {Page} before @param {Page} after */
export function rendersSame(before, after) {
  const names = /** @type {(keyof Page)[]} */ (Object.keys(after));
  if (names.some((name) => !COMPARED_APART.has(name) && before[name] !== after[name])) return false;
  if (silence_ms(before) !== silence_ms(after)) return false;
  const watched = after.tab === "watch";
  return (!watched || before.history === after.history) && read(before.station, watched) === read(after.station, watched);
}
