// Whether two states render the same: a station keeps reporting an arm at rest. Pure.

import { silence_ms } from "./selectors.js";

/** @typedef {import("./state.js").Page} Page */
/** @typedef {import("./types.js").Station} Station */

/** Compared by what is read of them. */
const COMPARED_APART = new Set(["station", "received_ms", "now_ms", "history"]);
/** Redraws per second for the remaining time of a slot. */
const SLOTS_PER_S = 4;

/** The rendered part of a station's state; link figures are shown only in Watch. @param {Station | null} station @param {boolean} watched */
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

/** Whether nothing but the pose of the arm and the figures of its link have changed. @param {Page} before @param {Page} after */
export const onlyMoved = (before, after) => rendersSame(withoutReport(before), withoutReport(after));

/** @param {Page} page @returns {Page} */
const withoutReport = (page) => ({ ...page, station: page.station && { ...page.station, arm: null, link: { ...page.station.link, statuses_per_s: 0 } } });
