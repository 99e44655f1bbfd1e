// The last minutes for the charts, sampled every half second.

/** @typedef {import("./types.js").Station} Station */
/** Chart columns: seconds and values, null where unknown. @typedef {Record<"at_s" | "rate" | "latency_ms" | "queue" | "base_deg" | "rear_deg" | "fore_deg" | "servo_deg", readonly (number | null)[]>} History */

const EVERY_S = 0.5;
const SAMPLES = 360;

/** @type {History} */
export const NO_HISTORY = { at_s: [], rate: [], latency_ms: [], queue: [], base_deg: [], rear_deg: [], fore_deg: [], servo_deg: [] };

/** @param {Station} station @returns {Record<keyof History, number | null>} */
const sampleOf = ({ at_s, link, queue, arm }) => ({
  at_s,
  rate: link.statuses_per_s,
  latency_ms: link.latency_ms,
  queue: queue.waiting + queue.under_way,
  base_deg: arm?.base_deg ?? null,
  rear_deg: arm?.rear_deg ?? null,
  fore_deg: arm?.fore_deg ?? null,
  servo_deg: arm?.servo_deg ?? null,
});

/** @param {History} history @param {import("./message.js").Message} message @returns {History} */
export function reduceHistory(history, message) {
  if (message.type === "hello") return NO_HISTORY;
  if (message.type !== "state") return history;
  const last_s = history.at_s.at(-1) ?? -Infinity;
  if (message.station.at_s < last_s + EVERY_S) return history;
  const sample = sampleOf(message.station);
  const names = /** @type {(keyof History)[]} */ (Object.keys(history));
  return /** @type {History} */ (/** @type {unknown} */ (Object.fromEntries(names.map((name) => [name, [...history[name].slice(1 - SAMPLES), sample[name]]]))));
}
