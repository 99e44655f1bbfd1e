// Details of one arm of the fleet: state, jobs and actions.

import { clientName } from "../views/people.js";
import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { repeat } from "../vendor/lit-html/directives/repeat.js";
import { stops } from "../input/stop_button.js";
import { TONES } from "../panels/jobs.js";
import { groupJobs } from "../state/jobs.js";
import { linkProblem } from "../state/selectors.js";
import { formatClock, formatDuration } from "../i18n/i18n.js";
import { resetQuestion } from "./footer.js";
import { learnerLine } from "./learners.js";
import { alarms, isThere, lockOf, pageOf, share } from "./members.js";
import { ofArm } from "./queue_list.js";
import { slotsOfArm } from "./slot_form.js";
import { problemText } from "../i18n/problem_text.js";

/** @typedef {import("./fleet.js").Context} Context */
/** @typedef {import("./members.js").Member} Member */
/** @typedef {import("../state/jobs.js").JobView} JobView */
/** @typedef {import("../i18n/i18n.js").TextKey} TextKey */

/** The most finished jobs that are listed. */
const MOST_FINISHED = 5;

/** @param {Context} context */
export function details(context) {
  const { board, t, act } = context;
  const member = board.members.find(({ id }) => id === board.chosen);
  if (!member) return nothing;
  const { id, name, presence, state } = member, page = pageOf(member);
  const to = { members: [name] };
  const listener = stops(() => void act.stop(to));
  return html`
    <div class="details-head">
      <h2 id="details-title">${name}</h2>
      ${page ? html`<a id="details-page" href=${page} target="_blank" rel="noreferrer">${t("fleet.page")}</a>` : nothing}
      <button id="details-close" type="button" class="small" @click=${() => act.send({ type: "chosen", id: null })}>${t("close")}</button>
    </div>
    <canvas class="picture" data-arm=${id} aria-hidden="true"></canvas>
    <p class="alarms">${alarms(member).map(({ word, tone }) => html`<span class="chip" data-tone=${tone}>${t(word, { left: formatClock(state?.laser.armed_for_s ?? 0) })}</span> `)}</p>
    ${reasons(context, member)}
    <div class="row">
      <button id="details-stop" type="button" class="stops" @pointerdown=${listener} @click=${listener}>${t("fleet.stop.one", { name })}</button>
      ${state?.stop ? html`<button id="details-reset" type="button" class="small" ?disabled=${!isThere(member)} @click=${() => act.send({ type: "question", question: resetQuestion(board.language, [member]) })}>${t("stopped.reset")}</button>` : nothing}
      <button id="details-drawing" type="button" class="small" ?disabled=${!isThere(member) || !member.about?.is_virtual} @click=${() => void act.saveDrawings(to)}>${t("fleet.drawing")}</button>
      ${endArm(context, member)}
    </div>
    ${presence.type === "present" ? html`${numbers(context, member)}${learners(context, member)}${slotsOfArm(context, member)}${ofArm(context, member)}${jobs(context, member)}` : nothing}`;
}

/** A virtual arm that was given can be ended where it was given. @param {Context} context @param {Member} member */
function endArm({ board, t, act }, { name, about }) {
  const giver = about?.given_by;
  if (giver == null) return nothing;
  const isGone = !board.members.some((other) => other.name === giver && isThere(other));
  return html`<button id="details-end-arm" type="button" class="small" ?disabled=${isGone} @click=${() => act.send({ type: "question", question: { about: "fleet_end_arm", giver, name, values: { name } } })}>${t("fleet.arm.end")}</button>`;
}

/** The reasons of the alarms, in the station's own words. @param {Context} context @param {Member} member */
function reasons({ t }, { presence, state }) {
  const stop = state?.stop, lock = lockOf(state);
  const texts = [
    presence.type === "away" ? t("fleet.offline.text") : "",
    presence.type === "refused" ? problemText(t, presence.problem) : "",
    stop ? t(stop.of_fleet ? "stopped.by_fleet" : "stopped.by", { by: stop.by, why: stop.reason ? `: ${stop.reason}` : "", rest: t(!stop.delivered ? "stopped.not_delivered" : stop.at_rest ? "stopped.at_rest" : "stopped.moving") }) : "",
    lock ? `${t("locked.title")} ${t("locked.by", { by: lock.by, why: lock.message ? `: ${lock.message}` : "" })}` : "",
    state?.arm && !state.trust.trusted ? state.trust.reason ?? "" : "",
    state ? linkProblem(state.link) : "",
  ];
  return html`${texts.filter(Boolean).map((text) => html`<p class="reason">${text}</p>`)}`;
}

