// Calibration: the known calibration, and the procedure that records the points of the sheet one by one.

import { rests, silence_ms } from "./selectors.js";

/** @typedef {import("./types.js").Problem} Problem */
/** @typedef {import("./types.js").Schemas} Schemas */
/** @typedef {Schemas["CalibrationFile"]} CalibrationFile */
/** A point that was the next one: what the arm said there, or nothing where it was left out. @typedef {{ point: number, raw_deg: readonly number[] | null, height_mm: number }} Visit */
/** A touched point, and how high the block was on it. @typedef {{ point: number, raw_deg: readonly number[], height_mm: number }} Touch */
/** Why no point can be recorded now: the end of a text key. @typedef {"no_connection" | "no_arm" | "not_confirmed" | "moving"} TouchBlockedReason */

/** A printed sheet and the measured length of its bar. @typedef {{ sheet: number, bar_mm: number }} Print */

/** The fewest points for a fit. */
export const LEAST_TOUCHES = 4;
/** A higher block is none that stands on a sheet, in mm. */
export const HIGHEST_BLOCK_MM = 100;

/** Calibration from a photo: the angles of the arm at each drawn cross, and how far it is. @typedef {{ drawn: readonly (readonly number[])[], state: "none" | "draws" | "interrupted" | "drawn" | "looks" | "few_corners" | "few_crosses" | "unreadable" | "taken", found: number }} Photo */
/** @type {Photo} */
const NO_PHOTO = { drawn: [], state: "none", found: 0 };

/**
 * @typedef {object} Calibrate
 * @property {Schemas["Calibrations"] | null} known
 * @property {Schemas["SheetPoints"] | null} sheet The points of the sheet; null while no calibration runs.
 * @property {string} number Number of the printed sheet, as typed.
 * @property {string} bar Length of the printed bar, as typed.
 * @property {Print | null} print Number of the printed sheet and length of its bar, once accepted by the station.
 * @property {Problem | null} bar_refused Why the bar was refused.
 * @property {string} block Height of the block on the next point, as typed.
 * @property {readonly Visit[]} visits
 * @property {number} revision Revision of the visits; results for earlier revisions are ignored.
 * @property {Schemas["FitReport"] | null} fit The result of the fit.
 * @property {Problem | null} problem Why the fit failed.
 * @property {boolean} tool_measured Whether the person has measured the tool and found it where the fit puts it.
 * @property {CalibrationFile | null} shown The calibration under review.
 * @property {Photo} photo
 * @property {number} lost Number of points discarded by the last reset of the arm.
 */

/** @type {Calibrate} */
export const NO_CALIBRATE = { known: null, sheet: null, number: "", bar: "", print: null, bar_refused: null, block: "", visits: [], revision: 0, fit: null, problem: null, tool_measured: false, shown: null, photo: NO_PHOTO, lost: 0 };

/** @typedef {{ type: "calibrations", known: Schemas["Calibrations"] }
 * | { type: "calibrate_begun", sheet: Schemas["SheetPoints"] }
 * | { type: "calibrate_ended" }
 * | { type: "calibrate_number_typed", text: string }
 * | { type: "calibrate_bar_typed", text: string }
 * | { type: "calibrate_bar", print: Print, problem: Problem | null }
 * | { type: "calibrate_tool_measured" }
 * | { type: "calibrate_block_typed", text: string }
 * | { type: "calibrate_visited", raw_deg: readonly number[] | null }
 * | { type: "calibrate_back" }
 * | { type: "calibrate_fitted", revision: number, fit: Schemas["FitReport"] | null, problem: Problem | null }
 * | { type: "photo_set", set: Partial<Photo> }
 * | { type: "photo_taken", touches: readonly { place_mm: readonly [number, number], raw_deg: readonly number[] }[] }
 * | { type: "calibrate_shown" }} CalibrateMessage */

/** The point to touch next, counted from 0; after the last one of the sheet the first again. @param {Calibrate} calibrate */
export const nextPoint = ({ visits, sheet }) => visits.length % (sheet?.points_mm.length ?? 1);

/** @param {Calibrate} calibrate @returns {Touch[]} */
export const touchesOf = ({ visits }) => visits.flatMap(({ point, raw_deg, height_mm }) => (raw_deg ? [{ point, raw_deg, height_mm }] : []));

/** Height of the block on the next point in mm: 0 if empty, NaN if invalid. @param {Calibrate} calibrate */
function blockHeight({ block }) {
  const height_mm = Number(block);
  return height_mm >= 0 && height_mm <= HIGHEST_BLOCK_MM ? height_mm : NaN;
}

/** The fit request. @param {Calibrate} calibrate */
export function questionOf(calibrate) {
  const { sheet, print, known, tool_measured } = calibrate;
  const touches = touchesOf(calibrate).map(({ point, raw_deg, height_mm }) => ({ place_mm: sheet?.points_mm[point], raw_deg, height_mm }));
  // Keeps the measured backlash.
  return { touches, ...print, tool_measured, backlash: known?.calibration?.backlash };
}

/** A number of a calibration: the end of its word. @typedef {"base" | "rear" | "fore" | "out" | "left" | "axis_x" | "axis_y" | "paper" | "slope_x" | "slope_y" | "slack_base" | "slack_rear" | "slack_fore"} NumberName */

