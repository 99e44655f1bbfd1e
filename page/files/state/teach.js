// A program that is taught: its text is the document, and every view is made of it.

/** @typedef {import("./types.js").Schemas} Schemas */
/** @typedef {import("./types.js").Problem} Problem */
/** @typedef {Schemas["ProgramReport"]} Report */
/** @typedef {"table" | "text" | "time"} Mode */

/** A step as it stands in the text: its lines, counted from 1, and what it says. @typedef {{ line: number, last: number, says: string }} Row */

/**
 * @typedef {object} Teach
 * @property {string} text
 * @property {string} name The name of the file that it came from, or is kept in.
 * @property {readonly string[]} past What was there before, the newest last.
 * @property {readonly string[]} future What was undone, the next one last.
 * @property {number} asked How often the text was changed: an answer to an earlier one is not taken.
 * @property {Report | null} report What the station says of the text.
 * @property {Problem | null} refused Why the last thing that was asked for came to nothing.
 * @property {number | null} chosen Which row.
 * @property {number} first The first row that is seen.
 * @property {Mode} mode
 * @property {Schemas["MovingMode"]} path How captured points are gone to.
 * @property {number | null} job The job that was made of it last.
 */

/** @type {Teach} */
export const NO_TEACH = { text: "", name: "program.toml", past: [], future: [], asked: 0, report: null, refused: null, chosen: null, first: 0, mode: "table", path: "movj", job: null };

/** @typedef {{ type: "teach_text", text: string, chosen?: number | null, name?: string }
 * | { type: "teach_undo" }
 * | { type: "teach_redo" }
 * | { type: "teach_checked", asked: number, report: Report }
 * | { type: "teach_refused", problem: Problem | null }
 * | { type: "teach_chosen", row: number | null }
 * | { type: "teach_scrolled", first: number }
 * | { type: "teach_mode", mode: Mode }
 * | { type: "teach_path", path: Schemas["MovingMode"] }
 * | { type: "teach_job", job: number }} TeachMessage */

/** So many changes can be undone. */
const MOST_PAST = 1000;
const HEADER = /^\s*\[\[steps\]\]\s*(#.*)?$/;
const TABLE = /^\s*\[/;
const OF_STEP = /^\s*\[\[?steps\./;

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

/** Which row a line of the text belongs to. @param {readonly Row[]} rows @param {number | null | undefined} line */
export function rowAt(rows, line) {
  if (line == null) return null;
  const row = rows.findIndex((it) => it.line <= line && line <= it.last);
  return row < 0 ? null : row;
}

/** How long each row takes, in seconds, and what it does in words, as far as the station has said it. @param {readonly Row[]} rows @param {Report | null} report */
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
    // Steps below a step are told by its text.
    step.label = step.count === 1 ? label : rows[row]?.says ?? "";
  }
  return steps;
}

/** The number of the first step of a row, as jobs count them, or nothing. @param {Row | undefined} row @param {Report | null} report */
export function stepOf(row, report) {
  const at = report?.steps.findIndex(({ file, line }) => row && file == null && row.line <= line && line <= row.last) ?? -1;
  return at < 0 ? null : at + 1;
}

/** @param {Teach} teach @param {string} text @param {Partial<Teach>} more @returns {Teach} */
const changed = (teach, text, more) => ({ ...teach, text, asked: teach.asked + 1, refused: null, ...more });

/** @param {Teach} teach @param {import("./message.js").Message} message @returns {Teach} */
export function reduceTeach(teach, message) {
  switch (message.type) {
    case "teach_text": {
      const { text, chosen = teach.chosen, name = teach.name } = message;
      if (text === teach.text) return { ...teach, chosen, name };
      return changed(teach, text, { past: [...teach.past.slice(1 - MOST_PAST), teach.text], future: [], chosen, name });
    }
    case "teach_undo": {
      const text = teach.past.at(-1);
      return text === undefined ? teach : changed(teach, text, { past: teach.past.slice(0, -1), future: [...teach.future, teach.text] });
    }
    case "teach_redo": {
      const text = teach.future.at(-1);
      return text === undefined ? teach : changed(teach, text, { future: teach.future.slice(0, -1), past: [...teach.past, teach.text] });
    }
    case "teach_checked":
      return message.asked === teach.asked ? { ...teach, report: message.report } : teach;
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
    case "teach_job":
      return { ...teach, job: message.job, refused: null };
    default:
      return teach;
  }
}
