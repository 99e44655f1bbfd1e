// @ts-check
// What is around the arm: the world of a virtual arm with its ink, the way of the job, the limits of the policy. It is
// fetched beside the states, and kept in the form that the stage takes.

import { Ink, partsOf } from "./stage/ink.js";

/** @typedef {import("./api").components["schemas"]} Schemas */
/** @typedef {import("./stage/view.js").View} View */

const WORLD_MS = 400;

/** How far the tool of the policy hangs below the wrist. @param {Schemas["Policy"] | undefined} policy @returns {View["tool"]} */
function mounted(policy) {
  return { kind: "suction_cup", length_mm: policy?.tool_length?.suction_cup_mm ?? 40 };
}

/**
 * @param {(path: string) => Promise<Response>} fetchFrom asks the station
 * @param {() => void} changed is called when there is something new to see
 */
export function createAround(fetchFrom, changed) {
  /** @type {Schemas["Policy"] | undefined} */ let policy;
  /** @type {ReturnType<typeof partsOf> | undefined} */ let parts;
  let ink = new Ink();
  /** @type {View["planned"]} */ let planned = null;
  /** @type {number | undefined} */ let job;
  let follows = false;

  /** @param {string} path */
  async function json(path) {
    const answer = await fetchFrom(path).catch(() => undefined);
    return answer?.ok ? answer.json() : undefined;
  }

  async function followWorld() {
    if (follows) return;
    follows = true;
    while (follows) {
      const from = ink.from;
      /** @type {Schemas["WorldState"] | undefined} */
      const world = await json(`api/v1/world?strokes_from=${from}`);
      if (!world) break;
      // Another world begins anew: all of it is asked for.
      if (!ink.take(world, from)) continue;
      const next = partsOf(world);
      // What is the same as before costs the stage nothing.
      parts = JSON.stringify(next) === JSON.stringify(parts) ? parts : next;
      changed();
      await new Promise((done) => setTimeout(done, WORLD_MS));
    }
    follows = false;
  }

  return {
    /** The connection is there: the arm may be another one. */
    async begin() {
      [policy, parts, ink] = [undefined, undefined, new Ink()];
      policy = await json("api/v1/policy");
      changed();
    },

    end() {
      follows = false;
    },

    /** Only the station's own virtual arm has a world that it can tell. @param {boolean} isVirtual */
    follow(isVirtual) {
      if (isVirtual) void followWorld();
      else follows = false;
    },

    /** The policy is another one. */
    async readPolicy() {
      policy = await json("api/v1/policy");
      changed();
    },

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
      const limits = policy ? { joints: policy.joints, workspace: policy.workspace } : undefined;
      return {
        ...(limits && { limits: /** @type {View["limits"]} */ (limits) }),
        tool: mounted(policy),
        table_z_mm: policy?.table?.z_mm ?? -103,
        ...parts,
        marks: parts ? ink.marks : null,
        keepOuts: /** @type {View["keepOuts"]} */ (/** @type {unknown} */ (Object.values(policy?.keep_out ?? {}))),
        planned,
      };
    },
  };
}
