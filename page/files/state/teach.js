// The program being taught: its text is the document, and all views are derived from it.

import { parse } from "../vendor/smol-toml/index.js";

/** @typedef {import("./types.js").Schemas} Schemas */
/** @typedef {import("./types.js").Problem} Problem */
/** @typedef {Schemas["ProgramReport"]} Report */
/** @typedef {"blocks" | "table" | "text" | "time"} Mode */

/** The text that a change removed at an offset, and the text that it inserted. @typedef {{ at: number, was: string, is: string }} Change */

/** @typedef {import("../stage/view.js").Pose} Pose */

/** A place that the arm touched. @typedef {Schemas["RecordedPlace"]} Touched */

/** What is taught from touched places. @typedef {{ kind: "point" | "tray" | "frame", name: string, places: readonly Touched[], columns: number, rows: number, layers: number, layer_mm: number }} Wizard */

/** A step as it stands in the text: its lines, counted from 1, and what it says. @typedef {{ line: number, last: number, says: string }} Row */

/**
 * @typedef {object} Teach
 * @property {string} text
 * @property {string} name The name of the file that it came from, or is kept in.
 * @property {readonly Change[]} past Undo history, newest last.
 * @property {readonly Change[]} future Redo history, next one last.
 * @property {number} revision Revision of the text; results for earlier revisions are ignored.
 * @property {Report | null} report The station's report on the text.
 * @property {Problem | null} refused Why the last request was refused.
 * @property {number | null} chosen The selected row.
 * @property {number} first The first row that is seen.
 * @property {{ from: string, given_up: boolean } | null} dragged The text before the place of the chosen step was taken on the stage, until it is let go.
 * @property {{ from: number, to: number } | null} carried The row being dragged, and its new place if it is dropped.
 * @property {{ to: number, of: number } | null} moved The new place of the step that was moved last.
 * @property {Mode} mode
 * @property {Schemas["MovingMode"]} path Path type of captured points.
 * @property {number | null} recorded How many places of a jogged path are recorded; null if none is being recorded.
 * @property {{ job: number, text: string, chosen: number | null } | null} ran The job that was made of it last, from which text, and the row that was chosen then.
 * @property {Wizard} wizard
 */

/** @type {Wizard} */
const NO_WIZARD = { kind: "tray", name: "tray", places: [], columns: 3, rows: 4, layers: 1, layer_mm: 20 };

/** @type {Teach} */
export const NO_TEACH = { text: "", name: "program.toml", past: [], future: [], revision: 0, report: null, refused: null, chosen: null, first: 0, dragged: null, carried: null, moved: null, mode: "table", path: "movj", recorded: null, ran: null, wizard: NO_WIZARD };

/** @typedef {{ type: "teach_text", text: string, chosen?: number | null, name?: string }
 * | { type: "teach_undo" }
 * | { type: "teach_redo" }
 * | { type: "teach_checked", revision: number, report: Report }
 * | { type: "teach_refused", problem: Problem | null }
 * | { type: "teach_chosen", row: number | null }
 * | { type: "teach_scrolled", first: number }
 * | { type: "teach_placed", place: Pose, phase: "drag" | "drop" }
 * | { type: "teach_carried", carried: { from: number, to: number } | null }
 * | { type: "teach_moved", to: number, of: number }
 * | { type: "teach_mode", mode: Mode }
 * | { type: "teach_path", path: Schemas["MovingMode"] }
 * | { type: "teach_recorded", places: number | null }
 * | { type: "teach_wizard", set: Partial<Wizard> }
 * | { type: "teach_job", ran: NonNullable<Teach["ran"]> }} TeachMessage */

