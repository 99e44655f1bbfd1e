// Detects a silent station.

const LOOK_MS = 500;
/** Time without a message before a station counts as silent. */
export const SILENT_MS = 2000;

/**
 * It counts the looks and not the time, and begins anew after a look that came late: a page that was busy or asleep has
 * still to hear what came meanwhile.
 * @param {object} outside
 * @param {() => boolean} outside.isExpected whether something should come
 * @param {() => void} outside.silent
 * @returns {() => void} something came
 */
export function watchSilence({ isExpected, silent }) {
  let looks = 0, last_ms = performance.now();
  setInterval(() => {
    const now_ms = performance.now(), isLate = now_ms - last_ms > 2 * LOOK_MS;
    last_ms = now_ms;
    looks = isExpected() && !isLate ? looks + 1 : 0;
    if (looks * LOOK_MS <= SILENT_MS) return;
    looks = 0;
    silent();
  }, LOOK_MS);
  return () => void (looks = 0);
}
