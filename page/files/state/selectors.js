// Values derived from the state in more than one place.

import { linesOf } from "../preview/appearance.js";
import { EMPTY } from "../stage/view.js";
import { recorded } from "./recordings.js";
import { isSamePerson, timeNow } from "./slots.js";
import { thingsOf } from "./look.js";
import { placeOf } from "./target.js";
import { placeOfStep, rowAt, rowsOf } from "./teach.js";

/** @typedef {import("./state.js").Page} Page */
/** @typedef {import("../stage/view.js").View} View */
/** @typedef {import("./types.js").Near} Near */

/** Age at which the stage turns grey: six statuses are missing. */
const OLD_MS = 500;
/** Age at which a banner reports it. */
const VERY_OLD_MS = 2000;
/** The side of an object that a camera sees: that of a usual marker with its white. */
const SEEN_MM = 25;

/** Why the arm cannot be moved by hand now: the end of a text key. @typedef {"no_connection" | "no_arm" | "locked" | "others_time" | "stopped" | "not_confirmed" | "job_starts" | "job_runs" | "others_control" | "watching_only" | "queueing_only"} BlockedReason */

/** @param {Page} page @returns {BlockedReason | null} */
export function blockedReason(page) {
  const { connection, station, me, role } = page;
  if (connection !== "open" || !station) return "no_connection";
  if (station.link.phase !== "up") return "no_arm";
  if (role === "watch") return "watching_only";
  if (role === "queue") return "queueing_only";
  if (station.lock && role !== "admin") return "locked";
  if (othersTime(page)) return "others_time";
  if (station.stop) return "stopped";
  if (!station.trust.trusted) return "not_confirmed";
  if (page.jobs.starting) return "job_starts";
  if (station.job?.phase === "running") return "job_runs";
  // The first action takes control if it is free.
  if (station.lease && station.lease.client !== me) return "others_control";
  return null;
}

/** The current time slot, if it belongs to another person. An administrator may use the arm during any slot. @param {Page} page */
export function othersTime({ station, role, person }) {
  const now = role === "admin" ? null : timeNow(station);
  return now && !isSamePerson(now.student, person) ? now : null;
}

/** Whether this page has control. @param {Page} page */
export const hasControl = ({ station, me }) => station?.lease != null && station.lease.client === me;

/** Whether the arm is at rest. @param {import("./types.js").Station} station */
export const rests = ({ arm }) => arm !== null && !arm.moving;

/** Whether the arm is the station's own virtual arm. @param {Page} page */
export const isVirtual = ({ station }) => station?.link.address === "virtual:";

/** The mounted tool: that of a virtual arm, or the one set last; an arm that was just switched on assumes the suction cup. @param {Page} page */
export function mountedTool({ around, station }) {
  if (around) return around.tool.kind;
  const setting = station?.settings?.find((command) => command.type === "configuration" && command.mode === "end_effector");
  return setting?.type === "configuration" && setting.mode === "end_effector" ? setting.tool : "suction_cup";
}

/** Time without a message in ms, if one was expected; otherwise 0. @param {Page} page */
export function silence_ms({ station, connection, received_ms, now_ms }) {
  const expected = station !== null && (connection !== "open" || station.link.phase === "up");
  const quiet = now_ms - received_ms;
  return expected && quiet > OLD_MS ? quiet : 0;
}

/** Whether a banner reports the age. @param {Page} page */
export const isVeryOld = (page) => silence_ms(page) > VERY_OLD_MS;

/** @param {Page} page @returns {View["laser"]} */
export function laser({ station }) {
  if (station?.laser.on) return "burning";
  return (station?.laser.armed_for_s ?? 0) > 0 ? "armed" : "off";
}

/** The parts of a view that come from the policy. @param {Page["policy"]} policy @returns {Partial<View>} */
function ruled(policy) {
  if (!policy) return {};
  return {
    limits: { joints: policy.joints, workspace: policy.workspace },
    tool: { kind: "suction_cup", length_mm: policy.tool_length.suction_cup_mm },
    table_z_mm: policy.table.z_mm,
    keepOuts: /** @type {View["keepOuts"]} */ (policy.keep_out),
  };
}

/** The parts of a view that come from the arm's facts, for this tool. @param {Page["facts"]} facts @param {View["tool"]["kind"]} kind @returns {Partial<View>} */
function built(facts, kind) {
  const tool = facts?.tools.find((entry) => entry.kind === kind);
  if (!facts || !tool) return {};
  return { shape: { ...facts.dimensions, reach_mm: tool.reach_mm }, status_s: facts.status_period_s };
}

/**
 * The limits and keep-out zones to highlight: limits of the ghost if there is one, zones near the arm or the ghost.
 * @param {string} text what the arm is near to: states repeat it, and the same text is the same object @param {Near | null} ghost @returns {View["near"]}
 */
function nearBoth(text, ghost) {
  const arm = /** @type {Near} */ (JSON.parse(text));
  /** @type {Record<string, number>} */ const keep_outs = { ...arm.keep_outs };
  for (const [name, closeness] of Object.entries(ghost?.keep_outs ?? {})) keep_outs[name] = Math.max(closeness, keep_outs[name] ?? 0);
  return { limits: (ghost ?? arm)?.limits ?? [], keep_outs };
}