/** The most undo steps. */
const MOST_PAST = 1000;
const HEADER = /^\s*\[\[steps\]\]\s*(#.*)?$/;
const TABLE = /^\s*\[/;
const OF_STEP = /^\s*\[\[?steps\./;
const GO = /^\s*go\s*=\s*(?:\{([^}]*)\}|"([^"]*)")/;
/** Places in a frame of their own, and angles, are not places of the stage. */
const ELSEWHERE = /\b(frame|base|rear|fore|servo)\s*=/;

/** The lines of a title that the text does not have. */
const TITLE_LINES = 2;

/** The endings of the files that are programs: ours, and the vendor's. */
export const PROGRAM_ENDINGS = [".toml", ".xml", ".play", ".playback"];

/** The text with a title, which a job has to have: the name of its file where it says none. @param {string} text @param {string} name */
export const titled = (text, name) => (/^\s*title\s*=/m.test(text) ? text : `title = ${JSON.stringify(name.replace(/\.toml$/, ""))}\n\n${text}`);

/** The steps of a text, as they stand in it. @param {string} text @returns {Row[]} */
export function rowsOf(text) {
  /** @type {Row[]} */ const rows = [];
  /** @type {string[] | null} */ let said = null;
  const lines = text.split("\n");
  const close = (/** @type {number} */ last) => {
    const row = rows.at(-1);
    if (!said || !row) return;
    row.last = last;
    row.says = said.join(", ");
  };
  lines.forEach((line, n) => {
    if (HEADER.test(line)) {
      close(n);
      rows.push({ line: n + 1, last: n + 1, says: "" });
      said = [];
    } else if (TABLE.test(line) && !OF_STEP.test(line)) {
      close(n);
      said = null;
    } else if (said && line.trim() && !line.trim().startsWith("#")) {
      said.push(line.trim().replace(/\s*#[^"]*$/, ""));
    }
  });
  close(lines.length);
  return rows;
}

/** Returns the row of a line in the text. @param {readonly Row[]} rows @param {number | null | undefined} line */
export function rowAt(rows, line) {
  if (line == null) return null;
  let low = 0, high = rows.length;
  // The last row that starts at or above the line.
  while (low < high) {
    const middle = (low + high) >> 1;
    if (/** @type {Row} */ (rows[middle]).line <= line) low = middle + 1;
    else high = middle;
  }
  return low > 0 && line <= /** @type {Row} */ (rows[low - 1]).last ? low - 1 : null;
}

/** @param {string} table @param {string} name */
const numberIn = (table, name) => new RegExp(`\\b${name}\\s*=\\s*([-+.\\w]+)`).exec(table)?.[1];

/** The line, counted from 0, in which the place of a step stands: its own, or that of the point that it names. @param {readonly string[]} lines @param {Row} row */
function lineOfPlace(lines, row) {
  for (let n = row.line; n < row.last && !TABLE.test(lines[n] ?? ""); n += 1) {
    const found = GO.exec(lines[n] ?? "");
    if (found?.[1] !== undefined) return n;
    if (found) return lineOfPoint(lines, found[2] ?? "");
  }
  return -1;
}

/** @param {readonly string[]} lines @param {string} name */
function lineOfPoint(lines, name) {
  let inPoints = false;
  return lines.findIndex((line) => {
    if (TABLE.test(line)) inPoints = /^\s*\[points\]/.test(line);
    return inPoints && /^\s*"?([^"=]*?)"?\s*=\s*\{/.exec(line)?.[1] === name;
  });
}

/** The place that a step goes to, if it is one of the stage. @param {string} text @param {Row | undefined} row @returns {Pose | null} */
export function placeOfStep(text, row) {
  if (!row) return null;
  const lines = text.split("\n");
  const table = /\{([^}]*)\}/.exec(lines[lineOfPlace(lines, row)] ?? "")?.[1] ?? "";
  if (ELSEWHERE.test(table)) return null;
  const [x_mm = NaN, y_mm = NaN, z_mm = NaN, rotation_deg = 0] = ["x", "y", "z", "rotation"].map((name) => {
    const number = numberIn(table, name);
    return number === undefined ? undefined : Number(number);
  });
  return [x_mm, y_mm, z_mm, rotation_deg].every(Number.isFinite) ? { x_mm, y_mm, z_mm, rotation_deg } : null;
}

/** Returns the text with a new position for a step; everything else is unchanged. @param {string} text @param {Row} row @param {Pose} place */
export function withPlace(text, row, { x_mm, y_mm, z_mm, rotation_deg }) {
  const lines = text.split("\n");
  const at = lineOfPlace(lines, row);
  lines[at] = (lines[at] ?? "").replace(/\{[^}]*\}/, (table) => {
    for (const [name, value] of Object.entries({ x: x_mm, y: y_mm, z: z_mm })) table = table.replace(new RegExp(`(\\b${name}\\s*=\\s*)[-+.\\w]+`), `$1${value}`);
    const turned = /(\brotation\s*=\s*)[-+.\w]+/;
    if (turned.test(table)) return table.replace(turned, `$1${rotation_deg}`);
    return rotation_deg === 0 ? table : table.replace(/\s*\}$/, `, rotation = ${rotation_deg} }`);
  });
  return lines.join("\n");
}

/** The edit that teaches the place of a step again: of its named point, or of the step, whose other keys stay. @param {string} text @param {number} row @param {Schemas["Point"]} place @param {Schemas["MovingMode"]} path of a step that went nowhere @returns {Schemas["Edit"]} */
export function retaught(text, row, place, path) {
  const { steps, points } = /** @type {{ steps?: Record<string, any>[], points?: object }} */ (parse(text, { integersAsBigInt: "asNeeded" }));
  const step = steps?.[row] ?? {};
  const key = ["go", "pick", "place"].find((it) => it in step);
  const name = key && step[key];
  if (typeof name === "string" && points && Object.hasOwn(points, name)) return { type: "set_point", name, point: place };
  return { type: "replace", at: row, step: key ? { ...step, [key]: place } : { go: place, path } };
}

/** Returns the change between two texts. @param {string} from @param {string} to @returns {Change} */
export function changeOf(from, to) {
  const most = Math.min(from.length, to.length);
  let at = 0, end = 0;
  while (at < most && from.charCodeAt(at) === to.charCodeAt(at)) at += 1;
  while (end < most - at && from.charCodeAt(from.length - 1 - end) === to.charCodeAt(to.length - 1 - end)) end += 1;
  return { at, was: from.slice(at, from.length - end), is: to.slice(at, to.length - end) };
}

