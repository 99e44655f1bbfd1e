// @ts-check
// The timeline of a drawing, as written by `dobot draw --timeline`: parsed, validated, and queried by time. Independent of the
// page, so that a worker can read a large file.

/** @typedef {{name: string, color: number[] | null, tool: string}} Pass */
/**
 * Columns of one length each: millimetres in the base frame (X forward, Y to the left, Z up), seconds from the beginning.
 * @typedef {object} Timeline
 * @property {number} duration_s
 * @property {Pass[]} passes
 * @property {{kinds: string[], kind: Uint8Array, pass: Uint16Array, from_s: Float64Array}} moves
 * @property {{t_s: Float64Array, x_mm: Float32Array, y_mm: Float32Array, z_mm: Float32Array, ink: Uint8Array, error_mm: Float32Array, pass: Uint16Array}} path
 */
/** Tool position, its row, the move kind, the pass, and whether it leaves ink. */
/** @typedef {{row: number, x_mm: number, y_mm: number, z_mm: number, inks: boolean, kind: string, pass: number}} Place */

export const MOST_BYTES = 50_000_000;
const COMMAND = "dobot draw FILE --dry-run --timeline OUT.json";
const VERSION = 1;
/** Limits for a drawing of this arm: three times its reach, and a month. */
const MOST_MM = 1000;
const MOST_S = 31 * 24 * 3600;
const MOST_PASSES = 10_000;

/** A file that is not a timeline: what was found, and what was expected. */
export class Refused extends Error {
  /** @param {string} found @param {string} expected */
  constructor(found, expected) {
    super(`${found}; expected ${expected}, as written by ${COMMAND}`);
  }
}

/** Refuses an empty or too large file before it is read. @param {number} bytes */
export function checkSize(bytes) {
  const large = (bytes / 1e6).toFixed(1);
  if (bytes > MOST_BYTES) throw new Refused(`has ${large} MB`, `a timeline of at most ${MOST_BYTES / 1e6} MB`);
  if (bytes === 0) throw new Refused("is empty", "a timeline");
}

/** @param {string} text @returns {Timeline} */
export const readTimeline = (text) => timelineOf(parse(text));

/** @param {unknown} file @returns {Timeline} */
export function timelineOf(file) {
  if (!isTable(file)) throw new Refused(`holds ${shown(file)}`, "a timeline, which is an object");
  if (file.version === undefined) throw new Refused("has no version", `a timeline of version ${VERSION}`);
  if (file.version !== VERSION) throw new Refused(`has version ${shown(file.version)}`, `a timeline of version ${VERSION}`);
  const duration_s = number(file.duration_s, "duration_s", MOST_S);
  const passes = readPasses(file.passes);
  const moves = readMoves(file.moves, passes.length, duration_s);
  return { duration_s, passes, moves, path: readPath(file.path, moves, duration_s) };
}

/** @param {string} text @returns {unknown} */
function parse(text) {
  try {
    return JSON.parse(text);
  } catch {
    throw new Refused("is not JSON", "a timeline");
  }
}

/** @param {unknown} found @returns {Pass[]} */
function readPasses(found) {
  const passes = list(found, "passes");
  if (passes.length > MOST_PASSES) throw new Refused(`has ${passes.length} passes`, `1 to ${MOST_PASSES}`);
  return passes.map((pass, i) => {
    const where = `passes[${i}]`;
    if (!isTable(pass)) throw new Refused(`has ${shown(pass)} at ${where}`, "a pass");
    const { name, tool, color = null } = pass;
    if (typeof name !== "string") throw new Refused(`has ${shown(name)} at ${where}.name`, "a text");
    if (tool !== "pen" && tool !== "laser") throw new Refused(`has ${shown(tool)} at ${where}.tool`, '"pen" or "laser"');
    if (color !== null && !isColor(color)) throw new Refused(`has ${shown(color)} at ${where}.color`, "red, green and blue from 0 to 255, or null");
    return { name, tool, color };
  });
}

/** @param {unknown} found @param {number} passes @param {number} duration_s @returns {Timeline["moves"]} */
function readMoves(found, passes, duration_s) {
  const moves = table(found, "moves");
  const kinds = list(moves.kinds, "moves.kinds").map((kind, i) => {
    if (typeof kind !== "string") throw new Refused(`has ${shown(kind)} at moves.kinds[${i}]`, "a text");
    return kind;
  });
  const from_s = rising(moves.from_s, "moves.from_s", duration_s);
  const rows = from_s.length;
  const kind = Uint8Array.from(whole(moves.kind, "moves.kind", rows, Math.min(kinds.length, 256) - 1));
  const pass = Uint16Array.from(whole(moves.pass, "moves.pass", rows, passes - 1));
  return { kinds, kind, pass, from_s };
}

/** @param {unknown} found @param {Timeline["moves"]} moves @param {number} duration_s @returns {Timeline["path"]} */
function readPath(found, moves, duration_s) {
  const path = table(found, "path");
  const t_s = rising(path.t_s, "path.t_s", duration_s);
  const rows = t_s.length;
  /** @param {string} name @param {number} least */
  const lengths = (name, least) => Float32Array.from(column(path[name], `path.${name}`, rows, least, MOST_MM));
  const ink = Uint8Array.from(whole(path.ink, "path.ink", rows, 2));
  return {
    t_s,
    x_mm: lengths("x_mm", -MOST_MM),
    y_mm: lengths("y_mm", -MOST_MM),
    z_mm: lengths("z_mm", -MOST_MM),
    ink,
    error_mm: lengths("error_mm", 0),
    pass: passOfRows(t_s, ink, moves),
  };
}