/**
 * Keeps the result of a function for as long as its arguments are the same objects: what is the same costs the stage nothing.
 * @template {unknown[]} A @template R @param {(...of: A) => R} make @returns {(...of: A) => R}
 */
export function memoize(make) {
  /** @type {{ of: A, made: R } | null} */ let last = null;
  return (...of) => {
    if (!last || last.of.some((it, n) => it !== of[n])) last = { of, made: make(...of) };
    return last.made;
  };
}

/** @type {readonly import("../stage/view.js").Point[]} */
const NONE = [];

/** The rows of a program: those of a large one take a moment. */
export const rowsIn = memoize(rowsOf);
const taughtAt = memoize((/** @type {string} */ text, /** @type {number | null} */ chosen) => placeOfStep(text, chosen === null ? undefined : rowsIn(text)[chosen]));

/** The position of the selected program step while the Teach tab is open. @param {Page} page */
export const taughtPlace = ({ tab, teach }) => (tab === "teach" ? taughtAt(teach.text, teach.chosen) : null);

/** Whether the station reports a problem with the selected step. @param {Page["teach"]} teach */
const isChosenBad = ({ text, chosen, report }) => (report?.problems.length ?? 0) > 0 && report?.problems.some(({ line }) => rowAt(rowsIn(text), line) === chosen);

/** The position of the ghost: the selected program step, or the target. @param {Page} page */
export const ghostPlace = (page) => taughtPlace(page) ?? placeOf(page.target);

/** The policy to show: the draft while it is edited. @param {Page} page */
export const shownPolicy = ({ tab, set_up, policy }) => (tab === "set_up" && set_up.drafted) || policy;

const half = (/** @type {number} */ mm) => Math.round(mm * 2) / 2;

/** What the camera sees as objects on the table, to half a millimetre: noise draws nothing. @param {Page["look"]} look @returns {View["things"]} */
const seenThings = (look) => thingsOf(look).map(({ name, x_mm, y_mm, turn_deg, height_mm }) => ({
  name: `seen: ${name}`, shape: { type: "box", size_mm: [SEEN_MM, SEEN_MM, Math.max(height_mm ?? 0, 1)] }, color: "#ff9f1a", at_mm: [half(x_mm), half(y_mm)], turn_deg: Math.round(turn_deg), bottom_mm: 0,
}));

/** Makes views for the stage; the same object for what did not change. */
export function createViewOf() {
  const rules = memoize(ruled);
  const facts = memoize(built);
  const near = memoize(nearBoth);
  const reported = memoize((/** @type {Page["station"]} */ station) => (station?.arm ? { ...station.arm, at_s: station.at_s } : null));
  const then = memoize(recorded);
  const ghostOf = memoize((/** @type {Page["target"]} */ target) => {
    const place = placeOf(target);
    return place && { ...place, refused: target.refused };
  });
  const looked = memoize(seenThings);
  const thingsIn = memoize((/** @type {View["things"]} */ around, /** @type {string} */ seen) => [...around, .../** @type {View["things"]} */ (JSON.parse(seen))]);
  const taughtOf = memoize((/** @type {import("../stage/view.js").Pose} */ place, /** @type {boolean} */ refused) => ({ ...place, refused }));
  const planeOf = memoize((/** @type {Page["draw"]["paper"]} */ plane, /** @type {readonly import("../stage/view.js").Point[]} */ touches) => (plane || touches.length ? { z_mm: plane?.z_mm ?? NaN, slope_x: plane?.slope_x ?? 0, slope_y: plane?.slope_y ?? 0, touches } : null));
  const drawingOf = memoize((/** @type {NonNullable<Page["draw"]["timeline"]>} */ { timeline }) => linesOf(timeline));
  /** @param {Page} page @param {{ dark: boolean, note: string, label: string }} words @returns {View} */
  return (page, { dark, note, label }) => {
    const around = { ...EMPTY, ...rules(shownPolicy(page)), ...page.around };
    const common = { ...around, ...facts(page.facts, around.tool.kind), dark, note, label };
    const arm = then(page.recordings);
    // A recorded arm is grey, without any live values next to it.
    if (arm) return { ...common, arm: common.shape && arm, old: true };
    const taught = taughtPlace(page);
    const seen = looked(page.look);
    const { places, found } = page.touch_paper;
    const plane = found?.paper ?? null;
    return {
      ...common,
      plane: page.tab === "set_up" && places ? planeOf(plane, places) : page.tab === "set_up" || page.tab === "draw" ? planeOf(page.draw.paper, NONE) : null,
      things: seen.length ? thingsIn(around.things, JSON.stringify(seen)) : around.things,
      planned: page.planned,
      drawing: page.tab === "draw" && page.draw.timeline ? drawingOf(page.draw.timeline) : null,
      arm: common.shape && reported(page.station),
      near: near(JSON.stringify(page.station?.arm?.near ?? {}), page.ghost_near),
      laser: laser(page),
      ghost: taught ? taughtOf(taught, isChosenBad(page.teach) ?? false) : ghostOf(page.target),
      // Editing a program moves nothing.
      draggable: taught !== null || blockedReason(page) === null,
      old: silence_ms(page) > 0,
    };
  };
}

/** What is wrong with the link and what to do, in the words of the station. @param {Pick<import("./types.js").Schemas["LinkView"], "problem" | "remedy">} link */
export const linkProblem = ({ problem, remedy }) => [problem, remedy].filter(Boolean).join("; ");