/** @param {Context} context @param {Member} member */
function numbers({ t }, { about, state }) {
  const arm = state?.arm, lease = state?.lease;
  /** @type {[TextKey, string][]} */ const rows = [
    ["fleet.control", lease ? t("fleet.control.for", { name: clientName(t, lease), time: formatDuration(t, state.at_s - lease.since_s) }) : t("fleet.free")],
    ["fleet.asks", lease?.asked_by.map(({ name }) => name).join(", ") || "–"],
    ["fleet.where", arm ? ["x_mm", "y_mm", "z_mm"].map((axis) => Math.round(Number(arm[/** @type {"x_mm"} */ (axis)]))).join(", ") + " mm" : "–"],
    ["watch.statuses", t("watch.statuses.value", { rate: state?.link.statuses_per_s.toFixed(1) ?? "–" })],
    ["watch.address", state?.link.address ?? t("watch.not_found")],
    ["fleet.groups", about?.groups.join(", ") || "–"],
    ["fleet.offers", about?.offers.join(", ") || "–"],
    ["fleet.version", about?.version ?? "–"],
    ...(about?.given_by == null ? [] : [/** @type {[TextKey, string]} */ (["fleet.arm.host", about.given_by])]),
  ];
  return html`<dl class="facts">${rows.map(([word, value]) => html`<div><dt>${t(word)}</dt><dd>${value}</dd></div>`)}</dl>`;
}

/** @param {Context} context @param {Member} member */
function learners({ t }, { learners = [] }) {
  return learners.length ? html`<h3 id="details-learners">${t("fleet.learners")} <small>${learners.length}</small></h3>${learners.map((learner) => learnerLine(t, learner))}` : nothing;
}

/** @param {Context} context @param {Member} member */
function jobs(context, { name, state }) {
  const { board, t } = context;
  if (!board.jobs) return html`<p class="quiet">${t("fleet.jobs.reading")}</p>`;
  const groups = groupJobs(board.jobs, /** @type {JobView | null} */ (state?.job ?? null));
  const finished = groups.finished.slice(0, MOST_FINISHED);
  return html`
    <h3 id="details-jobs">${t("jobs")} <small>${t("fleet.jobs.waiting", { number: groups.waiting.length })}</small></h3>
    ${[groups.active, groups.waiting, finished].map((jobs) => (jobs.length ? html`<ol class="jobs" aria-labelledby="details-jobs">${repeat(jobs, ({ job }) => job, (job) => entry(context, name, job, state?.job?.phase === "running"))}</ol>` : nothing))}`;
}

/** @param {Context} context @param {string} name @param {JobView} job @param {boolean} runs */
function entry({ t, act }, name, job, runs) {
  const { phase, title, left_s } = job;
  const begun = phase === "running" || phase === "paused";
  const button = (/** @type {string} */ id, /** @type {TextKey} */ word, /** @type {() => void} */ does, off = false) => html`<button type="button" class="small" data-act=${id} aria-label=${`${t(word)}: ${title}`} ?disabled=${off} @click=${does}>${t(word)}</button>`;
  return html`
    <li class="entry" data-job=${job.job}>
      <p class="job"><span class="title">${title}</span> <span class="chip" data-tone=${TONES[phase]}>${t(`job.${phase}`)}</span></p>
      ${begun ? html`<progress max="1" .value=${share(job)} aria-label=${t("job.progress")}></progress>` : nothing}
      ${left_s != null && begun ? html`<p class="quiet">${t("jobs.left", { time: formatDuration(t, left_s) })}</p>` : nothing}
      ${job.reason ? html`<p class="quiet">${job.reason}</p>` : nothing}
      ${begun || phase === "queued" ? html`
        <div class="row">
          ${phase === "running" ? button("pause", "job.pause", () => act.pauseJob(name)) : button("start", phase === "paused" ? "job.resume" : "jobs.start", () => void act.startJob(name, job.job), runs)}
          ${button("end", "jobs.end", () => act.endJob(name, job.job))}
        </div>` : nothing}
    </li>`;
}
