// What the page announces to a person who looks elsewhere: the end of a job, a job that waits for a person, a lost arm. Pure.

import { sentence } from "../i18n/problem_text.js";

/** @typedef {import("./state.js").Page} Page */
/** @typedef {import("../i18n/i18n.js").Translate} Translate */
/** @typedef {{ notify: boolean, sound: boolean, permission: NotificationPermission | "insecure" }} Alerts */
/** @typedef {{ type: "alerts", alerts: Alerts }} AlertsMessage */

/** @type {Alerts} */
export const NO_ALERTS = { notify: false, sound: false, permission: "default" };

/** @param {Alerts} alerts @param {import("./message.js").Message} message @returns {Alerts} */
export const reduceAlerts = (alerts, message) => (message.type === "alerts" ? message.alerts : alerts);

/**
 * What this change announces, or null.
 * @param {Page} before
 * @param {Page} page
 * @param {import("./message.js").Message} message
 * @param {{ job: number, title: string } | null} last the last job that ran: the station may report its end after it has left it
 * @param {Translate} t
 */
export function newsOf(before, page, message, last, t) {
  if (message.type === "notice" && message.notice.type === "link_lost") return t("alerts.lost");
  if (message.type === "notice" && message.notice.type === "job") return overText(page, message.notice, last, t);
  const job = page.station?.job, was = before.station?.job;
  const waits = job && (job.waits_for_person || job.question);
  if (message.type !== "state" || !waits || (was?.job === job.job && (was.waits_for_person || was.question))) return null;
  return t("alerts.person", { title: job.title, why: job.reason ?? (job.question && "text" in job.question ? job.question.text : "") });
}

/** @param {Page} page @param {{ job: number, phase: string }} notice @param {{ job: number, title: string } | null} last @param {Translate} t */
function overText({ jobs }, { job, phase }, last, t) {
  if (phase !== "done" && phase !== "stopped" && phase !== "failed") return null;
  const title = (last?.job === job ? last : jobs.all?.find((it) => it.job === job))?.title ?? sentence(t("files.last", { job }));
  return phase === "done" ? t("alerts.done", { title }) : t("alerts.over", { title, phase: t(`job.${phase}`) });
}

/** The progress of the job, 0 to 1, or null. @param {Page} page */
function progressOf({ station, connection }) {
  const job = connection === "open" ? station?.job : null;
  return job?.commands ? job.completed / job.commands : null;
}

/** The title of the browser's tab. @param {Page} page @param {Translate} t */
export function titleOf(page, t) {
  const progress = progressOf(page);
  if (progress === null) return "Dobot station";
  return t("alerts.title", { percent: Math.floor(100 * progress), title: page.station?.job?.title ?? "" });
}

/** The icon of the tab while a job runs: a ring that fills in steps of a twentieth; yellow while the job waits. @param {Page} page */
export function iconOf(page) {
  const progress = progressOf(page);
  if (progress === null) return null;
  const color = page.station?.job?.phase === "running" ? "%2327ae60" : "%23f2994a";
  const filled = Math.floor(20 * progress) * 5;
  return `data:image/svg+xml,<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 64 64'><g fill='none' stroke-width='12'><circle cx='32' cy='32' r='25' stroke='%23999'/><circle cx='32' cy='32' r='25' stroke='${color}' pathLength='100' stroke-dasharray='${filled} 100' transform='rotate(-90 32 32)'/></g></svg>`;
}
