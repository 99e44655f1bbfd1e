// @ts-check
// Appearance and layout of a timeline: pure calculations before drawing.

/** @typedef {import("./timeline.js").Timeline} Timeline */
/** Width and height in CSS pixels, and how many device pixels each of them has. */
/** @typedef {{width: number, height: number, ratio: number}} Frame */
/** The styles of the ink classes, and the class of each row. */
/** @typedef {{classes: Uint16Array, styles: {color: string, width_mm: number}[]}} Look */
/** Position of the base frame on the sheet. */
/** @typedef {{frame: Frame, scale: number, x: (y_mm: number) => number, y: (x_mm: number) => number}} View */

// --- What the colours mean: as in the picture that `dobot draw --picture` makes ----

const INK_MM = 0.42;
const PASSES = ["#1b2a41", "#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7a5195"];
const ERRORS = [
  { color: "#007a5a", width_mm: 0.34 },
  { color: "#e69f00", width_mm: 0.42 },
  { color: "#d1341f", width_mm: 0.95 },
];

/** By the pass that left it. @param {Timeline} timeline @returns {Look} */
export function lookOfPasses({ passes, path }) {
  const styles = passes.map((pass, i) => ({ color: passColor(pass.color, i), width_mm: INK_MM }));
  return { classes: path.pass, styles };
}

/** By how far it is from the wanted path. @param {Timeline} timeline @param {number} tolerance_mm @returns {Look} */
export function lookOfErrors({ path }, tolerance_mm) {
  /** @param {number} error_mm Thousandths: the columns are kept in single precision. */
  const classOf = (error_mm) => {
    const error = Math.round(error_mm * 1000) / 1000;
    return Number(error > tolerance_mm / 2) + Number(error > tolerance_mm);
  };
  return { classes: Uint16Array.from(path.error_mm, classOf), styles: ERRORS };
}

/** The colour of the file, darkened if it is too light for paper. @param {number[] | null} color @param {number} pass */
function passColor(color, pass) {
  if (!color) return PASSES[pass % PASSES.length];
  const brightness = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
  const share = brightness > 200 ? 130 / brightness : 1;
  return `rgb(${color.map((channel) => Math.trunc(channel * share)).join(", ")})`;
}

// --- In words, and over time -----------------------------------------------------

const MOST_LETTERS = 60;

/** Names of the error colours. @param {import("../i18n/i18n.js").Translate} t @param {number} tolerance_mm */
export function errorNames(t, tolerance_mm) {
  return [t("play.error.half", { mm: tolerance_mm / 2 }), t("play.error.whole", { mm: tolerance_mm }), t("play.error.more")];
}

/** Its name, shortened, or its number. @param {import("../i18n/i18n.js").Translate} t @param {{name: string, tool: string}} pass @param {number} i */
export function passName(t, { name, tool }, i) {
  const short = name.length > MOST_LETTERS ? `${name.slice(0, MOST_LETTERS)}…` : name;
  return (short || t("play.pass.number", { number: i + 1 })) + (tool === "laser" ? ` (${t("play.laser")})` : "");
}

/** Formats a time as 1:05 or 2:03:04. @param {number} seconds */
export function clock(seconds) {
  const whole = Math.round(seconds);
  const [hours, minutes, rest] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60, whole % 60];
  const two = String(rest).padStart(2, "0");
  return hours ? `${hours}:${String(minutes).padStart(2, "0")}:${two}` : `${minutes}:${two}`;
}

/** Returns the class of the ink for each column of the time bar, -1 without ink. @param {Timeline} timeline @param {Look} look @param {number} columns */
export function inkOfColumns({ duration_s, path }, look, columns) {
  const inks = new Int32Array(columns).fill(-1);
  if (duration_s === 0) return inks;
  const { t_s, ink } = path;
  for (let row = 1; row < t_s.length; row += 1) {
    if (ink[row] !== 1) continue;
    const [from, to] = [t_s[row - 1], t_s[row]].map((time_s) => Math.floor((time_s / duration_s) * (columns - 1)));
    inks.fill(look.classes[row], from, to + 1);
  }
  return inks;
}

// --- Where it lies ---------------------------------------------------------------

export const EDGE = 18;
/** Height of the marks below the drawing. */
const MARKS = 34;

/** @param {Timeline} timeline */
export function boundsOf({ path }) {
  /** @param {Float32Array} column */
  const ends = (column) => {
    let [least, most] = [column[0], column[0]];
    for (const it of column) {
      if (it < least) least = it;
      if (it > most) most = it;
    }
    return [least, most];
  };
  return { x: ends(path.x_mm), y: ends(path.y_mm) };
}

/** Returns the height for a canvas of this width. @param {{x: number[], y: number[]}} bounds @param {number} width @param {number} most */
export function heightFor({ x, y }, width, most) {
  const share = Math.max(1, x[1] - x[0]) / Math.max(1, y[1] - y[0]);
  return Math.round(Math.max(220, Math.min(most, (width - 2 * EDGE) * share + EDGE + MARKS)));
}

/** The view from above, from behind the arm: X up, Y to the left. @param {{x: number[], y: number[]}} bounds @param {Frame} frame @returns {View} */
export function viewOf({ x, y }, frame) {
  const { width, height } = frame;
  const across = (width - 2 * EDGE) / Math.max(1, y[1] - y[0]);
  const scale = Math.min(across, (height - EDGE - MARKS) / Math.max(1, x[1] - x[0]));
  const middle = { x: (x[0] + x[1]) / 2, y: (y[0] + y[1]) / 2 };
  return {
    frame,
    scale,
    x: (y_mm) => width / 2 + (middle.y - y_mm) * scale,
    y: (x_mm) => (height - MARKS + EDGE) / 2 + (middle.x - x_mm) * scale,
  };
}

/** One, two or five times a power of ten, as long as fits. @param {number} most */
export function roundLength(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  return power * ([5, 2].find((factor) => factor * power <= most) ?? 1);
}

/** The lines of a timeline for the stage: its ways, and its ink in the colours of the passes. @param {Timeline} timeline @returns {import("../stage/view.js").Drawing} */
export function linesOf(timeline) {
  const { x_mm, y_mm, z_mm, ink } = timeline.path;
  const { classes, styles } = lookOfPasses(timeline);
  const count = Math.max(0, ink.length - 1);
  const ends_mm = new Float32Array(count * 6);
  const inks = new Int32Array(count);
  for (let n = 0; n < count; n += 1) {
    ends_mm.set([x_mm[n], y_mm[n], z_mm[n], x_mm[n + 1], y_mm[n + 1], z_mm[n + 1]], n * 6);
    inks[n] = ink[n + 1] === 1 ? classes[n + 1] : -1;
  }
  return { ends_mm, inks, colors: styles.map(({ color }) => color) };
}
