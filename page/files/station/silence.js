// Detects a silent station.

const TICK_MS = 500;
/** Time without a message before a station counts as silent. */
export const SILENT_MS = 2000;

/**
 * Counts timer ticks instead of time, and restarts after a late tick: a page that was busy or asleep has not yet processed the
 * messages that arrived meanwhile.
 * @param {object} outside
 * @param {() => boolean} outside.isExpected whether a message is expected
 * @param {() => void} outside.silent
 * @returns {() => void} to be called on each message
 */
export function watchSilence({ isExpected, silent }) {
  let ticks = 0, last_ms = performance.now();
  setInterval(() => {
    const now_ms = performance.now(), isLate = now_ms - last_ms > 2 * TICK_MS;
    last_ms = now_ms;
    ticks = isExpected() && !isLate ? ticks + 1 : 0;
    if (ticks * TICK_MS <= SILENT_MS) return;
    ticks = 0;
    silent();
  }, TICK_MS);
  return () => void (ticks = 0);
}
