// The question of a running program, and its answers.

import { html, nothing } from "../vendor/lit-html/lit-html.js";

/** @typedef {import("./context.js").Context} Context */
/** @typedef {import("../state/types.js").Job} Job */

/** @param {Pick<Context, "page" | "t" | "act">} context @param {Job} job */
export function jobQuestion({ page, t, act }, job) {
  const { question } = job;
  if (!question) return nothing;
  const answer = (/** @type {import("../api").components["schemas"]["Answer"]} */ given) => act.ask({ type: "answer_job", job: job.job, question: question.number, answer: given });
  if (question.asks === "choice") {
    return html`
      <div id="job-question" class="question" role="group" aria-labelledby="job-asks">
        <p id="job-asks" role="status"><strong>${question.text}</strong></p>
        ${question.answers.map((text) => html`<button type="button" class="small strong" @click=${() => answer({ choice: text })}>${text}</button>`)}
      </div>`;
  }
  if (question.asks !== "place") return nothing;
  const give = (/** @type {SubmitEvent} */ event) => {
    event.preventDefault();
    const given = new FormData(/** @type {HTMLFormElement} */ (event.target));
    const [x_mm, y_mm, z_mm] = AXES.map((axis) => Number(given.get(axis)));
    answer({ place: { name: question.name, x_mm, y_mm, z_mm, rotation_deg: 0 } });
  };
  return html`
    <form id="job-question" class="question" aria-labelledby="job-asks" @submit=${give}>
      <p id="job-asks" role="status"><strong>${t("job.asks_place", { name: question.name })}</strong></p>
      ${AXES.map((axis) => html`<label>${axis} <input name=${axis} type="number" step="any" required .value=${String(Math.round(page.station?.arm?.[/** @type {"x_mm"} */ (`${axis}_mm`)] ?? 0))}></label>`)}
      <button type="submit" class="small strong">${t("job.give_place")}</button>
    </form>`;
}

const AXES = ["x", "y", "z"];
