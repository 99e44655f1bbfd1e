// A problem in the user's terms: its text in the language of the page, and a button for what solves it.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { blockedReason } from "../state/selectors.js";
import { formatDuration } from "../i18n/i18n.js";
import { kindOf, problemText } from "../i18n/problem_text.js";

/** @typedef {import("./context.js").Context} Context */
/** @typedef {import("../state/types.js").Problem} Problem */
/** @typedef {import("../i18n/i18n.js").TextKey} TextKey */

/** The question that arms the laser. @param {Pick<Context, "t" | "act">} context */
export const armLaser = ({ t, act }) => act.question({ about: "arm_laser", values: { time: formatDuration(t, act.arming_s()) } });

/** What solves a condition that blocks the arm. @param {Context} context @param {string} kind @returns {[TextKey, () => void] | null} */
function remedyOf({ page, t, act }, kind) {
  const { station } = page;
  switch (kind) {
    case "no-lease":
      return station?.lease ? ["control.request", () => void act.ask({ type: "ask_lease" })] : ["control.take", () => void act.ask({ type: "take_lease" })];
    case "stopped":
      return ["stopped.reset", () => act.question({ about: "reset_stop" })];
    case "not_confirmed":
      return ["pose.confirm", () => act.question({ about: "confirm_pose" })];
    case "laser-disarmed":
      return ["tool.laser.arm", () => armLaser({ t, act })];
    case "job-running":
      return station?.job ? ["job.pause", () => act.jobs.pause(station.job?.job ?? 0)] : null;
    case "cannot-resume":
      return station?.job ? ["jobs.end", () => act.jobs.end(station.job?.job ?? 0)] : null;
    case "needs-a-person":
      return station?.job ? ["job.resume", () => act.jobs.start(station.job?.job ?? 0)] : null;
    case "not-laser":
      return ["missing.mount_laser", () => void act.command({ type: "configuration", mode: "end_effector", tool: "laser" })];
    case "no-pen":
      return ["draw.add_pen", () => void act.addPen()];
    case "no-height":
      return ["draw.here", () => act.useHeight()];
    default:
      return null;
  }
}

/** The problem types of the reasons that block the arm. */
const KINDS = /** @type {Record<string, string>} */ ({ others_control: "no-lease", stopped: "stopped", not_confirmed: "not_confirmed", job_runs: "job-running" });

/** The button that solves a problem type, a missing condition, or a reason that blocks the arm. @param {Context} context @param {string} kind */
export function remedyButton(context, kind) {
  const remedy = remedyOf(context, KINDS[kind] ?? kind);
  return remedy ? html`<button type="button" class="small" data-remedy=${kind} @click=${remedy[1]}>${context.t(remedy[0])}</button>` : nothing;
}

/** A problem with its button. @param {Context} context @param {Problem} problem */
export const problemLine = (context, problem) => html`${problemText(context.t, problem)} ${remedyButton(context, kindOf(problem))}`;

/** Why the arm cannot be moved by hand now, with a button. @param {Context} context */
export function blockedLine(context) {
  const why = blockedReason(context.page);
  return why ? html`${context.t(`blocked.${why}`)} ${remedyButton(context, why)}` : nothing;
}
