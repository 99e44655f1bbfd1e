// @ts-check
// What is around the arm: the world of a virtual arm with its ink, the way of the job, the limits of the policy. It is
// fetched beside the states, and kept in the form that the stage takes.

/** @typedef {import("./api").components["schemas"]} Schemas */
/** @typedef {import("./stage/view.js").View} View */
/** @typedef {import("./stage/view.js").ToolKind} ToolKind */

const WORLD_MS = 400;

/** How far the tool of the policy hangs below the wrist. @param {Schemas["Policy"] | undefined} policy @returns {View["tool"]} */
function mounted(policy) {
  return { kind: "suction_cup", length_mm: policy?.tool_length?.suction_cup_mm ?? 40 };
}

/** @param {Schemas["WorldState"]} world @returns {View["tool"]} */
function toolOf(world) {
  return { kind: /** @type {ToolKind} */ (world.tool.kind.type), length_mm: world.tool.down_z_mm - world.table_z_mm };
}

/** @param {Schemas["WorldState"]} world @returns {View["things"]} */
function thingsOf(world) {
  return world.objects.map((it) => ({
    name: it.name,
    shape: /** @type {View["things"][0]["shape"]} */ (it.shape),
    color: it.color,
    at_mm: /** @type {[number, number]} */ (it.at_mm),
    turn_deg: it.turn_deg,
    bottom_mm: it.bottom_mm,
  }));
}

/**
 * @param {(path: string) => Promise<Response>} fetchFrom asks the station
 * @param {() => void} changed is called when there is something new to see
 */
export function createAround(fetchFrom, changed) {
  /** @type {Schemas["Policy"] | undefined} */ let policy;
  /** @type {Schemas["WorldState"] | undefined} */ let world;
  /** @type {View["things"]} */ let things = [];
  /** @type {View["marks"]} */ let marks = null;
  /** How many lines were drawn, and how many places of the last one. */
  let drawn = { strokes: 0, places: 0 };
  /** @type {View["planned"]} */ let planned = null;
  /** @type {number | undefined} */ let job;
  let follows = false;

  /** @param {string} path */
  async function json(path) {
    const answer = await fetchFrom(path).catch(() => undefined);
    return answer?.ok ? answer.json() : undefined;
  }

  /** Adds what was drawn since; a world that has less is another one. @param {Schemas["WorldState"]} next @param {number} from */
  function addInk(next, from) {
    const width_mm = next.tool.kind.type === "pen" ? next.tool.kind.width_mm : 0.5;
    marks ??= { width_mm, ends_mm: [], shades: [] };
    for (const [index, { points_mm }] of next.strokes.entries()) {
      const known = index === 0 && drawn.strokes > 0 ? drawn.places : 1;
      const places = points_mm.length === 1 ? [points_mm[0], points_mm[0]] : points_mm;
      for (let at = Math.max(known, 1); at < places.length; at += 1) {
        marks.ends_mm.push(...places[at - 1], ...places[at]);
        marks.shades.push(1);
      }
    }
    const last = next.strokes.at(-1);
    if (last) drawn = { strokes: from + next.strokes.length, places: last.points_mm.length };
  }

  async function followWorld() {
    if (follows) return;
    follows = true;
    while (follows) {
      const from = Math.max(0, drawn.strokes - 1);
      /** @type {Schemas["WorldState"] | undefined} */
      const next = await json(`api/v1/world?strokes_from=${from}`);
      if (!next) break;
      const isOther = drawn.strokes > 0 && next.strokes.length === 0 || world !== undefined && next.time_s < world.time_s;
      if (isOther) {
        drawn = { strokes: 0, places: 0 };
        marks = null;
      } else {
        addInk(next, from);
      }
      if (JSON.stringify(next.objects) !== JSON.stringify(world?.objects)) things = thingsOf(next);
      world = next;
      changed();
      await new Promise((done) => setTimeout(done, WORLD_MS));
    }
    follows = false;
  }

  return {
    /** The connection is there: the arm may be another one. */
    async begin() {
      [policy, world, things, marks, drawn] = [undefined, undefined, [], null, { strokes: 0, places: 0 }];
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
        tool: world ? toolOf(world) : mounted(policy),
        table_z_mm: world?.table_z_mm ?? policy?.table?.z_mm ?? -103,
        paper: /** @type {View["paper"]} */ (world?.paper ?? null),
        marks,
        things,
        keepOuts: /** @type {View["keepOuts"]} */ (/** @type {unknown} */ (Object.values(policy?.keep_out ?? {}))),
        planned,
      };
    },
  };
}
