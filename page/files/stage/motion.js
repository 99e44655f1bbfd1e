// Interpolates the arm between two statuses. Pure, except for the statuses it has received.
//
// The display lags the arm by one and a half status periods, so that the next status has nearly always arrived. It never
// extrapolates beyond the last status, and stays between the positions of two statuses.

/** @typedef {import("./view.js").Joints} Joints */
/** @typedef {{ at_s: number, joints: Joints }} Sample */

/** The most statuses kept: more than arrive during the delay. */
const KEPT = 8;
/** A longer gap is not part of a motion: the arm stood still, or no status arrived. */
const GAP_S = 0.5;
/** Drift rate of the clock offset, so that one early status does not fix it forever. */
const DRIFT = 0.002;

const NAMES = /** @type {const} */ (["base_deg", "rear_deg", "fore_deg", "servo_deg"]);

export class Motion {
  /** @type {Sample[]} */ #samples = [];
  /** Offset between the station's clock and ours, from the fastest status. */
  #ahead_s = Infinity;
  /** Time of the last report of the last position. */
  #last_report_s = 0;
  #status_s = 0;

  /** The status period, from the station. @param {number} seconds */
  set status_s(seconds) {
    this.#status_s = seconds;
  }

  /** The display delay; a position repeated for longer than this is one where the arm stood still. */
  get #delay_s() {
    return 1.5 * this.#status_s;
  }

  /**
   * Adds a report. A station reports more often than the arm does: an unchanged position counts as a new status only after it
   * has lasted longer than a status period.
   * @param {Sample} sample
   * @param {number} now_s
   */
  add(sample, now_s) {
    const last = this.#samples.at(-1);
    if (last && sample.at_s === last.at_s) return;
    // A station that was started again counts from 0.
    if (last && sample.at_s < last.at_s) return this.#restart(sample, now_s);
    this.#ahead_s = Math.min(this.#ahead_s + DRIFT, now_s - sample.at_s);
    if (last && NAMES.every((name) => sample.joints[name] === last.joints[name])) {
      this.#last_report_s = sample.at_s;
      return;
    }
    const until_s = Math.min(this.#last_report_s, sample.at_s - this.#status_s);
    if (last && this.#last_report_s > last.at_s && sample.at_s > last.at_s + this.#delay_s) this.#samples.push({ at_s: until_s, joints: last.joints });
    this.#samples.push(sample);
    this.#last_report_s = sample.at_s;
    while (this.#samples.length > KEPT) this.#samples.shift();
  }

  /** @param {Sample} sample @param {number} now_s */
  #restart(sample, now_s) {
    this.clear();
    this.add(sample, now_s);
  }

  clear() {
    this.#samples = [];
    this.#ahead_s = Infinity;
    this.#last_report_s = 0;
  }

  /**
   * Returns the joints to draw, and whether they are still changing.
   * @param {number} now_s
   * @returns {{ joints: Joints, moving: boolean } | null}
   */
  at(now_s) {
    const last = this.#samples.at(-1);
    if (!last) return null;
    const when = now_s - this.#ahead_s - this.#delay_s;
    const next = this.#samples.findIndex((sample) => sample.at_s > when);
    if (next < 0) return { joints: last.joints, moving: false };
    const to = /** @type {Sample} */ (this.#samples[next]);
    const from = this.#samples[next - 1];
    // Nothing precedes the first sample.
    if (!from) return { joints: to.joints, moving: next < this.#samples.length - 1 };
    const start_s = Math.max(from.at_s, to.at_s - GAP_S);
    const joints = between({ ...from, at_s: start_s }, to, this.#samples[next - 2], this.#samples[next + 1], when);
    return { joints, moving: true };
  }
}

/**
 * @param {Sample} from
 * @param {Sample} to
 * @param {Sample | undefined} before
 * @param {Sample | undefined} after
 * @param {number} when
 */
function between(from, to, before, after, when) {
  const long = to.at_s - from.at_s;
  const share = Math.min(Math.max((when - from.at_s) / long, 0), 1);
  const joints = { ...to.joints };
  for (const name of NAMES) {
    const [a, b] = [from.joints[name], to.joints[name]];
    const slope = (b - a) / long;
    const start = before ? limitedSlope((a - before.joints[name]) / (from.at_s - before.at_s), slope) : slope;
    const end = after ? limitedSlope(slope, (after.joints[name] - b) / (after.at_s - to.at_s)) : slope;
    joints[name] = hermite(a, b, start * long, end * long, share);
  }
  return joints;
}

/**
 * Returns the slope at a point from the slopes before and after it, such that a cubic stays in the range of its end points
 * (Fritsch and Butland).
 * @param {number} a
 * @param {number} b
 */
function limitedSlope(a, b) {
  return a * b > 0 ? (2 * a * b) / (a + b) : 0;
}

/**
 * @param {number} a
 * @param {number} b
 * @param {number} start
 * @param {number} end
 * @param {number} t
 */
function hermite(a, b, start, end, t) {
  const t2 = t * t, t3 = t2 * t;
  return a + (b - a) * (3 * t2 - 2 * t3) + start * (t3 - 2 * t2 + t) + end * (t3 - t2);
}
