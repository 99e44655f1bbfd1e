// @ts-check
// What is around the arm: the world of a virtual arm with its ink, the way of the job, the limits of the policy. It is
// fetched beside the states, and kept in the form that the stage takes.

import { Ink, partsOf } from "./stage/ink.js";

/** @typedef {import("./api").components["schemas"]} Schemas */
/** @typedef {import("./stage/view.js").View} View */

const WORLD_MS = 400;

/** What of a view a policy tells. @param {Schemas["Policy"]} policy @returns {Partial<View>} */
function ruled(policy) {
  return {
    limits: /** @type {View["limits"]} */ ({ joints: policy.joints, workspace: policy.workspace }),
    tool: { kind: "suction_cup", length_mm: policy.tool_length?.suction_cup_mm ?? 40 },
    table_z_mm: policy.table?.z_mm ?? -103,
    keepOuts: /** @type {View["keepOuts"]} */ (/** @type {unknown} */ (Object.values(policy.keep_out ?? {}))),
  };
}

/**
 * @param {(path: string) => Promise<Response>} fetchFrom asks the station
 * @param {() => void} changed is called when there is something new to see
 */
export function createAround(fetchFrom, changed) {
  /** What the policy tells; the same objects until it is another one, which costs the stage nothing. @type {Partial<View>} */ let rules = {};
  /** @type {ReturnType<typeof partsOf> | undefined} */ let parts;
  let ink = new Ink();
  /** @type {View["planned"]} */ let planned = null;
  /** @type {number | undefined} */ let job;
  /** Whose turn it is to follow the world; nobody's at 0. A loop that was ended and wakes later finds another turn. */
  let turn = 0, turns = 0;

  /** @param {string} path */
  async function json(path) {
    const answer = await fetchFrom(path).catch(() => undefined);
    return answer?.ok ? answer.json() : undefined;
  }

  async function readPolicy() {
    const policy = await json("api/v1/policy");
    rules = policy ? ruled(policy) : {};
    changed();
  }

  async function followWorld() {
    if (turn) return;
    const mine = turn = turns += 1;
    while (turn === mine) {
      const from = ink.from;
      /** @type {Schemas["WorldState"] | undefined} */
      const world = await json(`api/v1/world?strokes_from=${from}`);
      if (!world || turn !== mine) break;
      // Another world begins anew: all of it is asked for.
      if (!ink.take(world, from)) continue;
      const next = partsOf(world);
      // What is the same as before costs the stage nothing.
      parts = JSON.stringify(next) === JSON.stringify(parts) ? parts : next;
      changed();
      await new Promise((done) => setTimeout(done, WORLD_MS));
    }
    if (turn === mine) turn = 0;
  }

  return {
    /** The connection is there: the arm may be another one. */
    begin() {
      [rules, parts, ink] = [{}, undefined, new Ink()];
      void readPolicy();
    },

    end() {
      turn = 0;
    },

    /** Only the station's own virtual arm has a world that it can tell. @param {boolean} isVirtual */
    follow(isVirtual) {
      if (isVirtual) void followWorld();
      else turn = 0;
    },

    /** The policy is another one. */
    readPolicy,

    /** Shows the way of a job, or of none. @param {number | undefined} number */
    async showJob(number) {
      if (number === job) return;
      job = number;
      planned = null;
      if (number === undefined) return changed();
      /** @type {Schemas["JobPath"] | undefined} */
      const path = await json(`api/v1/jobs/${number}/path`);
      if (job !== number || !path) return;
      planned = /** @type {View["planned"]} */ (/** @type {unknown} */ (path.path_mm));
      changed();
    },

    /** What of a view is around the arm. @returns {Partial<View>} */
    view() {
      return { ...rules, ...parts, marks: parts ? ink.marks : null, planned };
    },
  };
}