/** The numbers of a calibration; those of the paper are not in every one. @type {readonly [name: NumberName, unit: string, of: (file: CalibrationFile) => number | null][]} */
const NUMBERS = [
  ["base", "°", (calibration) => calibration.zeros.base],
  ["rear", "°", (calibration) => calibration.zeros.rear],
  ["fore", "°", (calibration) => calibration.zeros.fore],
  ["out", " mm", (calibration) => calibration.tool.out_mm],
  ["left", " mm", (calibration) => calibration.tool.left_mm],
  ["axis_x", " mm", (calibration) => calibration.axis.x_mm],
  ["axis_y", " mm", (calibration) => calibration.axis.y_mm],
  ["paper", " mm", (calibration) => calibration.paper && calibration.paper.z_mm],
  ["slope_x", " %", (calibration) => calibration.paper && calibration.paper.slope_x * 100],
  ["slope_y", " %", (calibration) => calibration.paper && calibration.paper.slope_y * 100],
  ["slack_base", "°", (calibration) => calibration.backlash.base],
  ["slack_rear", "°", (calibration) => calibration.backlash.rear],
  ["slack_fore", "°", (calibration) => calibration.backlash.fore],
];

/**
 * The numbers of a calibration, and their change from the previous one.
 * @param {CalibrationFile} file @param {CalibrationFile | null} [before] @returns {{ name: NumberName, unit: string, value: number, by: number | null }[]}
 */
export function numbersOf(file, before = null) {
  return NUMBERS.flatMap(([name, unit, of]) => {
    const value = of(file), was = before && of(before);
    return value === null ? [] : [{ name, unit, value, by: was === null ? null : value - was }];
  });
}

/** @param {import("./state.js").Page} page @returns {TouchBlockedReason | null} */
export function touchBlockedReason(page) {
  const { connection, station } = page;
  if (connection !== "open" || !station || silence_ms(page) > 0) return "no_connection";
  if (station.link.phase !== "up" || !station.arm) return "no_arm";
  if (!station.trust.trusted) return "not_confirmed";
  return rests(station) ? null : "moving";
}

/** Why the next point cannot be recorded now: the end of a text key. @param {import("./state.js").Page} page */
export function pointBlockedReason(page) {
  const reason = touchBlockedReason(page);
  if (reason) return reason;
  if (page.station?.arm?.touch_refused) return "other_side";
  return Number.isNaN(blockHeight(page.calibrate)) ? "no_block" : null;
}

/** The raw joint angles, as the arm reports them. @param {import("./types.js").Arm} arm */
export function rawDegrees(arm) {
  const { base_deg, rear_deg, fore_deg } = arm.raw ?? arm;
  return [base_deg, rear_deg, fore_deg];
}

/** Other visits invalidate earlier results. @param {Calibrate} calibrate @param {readonly Visit[]} visits @returns {Calibrate} */
const visited = (calibrate, visits) => ({ ...calibrate, visits, revision: calibrate.revision + 1, fit: null, problem: null, tool_measured: false, shown: null, lost: 0 });

/** An arm whose pose is not trusted has a new base zero. @param {Calibrate} calibrate @param {import("./types.js").Station} station */
function heard(calibrate, station) {
  const lost = touchesOf(calibrate).length;
  if (station.trust.trusted || (lost === 0 && calibrate.photo.drawn.length === 0)) return calibrate;
  return { ...visited(calibrate, []), photo: NO_PHOTO, lost };
}

/** @param {Calibrate} calibrate @param {import("./message.js").Message} message @returns {Calibrate} */
export function reduceCalibrate(calibrate, message) {
  const { known, revision, visits } = calibrate;
  switch (message.type) {
    case "calibrations":
      return { ...calibrate, known: message.known };
    case "calibrate_begun":
      return { ...NO_CALIBRATE, known, revision: revision + 1, sheet: message.sheet };
    case "calibrate_ended":
      return { ...NO_CALIBRATE, known, revision: revision + 1 };
    case "calibrate_bar_typed":
      return { ...calibrate, bar: message.text, bar_refused: null };
    case "calibrate_number_typed":
      return { ...calibrate, number: message.text, bar_refused: null };
    case "calibrate_bar":
      return { ...calibrate, print: message.problem ? null : message.print, bar_refused: message.problem };
    case "calibrate_tool_measured":
      return { ...calibrate, revision: revision + 1, tool_measured: true };
    case "calibrate_visited":
      return { ...visited(calibrate, [...visits, { point: nextPoint(calibrate), raw_deg: message.raw_deg, height_mm: blockHeight(calibrate) }]), block: "" };
    case "calibrate_block_typed":
      return { ...calibrate, block: message.text };
    case "calibrate_back":
      return visits.length ? visited(calibrate, visits.slice(0, -1)) : calibrate;
    case "calibrate_fitted":
      return message.revision === revision ? { ...calibrate, fit: message.fit, problem: message.problem } : calibrate;
    case "photo_set":
      return { ...calibrate, photo: { ...calibrate.photo, ...message.set } };
    case "photo_taken": {
      // The crosses are the points now.
      const { touches } = message, points_mm = touches.map(({ place_mm: [x, y] }) => /** @type {[number, number]} */ ([x, y]));
      const taken = visited(calibrate, touches.map(({ raw_deg }, point) => ({ point, raw_deg, height_mm: 0 })));
      return { ...taken, sheet: calibrate.sheet && { ...calibrate.sheet, points_mm }, photo: { ...calibrate.photo, state: "taken", found: touches.length } };
    }
    case "calibrate_shown":
      return { ...calibrate, shown: calibrate.fit?.calibration ?? null };
    case "state":
      return heard(calibrate, message.station);
    default:
      return calibrate;
  }
}
