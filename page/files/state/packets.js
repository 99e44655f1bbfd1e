// The packets between station and arm, in both directions: the newest are kept.

/** @typedef {import("./types.js").Schemas} Schemas */
/** @typedef {import("./types.js").Problem} Problem */
/** A packet as reported by the station. @typedef {Schemas["PacketView"]} PacketView */
/** A packet with its number, counted from when the page began to listen. @typedef {PacketView & { number: number }} Passed */
/** @typedef {"both" | "to_arm" | "from_arm"} Way */

/**
 * @typedef {object} Packets
 * @property {boolean} listening Whether the packets are shown; otherwise nothing is fetched.
 * @property {readonly Passed[]} passed The newest last.
 * @property {readonly Passed[] | null} frozen The packets at the time of a pause; new ones are still collected.
 * @property {number} count Number of packets received.
 * @property {number} lost Number of packets dropped because they came too fast.
 * @property {Way} way
 * @property {string} filter Filter text.
 * @property {Problem | null} problem
 */

/** @type {Packets} */
export const NO_PACKETS = { listening: false, passed: [], frozen: null, count: 0, lost: 0, way: "both", filter: "", problem: null };

/** @typedef {{ type: "packets_wanted", listening: boolean }
 * | { type: "packets", packets: readonly PacketView[] }
 * | { type: "packets_lost", count: number }
 * | { type: "packets_refused", problem: Problem }
 * | { type: "packets_frozen", frozen: boolean }
 * | { type: "packets_way", way: Way }
 * | { type: "packets_filter", text: string }
 * | { type: "packets_cleared" }} PacketsMessage */

/** The most packets kept: over two minutes of an arm at rest. */
const MOST = 2000;

/** @param {Packets} packets @param {import("./message.js").Message} message @returns {Packets} */
export function reducePackets(packets, message) {
  switch (message.type) {
    case "packets_wanted":
      return { ...packets, listening: message.listening, problem: null };
    case "packets": {
      const { count } = packets;
      const added = message.packets.map((packet, n) => ({ ...packet, number: count + n + 1 }));
      return { ...packets, count: count + added.length, passed: [...packets.passed, ...added].slice(-MOST) };
    }
    case "packets_lost":
      return { ...packets, lost: packets.lost + message.count };
    case "packets_refused":
      return { ...packets, problem: message.problem };
    case "packets_frozen":
      return { ...packets, frozen: message.frozen ? packets.passed : null };
    case "packets_way":
      return { ...packets, way: message.way };
    case "packets_filter":
      return { ...packets, filter: message.text };
    case "packets_cleared":
      return { ...packets, passed: [], frozen: packets.frozen && [], lost: 0 };
    default:
      return packets;
  }
}

/** A packet in one line. @param {PacketView} packet */
export function line(packet) {
  if (packet.direction === "to_arm" && !packet.command) return packet.problem ?? "";
  const said = packet.direction === "to_arm" ? packet.command : packet.status;
  return Object.entries(said ?? {}).map(word).join(" ");
}

/** A field with its value; the type without its name. @param {[string, unknown]} field */
function word([name, value]) {
  if (name === "type") return String(value);
  if (typeof value === "number") return `${name} ${Number(value.toFixed(2))}`;
  return `${name} ${typeof value === "object" ? JSON.stringify(value) : value}`;
}

/** The packets that a person wants to see, the newest last. @param {Packets} packets */
export function wanted({ passed, frozen, way, filter }) {
  const text = filter.trim().toLowerCase();
  return (frozen ?? passed).filter((packet) => (way === "both" || packet.direction === way) && (!text || line(packet).toLowerCase().includes(text) || packet.bytes.includes(text)));
}

/** Packets as JSON Lines, one each, for other programs. @param {readonly Passed[]} packets */
export const exported = (packets) => packets.map((packet) => `${JSON.stringify(packet)}\n`).join("");
