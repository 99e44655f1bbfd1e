// The mouse pad (state 1) and the hand pad (state 8): what a pointer that is held on them sends.

import { createStream, gesturePacket, mousePacket } from "./pad.js";

/** @typedef {ReturnType<typeof createPads>} Pads */

/** A gesture is averaged with the ten before it, and one that moves nothing never ends on an arm as it was sold. */
const REPEATS = 10;
/** The lowest place of gestures on an arm as it was sold, in mm. */
const LOWEST_MM = -30;

/**
 * @param {import("../state/store.js").Store} store
 * @param {import("../station/socket.js").Socket} socket
 * @param {() => void} takeIfFree
 */
export function createPads(store, socket, takeIfFree) {
  const isStock = () => store.page.station?.dialect === "firmware-1.1";
  const refused = (/** @type {string} */ detail) => store.send({ type: "pad_refused", detail });

  /** How far the pointer went since the last packet, in pixels, and the lift in units. */
  let way = /** @type {[number, number]} */ ([0, 0]), lift = 0;
  const mouse = createStream({ store, socket, takeIfFree, refused, next() {
    const arm = store.page.station?.arm;
    if (!arm || (Math.hypot(...way) < 1 && lift === 0)) return null;
    const { command, used } = mousePacket(way, arm, isStock(), lift);
    way = [way[0] - used[0], way[1] - used[1]];
    lift = 0;
    return command;
  } });

  let hand = { far: 0, left: 0 }, z_mm = 40, grab = false, repeats = 0;
  const gesture = createStream({ store, socket, takeIfFree, refused, next() {
    if (repeats >= REPEATS) return null;
    repeats += 1;
    return gesturePacket({ ...hand, z_mm, grab }, isStock(), LOWEST_MM);
  } });

  return {
    mouse: {
      begin() {
        [way, lift] = [[0, 0], 0];
        store.send({ type: "pad_refused", detail: null });
        mouse.begin();
      },
      /** @param {number} right @param {number} down in pixels */
      move(right, down) {
        way = [way[0] + right, way[1] + down];
        mouse.more();
      },
      /** @param {number} units up */
      lift(units) {
        lift = units;
        mouse.more();
      },
      end: mouse.end,
    },
    hand: {
      /** @param {number} far from -1 (near) to 1 @param {number} left from -1 (right) to 1 */
      begin(far, left) {
        [hand, repeats] = [{ far, left }, 0];
        store.send({ type: "pad_refused", detail: null });
        gesture.begin();
      },
      /** @param {number} far @param {number} left */
      move(far, left) {
        [hand, repeats] = [{ far, left }, 0];
        gesture.more();
      },
      end: gesture.end,
      /** @param {number} mm */
      height: (mm) => (z_mm = mm),
      /** @param {boolean} closed */
      grab: (closed) => (grab = closed),
    },
  };
}