/** @param {string} text @param {Change} change */
const undone = (text, { at, was, is }) => text.slice(0, at) + was + text.slice(at + is.length);
/** @param {string} text @param {Change} change */
const redone = (text, { at, was, is }) => text.slice(0, at) + is + text.slice(at + was.length);

/** Duration in seconds and label of each row, if the station has reported them. @param {readonly Row[]} rows @param {Report | null} report */
export function stepsIn(rows, report) {
  const steps = rows.map(({ says }) => ({ takes_s: 0, count: 0, label: says }));
  let row = 0;
  for (const { line, file, takes_s, label } of report?.steps ?? []) {
    if (file != null) continue;
    // Steps mostly stand in their order: a search from the beginning for each of ten thousand would be felt.
    if (!(rows[row] && rows[row].line <= line && line <= rows[row].last)) row = rowAt(rows, line) ?? row;
    const step = steps[row];
    if (!step) continue;
    step.takes_s += takes_s;
    step.count += 1;
    // Nested steps are shown by the text of their parent.
    step.label = step.count === 1 ? label : rows[row]?.says ?? "";
  }
  return steps;
}

/** The line of the step that the job of the program is at, while the text is that of the job. @param {Teach} teach @param {Schemas["JobView"] | null | undefined} job */
export function currentLine({ text, name, ran }, job) {
  const line = job?.program?.line;
  if (!line || !ran || ran.job !== job.job || ran.text !== text) return null;
  return titled(text, name) === text ? line : line - TITLE_LINES;
}

/** @param {Teach} teach @param {string} text @param {Partial<Teach>} more @returns {Teach} */
const changed = (teach, text, more) => ({ ...teach, text, revision: teach.revision + 1, refused: null, moved: null, ...more });

/** The past with one more change. @param {Teach} teach @param {string} from @param {string} to */
const remembered = ({ past }, from, to) => ({ past: [...past.slice(1 - MOST_PAST), changeOf(from, to)], future: [] });

/** The place of the chosen step is dragged on the stage, or let go: then it is one change. @param {Teach} teach @param {Pose} place @param {"drag" | "drop"} phase @returns {Teach} */
function placed(teach, place, phase) {
  const { dragged, text, chosen } = teach;
  if (dragged?.given_up) return phase === "drop" ? { ...teach, dragged: null } : teach;
  const row = chosen === null ? undefined : rowsOf(text)[chosen];
  if (!row || !placeOfStep(text, row)) return { ...teach, dragged: null };
  const from = dragged?.from ?? text, to = withPlace(text, row, place);
  if (phase === "drag") return changed(teach, to, { dragged: { from, given_up: false } });
  return changed(teach, to, { dragged: null, ...(to === from ? {} : remembered(teach, from, to)) });
}

/** Stopping the arm cancels the drag. @param {Teach} teach @returns {Teach} */
function givenUp(teach) {
  const left = teach.carried ? { ...teach, carried: null } : teach;
  const { dragged } = left;
  return dragged && !dragged.given_up ? changed(left, dragged.from, { dragged: { ...dragged, given_up: true } }) : left;
}

/** @param {Teach} teach @param {import("./message.js").Message} message @returns {Teach} */
export function reduceTeach(teach, message) {
  switch (message.type) {
    case "teach_text": {
      const { text, chosen = teach.chosen, name = teach.name } = message;
      if (text === teach.text) return { ...teach, chosen, name };
      return changed(teach, text, { ...remembered(teach, teach.text, text), dragged: null, chosen, name });
    }
    case "teach_undo": {
      const change = teach.past.at(-1);
      return change && !teach.dragged ? changed(teach, undone(teach.text, change), { past: teach.past.slice(0, -1), future: [...teach.future, change] }) : teach;
    }
    case "teach_redo": {
      const change = teach.future.at(-1);
      return change && !teach.dragged ? changed(teach, redone(teach.text, change), { future: teach.future.slice(0, -1), past: [...teach.past, change] }) : teach;
    }
    case "teach_placed":
      return placed(teach, message.place, message.phase);
    case "stop_pressed":
      return givenUp(teach);
    case "teach_carried":
      return { ...teach, carried: message.carried };
    case "teach_moved":
      return { ...teach, moved: { to: message.to, of: message.of } };
    case "teach_checked":
      return message.revision === teach.revision ? { ...teach, report: message.report } : teach;
    case "teach_refused":
      return { ...teach, refused: message.problem };
    case "teach_chosen":
      return { ...teach, chosen: message.row };
    case "teach_scrolled":
      return message.first === teach.first ? teach : { ...teach, first: message.first };
    case "teach_mode":
      return { ...teach, mode: message.mode };
    case "teach_path":
      return { ...teach, path: message.path };
    case "teach_recorded":
      return { ...teach, recorded: message.places };
    case "teach_wizard":
      return { ...teach, wizard: { ...teach.wizard, ...message.set } };
    case "teach_job":
      return { ...teach, ran: message.ran, refused: null };
    default:
      return teach;
  }
}
