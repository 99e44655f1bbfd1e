// How fine the stage is drawn: as fine as the screen is, and less so on a computer that does not keep up. Pure, but for what
// it has seen.

/** From the finest on: at most so many pixels for one of the page, and whether there are shadows. */
const QUALITIES = [{ density: 2, shadows: true }, { density: 1, shadows: true }, { density: 1, shadows: false }, { density: 0.7, shadows: false }];
/** Slower than that, in a row, is too slow: 30 frames per second. */
const SLOW_MS = 34;
const ROW = 24;

export function createPace() {
  let level = 0;
  /** @type {number[]} */ let took = [];
  /** @type {number | null} */ let last = null;
  return {
    /**
     * A frame was drawn; the next one follows at once, or not.
     * @param {number} now_ms
     * @param {boolean} again
     * @returns {boolean} whether the quality is another one from now on
     */
    drawn(now_ms, again) {
      if (last !== null) took.push(now_ms - last);
      last = again ? now_ms : null;
      if (took.length < ROW) return false;
      const middle = [...took].sort((a, b) => a - b)[ROW / 2] ?? 0;
      took = [];
      if (middle <= SLOW_MS || level === QUALITIES.length - 1) return false;
      level += 1;
      return true;
    },
    /** @param {number} screen how many pixels the screen has for one of the page */
    quality(screen) {
      const { density, shadows } = /** @type {{ density: number, shadows: boolean }} */ (QUALITIES[level]);
      return { density: Math.min(screen, density), shadows };
    },
  };
}
