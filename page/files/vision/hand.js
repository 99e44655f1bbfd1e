// What a hand in front of the camera means: an open hand takes control, its movement is the arm's, a pinch closes, a push stops.
// Pure: pictures in, what to do out. Whenever it is not sure, nothing is sent.

/** A point of a hand: shares of the picture's width and height, from its upper left corner. @typedef {readonly [x: number, y: number, z?: number]} Landmark */
/** A hand: the 21 points of MediaPipe, from the wrist to the tip of the little finger. @typedef {{ score: number, points: readonly Landmark[] }} Hand */
/** @typedef {{ at_ms: number, hands: readonly Hand[], aspect: number }} Picture `aspect`: width by height */
/** @typedef {{ left_mm: number, up_mm: number, closed: boolean }} Movement since the hand took control */
/**
 * @typedef {object} Meaning
 * @property {"none" | "several" | "unsure" | "other" | "opening" | "controls" | "stop"} state `other`: one hand, not open. `opening`: an open hand that has not been held long enough.
 * @property {number} share How much of the time until it takes control is over, 0 to 1.
 * @property {Movement | null} movement What to send, or null for nothing.
 */

/** How long an open hand is held until it takes control. */
const OPEN_MS = 500;
/** How long a hand may be lost until it has to be opened again; nothing is sent meanwhile. */
const LOST_MS = 300;
/** The least certainty. */
const LEAST_SCORE = 0.7;
/** How far the arm goes for a movement by the width of the picture. */
const MM_PER_WIDTH = 300;
/** A pinch begins and ends when thumb and finger are this far apart, in palms. */
const PINCHED = 0.3, RELEASED = 0.5;
/** A flat hand that grows by this factor within this time is pushed forward. */
const PUSHED = 1.4, PUSH_MS = 600;
/** A hand that jumps farther between two pictures is another one, in palms. */
const JUMP = 1.5;

const WRIST = 0, THUMB = 4, INDEX = 8, MIDDLE_KNUCKLE = 9, PALM = [0, 5, 9, 13, 17];
/** The tips of the fingers and the joints below them. */
const FINGERS = [[8, 6], [12, 10], [16, 14], [20, 18]];

/** Positions in widths of the picture, y down. @param {Hand} hand @param {number} aspect @returns {(n: number) => [number, number]} */
const placesOf = ({ points }, aspect) => (n) => [points[n][0], points[n][1] / aspect];

/** @param {readonly number[]} a @param {readonly number[]} b */
const apart = ([ax, ay], [bx, by]) => Math.hypot(ax - bx, ay - by);

/** @param {Hand} hand @param {number} aspect */
export function measure(hand, aspect) {
  const at = placesOf(hand, aspect);
  const palm = apart(at(WRIST), at(MIDDLE_KNUCKLE));
  const middle = PALM.map(at).reduce(([sx, sy], [x, y]) => [sx + x / PALM.length, sy + y / PALM.length], [0, 0]);
  const isOpen = FINGERS.every(([tip, joint]) => apart(at(tip), at(WRIST)) > 1.15 * apart(at(joint), at(WRIST)));
  return { palm, middle, isOpen, pinch: apart(at(THUMB), at(INDEX)) / palm };
}

/** Whether a hand is complete and its points are numbers. @param {Hand} hand */
const isWhole = ({ score, points }) => Number.isFinite(score) && points.length === 21 && points.every(([x, y]) => Number.isFinite(x) && Number.isFinite(y));

/** @param {Meaning["state"]} state @param {number} [share] @param {Movement | null} [movement] @returns {Meaning} */
const meaning = (state, share = 0, movement = null) => ({ state, share, movement });

/** Returns a function that takes pictures, in their order. */
export function createHand() {
  /** When the open hand was first seen. @type {number | null} */ let opened_ms = null;
  /** Where the hand took control. @type {readonly number[] | null} */ let origin = null;
  /** @type {readonly number[] | null} */ let last = null;
  /** When it was last seen for certain. */
  let seen_ms = -Infinity;
  let closed = false;
  /** The sizes of the flat hand in the last pictures. @type {{ at_ms: number, palm: number }[]} */ let sizes = [];

  function lose() {
    [opened_ms, origin, last, sizes, closed] = [null, null, null, [], false];
  }

  /** @param {Picture} picture @returns {Meaning} */
  return function look({ at_ms, hands, aspect }) {
    if (at_ms - seen_ms > LOST_MS) lose();
    if (hands.length > 1) {
      lose();
      return meaning("several");
    }
    const [hand] = hands;
    if (!hand) {
      opened_ms = null;
      return meaning("none");
    }
    if (!isWhole(hand) || hand.score < LEAST_SCORE) {
      opened_ms = null;
      return meaning("unsure");
    }
    const { palm, middle, isOpen, pinch } = measure(hand, aspect);
    if (last && apart(last, middle) > JUMP * palm) lose();
    [seen_ms, last] = [at_ms, middle];
    if (isPushed(at_ms, palm, isOpen && pinch > RELEASED)) {
      lose();
      return meaning("stop");
    }
    if (!origin) return takeControl(at_ms, middle, isOpen && pinch > RELEASED);
    closed = closed ? pinch < RELEASED : pinch < PINCHED;
    // A camera that faces a person sees the person's left on its right.
    const movement = { left_mm: (middle[0] - origin[0]) * MM_PER_WIDTH, up_mm: (origin[1] - middle[1]) * MM_PER_WIDTH, closed };
    return meaning("controls", 1, movement);
  };

  /** @param {number} at_ms @param {number} palm @param {boolean} isFlat */
  function isPushed(at_ms, palm, isFlat) {
    sizes = isFlat ? [...sizes.filter((it) => at_ms - it.at_ms <= PUSH_MS), { at_ms, palm }] : [];
    return isFlat && palm > PUSHED * Math.min(...sizes.map((it) => it.palm));
  }

  /** @param {number} at_ms @param {readonly number[]} middle @param {boolean} isFlat */
  function takeControl(at_ms, middle, isFlat) {
    if (!isFlat) {
      opened_ms = null;
      return meaning("other");
    }
    opened_ms ??= at_ms;
    const share = Math.min(1, (at_ms - opened_ms) / OPEN_MS);
    if (share < 1) return meaning("opening", share);
    origin = middle;
    return meaning("controls", 1, { left_mm: 0, up_mm: 0, closed: false });
  }
}
