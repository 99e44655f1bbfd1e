// The shared queue: its jobs, and the form for a new one.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { repeat } from "../vendor/lit-html/directives/repeat.js";
import { problemText, sentence } from "../i18n/problem_text.js";
import { share } from "./members.js";
import { canCancel, canReassign, ofMember, groupWork } from "./queue.js";
import { submission } from "./submit.js";

/** @typedef {import("./fleet.js").Context} Context */
/** @typedef {import("./queue.js").WorkView} WorkView */
/** @typedef {import("../i18n/i18n.js").TextKey} TextKey */

/** The most finished jobs, and the most suitable jobs of one arm, that are listed. */
const MOST_FINISHED = 20, MOST_SUITABLE = 5;
const TONES = { waiting: "off", offered: "off", taken: "good", done: "good", failed: "bad", cancelled: "off" };

/** @param {Context} context */
export function queue(context) {
  const { board, t, act } = context;
  if (!board.queue.open) return nothing;
  return html`
    <div class="details-head">
      <h2 id="queue-title">${t("fleet.queue")}</h2>
      <button id="queue-close" type="button" class="small" @click=${() => act.send({ type: "queue_open", open: false })}>${t("close")}</button>
    </div>
    ${list(context, ["doubt", "assigned", "waiting"])}
    ${submission(context)}
    ${list(context, ["finished"])}`;
}

/** @param {Context} context @param {readonly (keyof ReturnType<typeof groupWork>)[]} names */
function list(context, names) {
  const { board: { queue: { all } }, t } = context;
  const groups = groupWork(all ?? []);
  return html`
    ${names.includes("waiting") && !groups.waiting.length ? html`<p id="queue-none" class="quiet">${t(all ? "fleet.queue.none" : "fleet.queue.reading")}</p>` : nothing}
    ${names.map((name) => (groups[name].length ? html`
      <h3 id="queue-${name}">${t(`fleet.queue.${name}`)} <small>${groups[name].length}</small></h3>
      <ol class="jobs" aria-labelledby="queue-${name}">${repeat(groups[name].slice(0, name === "finished" ? MOST_FINISHED : undefined), ({ id }) => id, (work) => entry(context, work))}</ol>` : nothing))}`;
}

/** @param {Context} context @param {WorkView} work */
function entry(context, work) {
  const { board: { queue: { refused } }, t } = context;
  const { id, title, phase, doubt, reason, before = [] } = work;
  return html`
    <li class="entry" data-work=${id} data-phase=${phase} data-doubtful=${String(doubt != null)}>
      <p class="job"><span class="title">${title}</span> <span class="chip" data-tone=${doubt == null ? TONES[phase] : "warn"}>${t(doubt == null ? `fleet.work.${phase}` : "fleet.work.doubt")}</span></p>
      <p class="quiet whose">${whose(context, work)}</p>
      ${place(context, work)}
      ${doubt == null ? nothing : html`<p class="status-of" data-tone="warn">${sentence(doubt)}.</p>`}
      ${reason ? html`<p class="quiet">${sentence(reason)}</p>` : nothing}
      ${before.map((attempt) => html`<p class="quiet before">${t("fleet.work.before", { name: attempt.member.name, drawn: attempt.drawn })}</p>`)}
      ${acts(context, work)}
      ${refused?.work === id ? html`<p class="status-of" data-tone="bad" role="alert">${problemText(t, refused.problem)}</p>` : nothing}
    </li>`;
}

/** Student, requirements and submission time. @param {Context} context @param {WorkView} work */
const whose = ({ board, t }, { student, group, needs, submitted_ms }) => [
  group ? `${student} (${group})` : student,
  ...(needs.length ? [t("fleet.work.needs", { needs: needs.join(", ") })] : []),
  t("fleet.work.at", { time: new Date(submitted_ms).toLocaleTimeString(board.language, { hour: "2-digit", minute: "2-digit" }) }),
].join(" · ");

/** The assigned arm and its progress. @param {Context} context @param {WorkView} work */
function place({ t }, { member, job, phase, doubt }) {
  if (!member) return nothing;
  const begun = phase === "taken" && job && (job.phase === "running" || job.phase === "paused");
  return html`
    <p class="where">${job ? t("fleet.work.job", { name: member.name, job: job.job, phase: t(`job.${job.phase}`) }) : member.name}</p>
    ${begun && doubt == null ? html`<progress max="1" .value=${share(job)} aria-label=${t("job.progress")}></progress>` : nothing}`;
}

/** @param {Context} context @param {WorkView} work */
function acts(context, work) {
  const { t, act } = context;
  const asks = (/** @type {"reassign" | "cancel"} */ what) => {
    const { id, title, doubt, reason, member } = work;
    const why = doubt ?? reason;
    act.send({ type: "question", question: { about: `fleet_${what}`, work: id, values: { title, name: member?.name ?? "", why: why ? `${sentence(why)}. ` : "" } } });
  };
  const button = (/** @type {"reassign" | "cancel"} */ what) => html`<button type="button" class="small" data-act=${what} aria-label=${`${t(`fleet.work.${what}`)}: ${work.title}`} @click=${() => asks(what)}>${t(`fleet.work.${what}`)}</button>`;
  if (!canReassign(work) && !canCancel(work)) return nothing;
  return html`<div class="row">${canReassign(work) ? button("reassign") : nothing}${canCancel(work) ? button("cancel") : nothing}</div>`;
}

/** The queue as seen from one arm: assigned, offered and suitable jobs. @param {Context} context @param {import("./members.js").Member} member */
export function ofArm(context, member) {
  const { board, t } = context;
  const { has, suitable } = ofMember(board.queue.all, member);
  if (!has.length && !suitable.length) return nothing;
  return html`
    <h3 id="details-queue">${t("fleet.queue")} <small>${t("fleet.queue.suitable", { number: suitable.length })}</small></h3>
    <ol class="jobs" aria-labelledby="details-queue">${repeat([...has, ...suitable.slice(0, MOST_SUITABLE)], ({ id }) => id, (work) => html`
      <li class="entry" data-work=${work.id}>
        <p class="job"><span class="title">${work.title}</span> <span class="chip" data-tone=${work.doubt == null ? TONES[work.phase] : "warn"}>${t(work.doubt == null ? `fleet.work.${work.phase}` : "fleet.work.doubt")}</span></p>
        <p class="quiet">${whose(context, work)}</p>
      </li>`)}
    </ol>`;
}