/** Returns the pass of each row; a line has the pass of its start. @param {Float64Array} t_s @param {Uint8Array} ink @param {Timeline["moves"]} moves */
function passOfRows(t_s, ink, { from_s, pass }) {
  let move = 0;
  const passes = new Uint16Array(t_s.length);
  for (let row = 0; row < t_s.length; row += 1) {
    while (move + 1 < from_s.length && from_s[move + 1] <= t_s[row]) move += 1;
    passes[row] = ink[row] === 1 && row > 0 ? passes[row - 1] : pass[move];
  }
  return passes;
}

// --- A moment ----------------------------------------------------------------

/** Returns the last row of an increasing column that is not after this time; the first row if all are. @param {Float64Array} column @param {number} t_s */
export function lastAt(column, t_s) {
  let low = 0;
  let high = column.length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (column[middle] <= t_s) low = middle;
    else high = middle;
  }
  return low;
}

/** @param {Timeline} timeline @param {number} t_s @returns {Place} */
export function placeAt({ path, moves }, t_s) {
  const row = lastAt(path.t_s, t_s);
  const next = Math.min(row + 1, path.t_s.length - 1);
  const span_s = path.t_s[next] - path.t_s[row];
  const share = span_s > 0 ? Math.max(0, (t_s - path.t_s[row]) / span_s) : 0;
  /** @param {Float32Array} column */
  const between = (column) => column[row] + (column[next] - column[row]) * share;
  const move = lastAt(moves.from_s, t_s);
  return {
    row,
    x_mm: between(path.x_mm),
    y_mm: between(path.y_mm),
    z_mm: between(path.z_mm),
    inks: next > row && path.ink[next] === 1,
    kind: moves.kinds[moves.kind[move]],
    pass: moves.pass[move],
  };
}

// --- Validation ---------------------------------------------------

/** @param {unknown} found @returns {found is Record<string, unknown>} */
function isTable(found) {
  return typeof found === "object" && found !== null && !Array.isArray(found);
}

/** @param {unknown} found @returns {found is number[]} */
function isColor(found) {
  return Array.isArray(found) && found.length === 3 && found.every((channel) => Number.isInteger(channel) && channel >= 0 && channel <= 255);
}

/** @param {unknown} found @param {string} name */
function table(found, name) {
  if (!isTable(found)) throw missing(found, name, "a table of columns");
  return found;
}

/** @param {unknown} found @param {string} name @returns {unknown[]} */
function list(found, name) {
  if (!Array.isArray(found)) throw missing(found, name, "a list");
  if (found.length === 0) throw new Refused(`has nothing in ${name}`, "a list of at least one");
  return found;
}

/** @param {unknown} found @param {string} name @param {number} most */
function number(found, name, most) {
  if (!within(found, 0, most)) throw missing(found, name, `a number from 0 to ${most}`);
  return found;
}

/** @param {unknown} found @param {number} least @param {number} most @returns {found is number} */
function within(found, least, most) {
  return typeof found === "number" && found >= least && found <= most;
}

/** @param {unknown} found @param {string} name @param {number} rows @param {number} least @param {number} most @returns {number[]} */
function column(found, name, rows, least, most) {
  const values = list(found, name);
  if (values.length !== rows) throw new Refused(`has ${values.length} rows in ${name}`, `${rows}, as in the other columns`);
  const wrong = values.findIndex((value) => !within(value, least, most));
  if (wrong >= 0) throw new Refused(`has ${shown(values[wrong])} at ${name}[${wrong}]`, `a number from ${least} to ${most}`);
  return /** @type {number[]} */ (values);
}

/** @param {unknown} found @param {string} name @param {number} rows @param {number} most */
function whole(found, name, rows, most) {
  const values = column(found, name, rows, 0, most);
  const wrong = values.findIndex((value) => !Number.isInteger(value));
  if (wrong >= 0) throw new Refused(`has ${shown(values[wrong])} at ${name}[${wrong}]`, "a whole number");
  return values;
}

/** @param {unknown} found @param {string} name @param {number} duration_s */
function rising(found, name, duration_s) {
  const values = Float64Array.from(column(found, name, list(found, name).length, 0, duration_s));
  const wrong = values.findIndex((it, i) => i > 0 && it < values[i - 1]);
  if (wrong >= 0) throw new Refused(`has ${values[wrong]} at ${name}[${wrong}], after ${values[wrong - 1]}`, "a time that does not decrease");
  return values;
}

/** @param {unknown} found @param {string} name @param {string} expected */
function missing(found, name, expected) {
  return new Refused(found === undefined ? `has no ${name}` : `has ${shown(found)} as ${name}`, expected);
}

/** A short description of a value. @param {unknown} found */
function shown(found) {
  if (found === undefined) return "nothing";
  if (Array.isArray(found)) return `a list of ${found.length}`;
  if (isTable(found)) return "an object";
  if (typeof found !== "string") return String(found);
  return JSON.stringify(found.length > 30 ? `${found.slice(0, 30)}…` : found);
}
