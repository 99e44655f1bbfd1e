// Subscribes to packets while they are visible.

import { readEvents } from "./event_stream.js";

/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {import("../state/types.js").Schemas} Schemas */

const AGAIN_MS = 1000;

/** @param {Store} store @param {import("./http.js").Http} http */
export function followPackets(store, http) {
  const { send } = store;
  /** Aborts the running subscription. @type {AbortController | null} */ let listening = null;

  const isWanted = () => store.page.packets.listening && store.page.tab === "watch" && store.page.connection === "open";

  /** @param {AbortController} mine */
  async function listen(mine) {
    const answer = await http.get("api/v1/packets", mine.signal);
    if (answer && !answer.ok) send({ type: "packets_refused", problem: await answer.json() });
    /** @type {Schemas["PacketView"][]} */ let received = [];
    /** @param {string} event @param {string} data */
    const onEvent = (event, data) => {
      if (event === "packet") received.push(JSON.parse(data));
      else if (event === "lost") send({ type: "packets_lost", count: JSON.parse(data).lost });
    };
    const onChunk = () => {
      if (received.length) send({ type: "packets", packets: received });
      received = [];
    };
    if (answer?.ok) await readEvents(answer, { onEvent, onChunk, isWanted: () => listening === mine });
    if (listening !== mine) return;
    listening = null;
    if (answer?.ok !== false) setTimeout(follow, AGAIN_MS);
  }

  function follow() {
    if (isWanted() === (listening !== null)) return;
    listening?.abort();
    listening = isWanted() ? new AbortController() : null;
    if (listening) void listen(listening);
  }

  store.subscribe((_, { type }) => {
    if (type === "packets_wanted" || type === "tab" || type === "hello" || type === "closed") follow();
  });
}
