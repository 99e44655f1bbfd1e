// The mouse pad (state 1) and the hand pad (state 8): packets from a held pointer.

import { createStream, gesturePacket, mousePacket } from "./pad_packets.js";

/** @typedef {ReturnType<typeof createPads>} Pads */

const MM = { zero_mm: 0, units_per_mm: 1 };
/** While the dialect is unknown the station refuses the packet, with the reason. */
const UNDECIDED = { x: MM, y: MM, z: MM };

/**
 * @param {import("../state/store.js").Store} store
 * @param {import("../station/socket.js").Socket} socket
 */
export function createPads(store, socket) {
  /** The facts of the dialect that holds; nothing for the moment until they are read. */
  function facts() {
    const { facts, station } = store.page;
    return (facts?.dialect?.name ?? null) === (station?.dialect ?? null) ? facts : null;
  }
  const refused = (/** @type {string} */ detail) => store.send({ type: "pad_refused", detail });

  /** Pointer travel since the last packet in pixels, and the lift in units. */
  let way = /** @type {[number, number]} */ ([0, 0]), lift = 0;
  const mouse = createStream({ store, socket, refused, next() {
    const arm = store.page.station?.arm, known = facts();
    if (!arm || !known || (Math.hypot(...way) < 1 && lift === 0)) return null;
    const { command, used } = mousePacket(way, arm, known.dialect?.mouse_swings ?? false, lift);
    way = [way[0] - used[0], way[1] - used[1]];
    lift = 0;
    return command;
  } });

  let hand = { far: 0, left: 0 }, z_mm = 40, grab = false, repeats = 0;
  const gesture = createStream({ store, socket, refused, next() {
    const known = facts(), mounted = store.page.around?.tool.kind ?? "suction_cup";
    // Gestures are averaged with earlier ones; a gesture that moves nothing may never end.
    if (!known || repeats >= (known.dialect?.gesture_samples ?? 1)) return null;
    repeats += 1;
    return gesturePacket({ ...hand, z_mm, grab }, known.tools.find(({ kind }) => kind === mounted)?.gesture ?? UNDECIDED);
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
