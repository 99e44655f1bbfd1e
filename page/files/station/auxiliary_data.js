// Data fetched in addition to the states: earlier notices, the policy, the arm's facts, the world of a virtual
// arm with its ink, and the path of the job.

import { Ink, partsOf } from "../stage/ink.js";

/** @typedef {import("../state/types.js").Schemas} Schemas */
/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {import("../state/state.js").Page} Page */

const WORLD_MS = 400;

/** @param {Store} store @param {import("./http.js").Http} http */
export function followAuxiliaryData(store, http) {
  /** The current world loop; 0 if none runs. A loop that wakes after it was ended sees another number. */
  let turn = 0, turns = 0;
  /** @type {number | null} */ let job = null;
  /** Number of requests for the facts: only the last answer counts. */
  let reads = 0;
  /** @type {Schemas["Dialect"] | null | undefined} */ let dialect;

  async function readPolicy() {
    store.send({ type: "policy", policy: (await http.json("api/v1/policy")) ?? null });
  }

  async function readFacts() {
    const mine = reads += 1;
    /** @type {Schemas["ArmFacts"] | undefined} */
    const facts = await http.json("api/v1/arm");
    if (facts && mine === reads) store.send({ type: "facts", facts });
  }

  async function readNotices() {
    const notices = await http.json("api/v1/notices");
    if (notices) store.send({ type: "notices", notices });
  }

  /** Only the station's own virtual arm has a world. */
  async function followWorld() {
    const mine = turn = turns += 1;
    let ink = new Ink();
    /** @type {ReturnType<typeof partsOf> | undefined} */ let parts;
    let lines = -1;
    while (turn === mine) {
      const from = ink.from;
      /** @type {Schemas["WorldState"] | undefined} */
      const world = await http.json(`api/v1/world?strokes_from=${from}`);
      if (!world || turn !== mine) break;
      // A new world is read from its beginning.
      if (!ink.take(world, from)) continue;
      const next = partsOf(world);
      const isSame = JSON.stringify(next) === JSON.stringify(parts);
      if (!isSame || ink.marks.shades.length !== lines) {
        // Unchanged objects cost the stage nothing.
        parts = isSame && parts ? parts : next;
        lines = ink.marks.shades.length;
        store.send({ type: "around", around: { ...parts, marks: ink.marks } });
      }
      await new Promise((done) => setTimeout(done, WORLD_MS));
    }
    if (turn === mine) turn = 0;
  }

  /** @param {number | null} number */
  async function showJob(number) {
    job = number;
    if (number === null) return store.send({ type: "planned", planned: null });
    /** @type {Schemas["JobPath"] | undefined} */
    const path = await http.json(`api/v1/jobs/${number}/path`);
    if (job === number && path) store.send({ type: "planned", planned: /** @type {Page["planned"]} */ (/** @type {unknown} */ (path.path_mm)) });
  }

  store.subscribe((page, message) => {
    if (message.type === "hello") {
      [turn, job] = [0, null];
      void readNotices();
      void readPolicy();
      void readFacts();
    }
    if (message.type === "closed") turn = 0;
    if (message.type === "notice" && message.notice.type === "policy_changed") {
      void readPolicy();
      void readFacts();
    }
    if (message.type !== "state") return;
    if (page.station?.dialect !== dialect) {
      dialect = page.station?.dialect;
      void readFacts();
    }
    const isVirtual = page.station?.link.address === "virtual:";
    if (isVirtual && !turn) void followWorld();
    if (!isVirtual) turn = 0;
    const now = page.station?.job?.job ?? null;
    if (now !== job) void showJob(now);
  });
}
