// Mouse and gesture mode: packets for a pointer held on a pad. The arm executes each packet to its end, so only a few may be
// in flight when the pointer is released.

/** @typedef {import("../state/types.js").Command} Command */
/** @typedef {import("../state/types.js").Arm} Arm */
/** @typedef {import("../state/types.js").Schemas["GestureFacts"]} Gesture */

/** The most packets in flight: enough for continuous motion, few enough to stop soon after a release. */
const AHEAD = 2;
/** Pad pixels per unit of a mouse packet. */
const PIXELS = 4;
/** The largest increment of a packet, in units. */
const FURTHEST = 5;

/** @param {number} value */
const bounded = (value) => Math.max(-FURTHEST, Math.min(FURTHEST, value));

/**
 * Returns the mouse packet for a displacement of the pointer: up is forward, left is the arm's left. In a dialect that swings,
 * positive Y turns the base to the right, and the rotation is the servo's angle.
 * @param {[number, number]} pixels @param {Arm} arm @param {boolean} swings as the station serves it @param {number} lift in units
 * @returns {{ command: Command, used: [number, number] }} `used`: the displacement that it covers
 */
export function mousePacket([right, down], arm, swings, lift = 0) {
  const x = bounded(-down / PIXELS), left = bounded(-right / PIXELS);
  const command = /** @type {Command} */ ({ type: "mouse_move", x, y: swings ? -left : left, z: lift, rotation_deg: swings ? arm.servo_deg : arm.rotation_deg, suction: arm.suction });
  return { command, used: [-left * PIXELS, -x * PIXELS] };
}

/**
 * Returns the gesture packet for a position on the pad, from -1 (right, near) to 1 (left, far), and a height in mm, in the
 * units of the arm's dialect.
 * @param {{ far: number, left: number, z_mm: number, grab: boolean }} hand @param {Gesture} scale as the station serves it
 * @returns {Command}
 */
export const gesturePacket = ({ far, left, z_mm, grab }, scale) => gestureAt({ x_mm: 230 + 60 * far, y_mm: 90 * left, z_mm }, grab, scale);

/** Returns the gesture packet for a position. @param {{ x_mm: number, y_mm: number, z_mm: number }} place @param {boolean} grab @param {Gesture} scale @returns {Command} */
export function gestureAt({ x_mm, y_mm, z_mm }, grab, { x, y, z }) {
  const units = (/** @type {number} */ mm, /** @type {Gesture["x"]} */ { zero_mm, units_per_mm }) => units_per_mm * (mm - zero_mm);
  return { type: "gesture", x: units(x_mm, x), y: units(y_mm, y), z: units(z_mm, z), grab };
}

/**
 * Sends packets while there is something to send, a few ahead.
 * @param {object} outside
 * @param {import("../state/store.js").Store} outside.store
 * @param {import("../station/socket.js").Socket} outside.socket
 * @param {() => Command | null} outside.next the packet to send now, or null
 * @param {(detail: string) => void} outside.refused
 * @param {"hand"} [outside.sense] where the packets come from, if not from a pointer
 */
export function createStream({ store, socket, next, refused, sense }) {
  let isHeld = false;
  /** Requested and in-flight packets. @type {Set<number>} */ const inFlight = new Set();
  let pending = 0;
  /** Commands that finished before their acceptance arrived. @type {Set<number>} */ const finished = new Set();

  async function fill() {
    while (isHeld && inFlight.size + pending < AHEAD) {
      const command = next();
      if (!command) return;
      pending += 1;
      const { problem, reply } = await socket.ask(sense ? { type: "sensed_command", sense, command } : { type: "command", command });
      pending -= 1;
      if (problem) {
        isHeld = false;
        return refused(problem.detail);
      }
      if (reply?.type === "accepted" && !finished.delete(reply.command)) inFlight.add(reply.command);
    }
  }

  store.subscribe((_, message) => {
    if (message.type === "stop_pressed") isHeld = false;
    if (message.type === "closed") {
      isHeld = false;
      inFlight.clear();
    }
    if (message.type !== "notice") return;
    const { notice } = message;
    if (notice.type === "link_lost" || notice.type === "no_link") inFlight.clear();
    if (notice.type !== "command_done" && notice.type !== "command_failed") return;
    if (!inFlight.delete(notice.command) && pending) finished.add(notice.command);
    void fill();
  });

  return {
    begin() {
      finished.clear();
      socket.takeControlIfFree();
      isHeld = true;
      void fill();
    },
    /** New input is available. */
    more: () => void fill(),
    end() {
      isHeld = false;
    },
  };
}
