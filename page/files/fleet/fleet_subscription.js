// Subscribes to the fleet through the station of this board, and reconnects. It draws nothing.

import { readEvents } from "../station/event_stream.js";
import { watchSilence } from "../station/silence.js";

/** @typedef {import("./fleet.js").Store} Store */
/** @typedef {import("./members.js").Member} Member */
/** @typedef {import("../station/http.js").Http} Http */

const AGAIN_MS = 1000;
const LOOK_MS = 500;

/** @param {Store} store @param {Http} http */
export function followFleet(store, http) {
  const { send } = store;
  /** Aborts the running subscription. @type {AbortController | null} */ let listening = null;
  /** @type {number | undefined} */ let timer;

  const now_ms = () => Date.now();
  // A station reports its own arm at least twice per second; a silent one is reconnected.
  const resetSilence = watchSilence({ isExpected: () => store.page.connection === "open", silent: () => void follow() });

  /** Reads the fleet; returns whether there is one. @param {AbortController} mine @returns {Promise<boolean>} */
  async function look(mine) {
    const answer = await http.get("api/v1/fleet", mine.signal);
    const body = await answer?.json().catch(() => undefined);
    if (listening !== mine) return false;
    resetSilence();
    if (!answer || !body) send({ type: "closed", problem: null });
    else if (answer.ok) send({ type: "fleet", name: body.name, members: body.members, now_ms: now_ms() });
    else if (answer.status === 404) send({ type: "alone" });
    else send({ type: "closed", problem: answer.status === 401 || answer.status === 403 ? body : null });
    if (answer?.ok) void readFacts(mine);
    return answer?.ok === true && body !== undefined;
  }

  /** @param {AbortController} mine */
  async function readFacts(mine) {
    const facts = await http.json("api/v1/arm");
    if (facts && listening === mine) send({ type: "facts", facts });
  }

  /** @param {AbortController} mine */
  async function listen(mine) {
    const isWanted = () => listening === mine;
    const answer = await http.get("api/v1/fleet/events", mine.signal);
    /** @type {Map<string, Member>} */ let news = new Map();
    /** Ids of removed members. @type {string[]} */ let gone = [];
    /** @param {string} event @param {string} data */
    const onEvent = (event, data) => {
      if (event === "gone") gone.push(/** @type {{ id: string }} */ (JSON.parse(data)).id);
      if (event !== "member") return;
      /** @type {Member} */ const member = JSON.parse(data);
      news.set(member.id, member);
    };
    const onChunk = () => {
      resetSilence();
      if (news.size || gone.length) send({ type: "members", members: [...news.values()], gone, now_ms: now_ms() });
      else send({ type: "alive", now_ms: now_ms() });
      news = new Map();
      gone = [];
    };
    if (answer?.ok) await readEvents(answer, { onEvent, onChunk, isWanted });
    if (isWanted()) send({ type: "closed", problem: null });
  }

  async function follow() {
    clearTimeout(timer);
    listening?.abort();
    const mine = listening = new AbortController();
    send({ type: "connecting" });
    if (await look(mine)) await listen(mine);
    // A new token restarts it immediately.
    if (listening === mine && store.page.connection !== "token") timer = setTimeout(() => void follow(), AGAIN_MS);
  }

  setInterval(() => {
    const { connection, received_ms } = store.page;
    if (connection === "open" && now_ms() - received_ms < LOOK_MS) return;
    send({ type: "tick", now_ms: now_ms() });
  }, LOOK_MS);

  return { follow: () => void follow() };
}
