// The jobs of the station (active, queued, finished) and its recordings.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { repeat } from "../vendor/lit-html/directives/repeat.js";
import { placeFor, groupJobs } from "../state/jobs.js";
import { problemLine } from "../views/problem.js";
import { formatDuration } from "../i18n/i18n.js";
import { sketchPicture } from "../parts/sketch.js";
import { jobKey } from "../state/files.js";
import { recordings } from "./recordings.js";

/** @typedef {import("../views/context.js").Context} Context */
/** @typedef {import("../i18n/i18n.js").TextKey} TextKey */
/** @typedef {import("../state/jobs.js").JobView} JobView */

export const TONES = { queued: "off", running: "good", paused: "warn", stopped: "off", done: "good", failed: "bad" };

/** @param {Context} context */
export const jobs = (context) => html`${list(context)}${recordings(context)}`;

/** @param {Context} context */
function list(context) {
  const { page, t } = context;
  const { all } = page.jobs;
  const now = /** @type {JobView | null} */ (page.station?.job ?? null);
  const groups = groupJobs(all ?? [], now);
  return html`
    <section class="card" aria-labelledby="jobs-title">
      <h2 id="jobs-title">${t("jobs")}</h2>
      ${all?.length === 0 ? html`<p id="jobs-none" class="drop quiet">${t("jobs.none")}</p>` : nothing}
      ${/** @type {const} */ (["active", "waiting", "finished"]).map((name) => (groups[name].length ? html`
        <h3 id="jobs-${name}">${t(`jobs.${name}`)}</h3>
        <ol class="jobs" aria-labelledby="jobs-${name}">${repeat(groups[name], ({ job }) => job, (job) => entry(context, job, groups.waiting))}</ol>` : nothing))}
    </section>`;
}

/** @param {Context} context @param {JobView} job @param {readonly JobView[]} waiting */
function entry(context, job, waiting) {
  const { page, t } = context;
  const { refused } = page.jobs;
  const sketch = page.files.sketches[jobKey(job.job)];
  const begun = job.phase === "running" || job.phase === "paused";
  return html`
    <li class="entry pictured" data-job=${job.job}>
      ${sketchPicture(sketch, t("files.picture", { name: job.title }))}
      <div>
      <p class="head"><strong class="name">${job.title}</strong> <span class="chip" data-tone=${TONES[job.phase]}>${t(`job.${job.phase}`)}</span></p>
      ${begun ? html`<progress max="1" .value=${job.commands ? job.completed / job.commands : 0} aria-label=${t("job.progress")}></progress>` : nothing}
      <p class="quiet">${t(`jobs.kind.${job.kind}`)} · ${t("job.count", { done: job.completed, all: job.commands })} · ${time(t, job)}${sketch?.drawn_mm ? html` · <span class="ink">${t(job.phase === "done" ? "jobs.ink" : "jobs.to_draw", { m: (sketch.drawn_mm / 1000).toFixed(2) })}</span>` : nothing}</p>
      <p class="quiet">${t("jobs.queued_at", { time: new Date(job.created_ms).toLocaleString(page.language) })}${job.reason ? html` · <span class="reason">${job.reason}</span>` : nothing}</p>
      <div class="row">${acts(context, job, waiting)}</div>
      ${refused?.job === job.job ? html`<p class="status" data-tone="bad" role="alert">${problemLine(context, refused.problem)}</p>` : nothing}
      </div>
    </li>`;
}

/** Actual, remaining or planned duration. @param {Context["t"]} t @param {JobView} job */
function time(t, { phase, took_s, left_s, planned_s }) {
  if (took_s != null) return t("jobs.took", { time: formatDuration(t, took_s) });
  if (left_s != null && phase !== "queued") return t("jobs.left", { time: formatDuration(t, left_s) });
  return planned_s == null ? t("jobs.untimed") : t("jobs.takes", { time: formatDuration(t, planned_s) });
}

/** The actions for a job. The first button changes its meaning with the phase, and stays the same element, which keeps the focus. @param {Context} context @param {JobView} job @param {readonly JobView[]} waiting */
function acts({ page, t, act }, { job, phase, title }, waiting) {
  const button = (/** @type {string} */ id, /** @type {TextKey} */ word, /** @type {() => void} */ does, strong = false, off = false) => html`
    <button type="button" class="small ${strong ? "strong" : ""}" data-act=${id} aria-label=${`${t(word)}: ${title}`} ?disabled=${off} @click=${does}>${t(word)}</button>`;
  const moves = (/** @type {-1 | 1} */ way, /** @type {TextKey} */ word, /** @type {string} */ arrow) => {
    const place = placeFor(waiting, job, way);
    return html`<button type="button" class="small" data-act=${way < 0 ? "up" : "down"} aria-label=${`${t(word)}: ${title}`} title=${t(word)} ?disabled=${place === undefined} @click=${() => place !== undefined && act.jobs.move(job, place)}>${arrow}</button>`;
  };
  const runs = page.station?.job?.phase === "running";
  const end = button("end", "jobs.end", () => act.jobs.end(job));
  switch (phase) {
    case "queued":
      return [button("start", "jobs.start", () => act.jobs.start(job), true, runs), end, moves(-1, "jobs.up", "↑"), moves(1, "jobs.down", "↓")];
    case "running":
      return [button("pause", "job.pause", () => act.jobs.pause(job)), end];
    case "paused":
      return [button("start", "job.resume", () => act.jobs.start(job), true, runs), end];
    default:
      return [button("again", "jobs.again", () => void act.jobs.again(job)), button("forget", "jobs.remove", () => act.jobs.forget(job))];
  }
}
