// The footer: STOP and the current job.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { live } from "../vendor/lit-html/directives/live.js";
import { stops } from "../input/stop_button.js";
import { hasControl } from "../state/selectors.js";
import { formatDuration } from "../i18n/i18n.js";
import { jobQuestion } from "./job_question.js";

/** @typedef {import("./context.js").Context} Context */
/** @typedef {import("../state/types.js").Job} Job */

/** @param {Context} context */
export function footer(context) {
  const { page, t, act } = context;
  const listener = stops(act.stop);
  return html`
    <button id="stop" type="button" aria-describedby="stop-keys" @pointerdown=${listener} @click=${listener}>${t("stop")} <small id="stop-keys">${t("stop.keys")}</small></button>
    ${lateStop(context)}
    ${page.station?.job ? job(context, page.station.job) : html`<p id="no-job" class="quiet wide">${t("job.none")}</p>`}`;
}

/** Status of a STOP that was not answered in time. @param {Context} context */
function lateStop({ page: { late_stop }, t }) {
  if (!late_stop) return nothing;
  const { after_s } = late_stop;
  return html`<p id="late-stop" data-tone=${after_s === null ? "bad" : "good"} role="alert">${after_s === null ? t("stop.unanswered") : t("stop.answered", { after: formatDuration(t, after_s) })}</p>`;
}

/** @param {Context} context @param {Job} job */
function job({ page, t, act }, job) {
  const { phase, commands, completed, left_s } = job;
  const count = { done: completed, all: commands };
  const waits = phase !== "running";
  return html`
    <section id="job" class="job" aria-label=${t("job")}>
      <p class="title"><strong id="job-name">${job.title}</strong> <span id="job-phase" class="chip" role="status" data-tone=${phase === "running" ? "good" : "warn"}>${t(`job.${phase}`)}</span></p>
      <progress id="job-progress" max="1" .value=${commands ? completed / commands : 0} aria-label=${t("job.progress")}></progress>
      <p id="job-left" class="quiet">${left_s === null ? t("job.count", count) : t("job.left", { ...count, left: formatDuration(t, left_s) })}</p>
      <p id="job-waits" class="waits" role="status" ?hidden=${!waits || !job.reason}><span id="job-reason">${waits ? job.reason : ""}</span></p>
      ${jobQuestion({ page, t, act }, job)}
      <div class="acts">
        <button id=${waits ? "resume" : "pause"} type="button" class="small ${waits ? "strong" : ""}" @click=${() => (waits ? act.jobs.start(job.job) : act.jobs.pause(job.job))}>${t(waits ? "job.resume" : "job.pause")}</button>
        <button id="job-end" type="button" class="small" @click=${() => act.jobs.end(job.job)}>${t("jobs.end")}</button>
        <button id="job-adjust" type="button" class="small" aria-expanded=${page.adjusts ? "true" : "false"} aria-controls="adjust" @click=${() => act.send({ type: "adjusts", open: !page.adjusts })}>${t("job.adjust")}</button>
        ${adjustment({ page, t, act }, job)}
      </div>
    </section>`;
}

/** Height offset as text. @param {Context["t"]} t @param {number} mm */
function height(t, mm) {
  if (mm === 0) return t("job.as_planned");
  return `${mm > 0 ? "+" : "−"}${Math.abs(mm).toFixed(1)} mm`;
}

/** @param {Pick<Context, "page" | "t" | "act">} context @param {Job} job */
function adjustment({ page, t, act }, job) {
  const percent = page.dialed_percent ?? job.speed_percent;
  const value = (/** @type {Event} */ event) => Number(/** @type {HTMLInputElement} */ (event.target).value);
  const dial = (/** @type {Event} */ event) => act.send({ type: "dialed", percent: value(event) });
  const set = (/** @type {Event} */ event) => {
    void act.ask({ type: "set_job_speed", percent: value(event) });
    act.send({ type: "dialed", percent: null });
  };
  return html`
    <fieldset id="adjust" class=${page.adjusts ? "" : "is-folded"} ?disabled=${page.station?.lease != null && !hasControl(page)}>
      <label>${t("job.speed")} <input id="job-speed" type="range" min="10" max="200" step="5" .value=${live(String(percent))} @input=${dial} @change=${set}></label>
      <output id="job-speed-shown" for="job-speed">${Math.round(percent)} %</output>
      ${job.speed_percent === 100 ? nothing : html`<button id="job-speed-planned" type="button" class="small" @click=${() => act.ask({ type: "set_job_speed", percent: 100 })}>${t("job.as_planned")}</button>`}
      <span class="height" role="group" aria-label=${t("job.height")}>
        <span aria-hidden="true">${t("job.height")}</span>
        <button id="job-lower" type="button" class="small" aria-label=${t("job.lower")} @click=${() => act.raiseJob(-0.1)}>−</button>
        <output id="job-height-shown">${height(t, job.height_mm)}</output>
        <button id="job-higher" type="button" class="small" aria-label=${t("job.higher")} @click=${() => act.raiseJob(0.1)}>+</button>
        ${job.height_mm === 0 ? nothing : html`<button id="job-height-planned" type="button" class="small" @click=${() => act.ask({ type: "set_job_height", offset_mm: 0 })}>${t("job.as_planned")}</button>`}
      </span>
    </fieldset>`;
}
