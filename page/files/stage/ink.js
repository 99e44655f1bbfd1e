// The ink of a virtual arm's scene, as the stage shows it.

/** @typedef {import("../api").components["schemas"]["WorldState"]} WorldState */
/** @typedef {import("./view.js").Marks} Marks */
/** @typedef {import("./view.js").View} View */

/** Width of a burn. */
export const LASER_WIDTH_MM = 0.3;
/** The energy for a millimetre that makes paper brown, in joules. */
const BROWN_J_MM = 0.02;
const FAINTEST = 0.15;

/**
 * The parts of a view that come from a world.
 * @param {WorldState} world
 * @returns {Pick<View, "tool" | "table_z_mm" | "paper" | "things">}
 */
export function partsOf({ tool, table_z_mm, paper, objects }) {
  return {
    // The tip touches the table where z is `down_z_mm`.
    tool: { kind: tool.kind.type, length_mm: tool.down_z_mm - table_z_mm },
    table_z_mm,
    paper: /** @type {View["paper"]} */ (paper ?? null),
    things: /** @type {View["things"]} */ (/** @type {unknown} */ (objects)),
  };
}

/** Collects the marks of a world that is polled, with only new lines in each answer. */
export class Ink {
  /** @type {Marks} */ #marks = empty(0.5);
  #lines = 0;
  /** The points of the last line that were taken: it may still grow, and its end moves on until it turns. @type {number[][]} */
  #last = [];
  #holes = 0;
  #at_s = 0;

  /** The marks; the same object for as long as they only grow. */
  get marks() {
    return this.#marks;
  }

  /** From which line on the world is to be asked for: the last one may have grown. */
  get from() {
    return Math.max(0, this.#lines - 1);
  }

  /**
   * Takes an answer, which has the lines from `from` on.
   * @param {WorldState} world
   * @param {number} from
   * @returns {boolean} whether it fits; if not, all has to be asked for, from 0 on
   */
  take(world, from) {
    const { tool: { kind }, time_s } = world;
    const width_mm = kind.type === "pen" ? kind.width_mm : LASER_WIDTH_MM;
    const lines = kind.type === "laser" ? world.burns : world.strokes;
    const shorter = from + lines.length < this.#lines || world.holes.length < this.#holes;
    if (time_s < this.#at_s || shorter || width_mm !== this.#marks.width_mm || (from === 0 && this.from > 0)) this.#begin(width_mm);
    if (from !== this.from) return false;
    this.#at_s = time_s;
    for (const [n, line] of lines.entries()) {
      const taken = from + n === this.#lines - 1 ? sameUntil(line.points_mm, this.#last) : 0;
      this.#draw(line.points_mm, taken, isBurn(line) ? darkness(line.power_w / line.speed_mm_s) : 1);
      this.#last = line.points_mm;
    }
    this.#lines = from + lines.length;
    for (const { at_mm } of world.holes.slice(this.#holes)) this.#draw([at_mm], 0, 1);
    this.#holes = world.holes.length;
    return true;
  }

  /** @param {number} width_mm */
  #begin(width_mm) {
    this.#marks = empty(width_mm);
    this.#lines = this.#holes = this.#at_s = 0;
    this.#last = [];
  }

  /** @param {number[][]} points @param {number} taken @param {number} shade */
  #draw(points, taken, shade) {
    const { ends_mm, shades } = this.#marks;
    // A single point is a dot.
    const first = points.length === 1 && taken === 0 ? 0 : Math.max(1, taken);
    for (let n = first; n < points.length; n += 1) {
      const [x0 = 0, y0 = 0] = points[Math.max(0, n - 1)] ?? [], [x1 = 0, y1 = 0] = points[n] ?? [];
      ends_mm.push(x0, y0, x1, y1);
      shades.push(shade);
    }
  }
}

/** @param {number} width_mm @returns {Marks} */
const empty = (width_mm) => ({ width_mm, ends_mm: [], shades: [] });

/**
 * Returns the number of leading points that two lines have in common.
 * @param {readonly number[][]} a
 * @param {readonly number[][]} b
 */
function sameUntil(a, b) {
  const other = a.findIndex(([x, y], n) => b[n]?.[0] !== x || b[n]?.[1] !== y);
  return other < 0 ? a.length : other;
}

/**
 * @param {{ points_mm: number[][] }} line
 * @returns {line is WorldState["burns"][number]}
 */
const isBurn = (line) => "power_w" in line;

/** Darkness of a burn, from 0 to 1. @param {number} dose_j_mm The energy for a millimetre, in joules. */
export const darkness = (dose_j_mm) => Math.max(FAINTEST, 1 - Math.exp(-dose_j_mm / BROWN_J_MM));
