// Polls the stations of the fleet for the progress of students. It draws nothing.

import { isThere } from "./members.js";

/** @typedef {import("./fleet.js").Store} Store */

/** Polling interval: stations do not announce progress. */
const AGAIN_MS = 4000;

/** Asks all stations that are there, for as long as the board is seen. @param {Store} store @param {import("../station/http.js").Http} http */
export function followLearners(store, http) {
  /** @type {number | undefined} */ let timer;
  /** Number of requests: results of earlier ones are ignored. */
  let requests = 0;

  async function read() {
    clearTimeout(timer);
    const mine = requests += 1;
    const { connection, members } = store.page;
    if (connection !== "open") return;
    const names = document.hidden ? [] : [...new Set(members.filter(isThere).map(({ name }) => name))];
    /** @type {import("../station/http.js").Outcome<import("./state.js").MemberAnswer[]>} */
    const { value } = names.length ? await http.ask("POST", "api/v1/fleet/requests", { to: { members: names }, method: "GET", path: "/api/v1/learners" }) : { value: [] };
    if (mine !== requests) return;
    if (value?.length) store.send({ type: "learners", answers: value });
    timer = setTimeout(() => void read(), AGAIN_MS);
  }

  store.subscribe((_, { type }) => {
    if (type === "fleet") void read();
  });
}
