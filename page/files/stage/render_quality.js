// Render quality and frame rate of the stage: full quality, reduced on a computer that cannot keep up. Pure, except for the
// frame times that it has seen.

/** @typedef {{ density: number, mirrors: boolean, shadows: boolean }} Quality Device pixels per CSS pixel, at most. */

/** From the highest. The shadow goes last, because it shows the height. @type {readonly Quality[]} */
const QUALITIES = [
  { density: 2, mirrors: true, shadows: true },
  { density: 1, mirrors: true, shadows: true },
  { density: 1, mirrors: false, shadows: true },
  { density: 0.75, mirrors: false, shadows: true },
  { density: 0.75, mirrors: false, shadows: false },
];
/** First level without a graphics card. */
const WITHOUT_CARD = 3;
/** Frame time that is too slow if most frames of a row exceed it: 30 frames per second. */
const SLOW_MS = 34;
const ROW = 16;
/** Frame time of 60 frames per second; more do not look smoother. */
const FRAME_MS = 1000 / 60;
/** Tolerance for screens that are not exactly at 60 Hz. */
const EARLY_MS = 2;

/** Limits the frames to 60 in a second. @returns {(now_ms: number) => boolean} whether a frame is due; then it has to be drawn */
export function createLimit() {
  let due_ms = 0;
  return (now_ms) => {
    if (now_ms < due_ms) return false;
    due_ms = (now_ms - due_ms < FRAME_MS ? due_ms : now_ms - EARLY_MS) + FRAME_MS;
    return true;
  };
}

/** @param {boolean} card whether there is a graphics card */
export function createRenderQuality(card) {
  let level = card ? 0 : WITHOUT_CARD;
  /** @type {number[]} */ let took = [];
  /** @type {number | null} */ let last = null;
  return {
    /**
     * Records a frame; `again` if another one follows immediately.
     * @param {number} now_ms
     * @param {boolean} again
     * @returns {boolean} whether the quality changed
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
    /** @param {number} screen device pixels per CSS pixel @returns {Quality} */
    quality(screen) {
      const quality = /** @type {Quality} */ (QUALITIES[level]);
      return { ...quality, density: Math.min(screen, quality.density) };
    },
  };
}
