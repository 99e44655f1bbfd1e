// Samples of any rate as 16-bit integers at 16 kHz. Pure.

export const RATE = 16_000;
const PIECE = RATE / 10;

/**
 * Returns a function that takes samples, from -1 to 1, and returns the pieces of a tenth of a second that are complete. Each sample
 * is the mean of those that it stands for, so that higher tones do not appear as lower ones.
 * @param {number} rate of the samples, at least 16 kHz
 */
export function createResampler(rate) {
  const step = rate / RATE;
  let piece = new Int16Array(PIECE), length = 0;
  /** The sum of the current sample, and how much of it is there. */
  let sum = 0, filled = 0;

  return (/** @type {Float32Array} */ samples) => {
    /** @type {Int16Array<ArrayBuffer>[]} */ const complete = [];
    for (const sample of samples) {
      const used = Math.min(1, step - filled);
      sum += sample * used;
      filled += used;
      if (filled < step - 1e-9) continue;
      piece[length] = Math.round(32767 * Math.max(-1, Math.min(1, sum / step)));
      length += 1;
      [sum, filled] = [sample * (1 - used), 1 - used];
      if (length < PIECE) continue;
      complete.push(piece);
      [piece, length] = [new Int16Array(PIECE), 0];
    }
    return complete;
  };
}
