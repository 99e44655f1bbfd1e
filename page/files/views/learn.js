// Lessons: the current step, and the list.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { live } from "../vendor/lit-html/directives/live.js";
import { LABEL } from "../i18n/i18n.js";
import { LESSONS, stepNow } from "../state/learn.js";
import { nameForm } from "./name.js";
import { problemText } from "../i18n/problem_text.js";

/** @typedef {import("./context.js").Context} Context */

/** @param {Context} context */
export function learn(context) {
  const { page, t, act } = context;
  if (page.learn.chooses) return list(context);
  const step = stepNow(page), lesson = page.learn.lesson;
  if (!lesson || !step) return nothing;
  return html`
    <section id="lesson" class="first" aria-labelledby="lesson-title">
      <p class="quiet"><span id="lesson-title">${t(`learn.${lesson.name}`)}</span> · ${t("learn.step", { step: page.learn.step + 1, steps: lesson.steps.length })}</p>
      <p id="lesson-text" role="status">${withLabels(t, t(/** @type {import("../i18n/i18n.js").TextKey} */ (`lesson.${lesson.name}.${page.learn.step + 1}`)))}</p>
      ${step.until?.answer ? answer(context) : nothing}
      ${page.fleet === null ? nothing : student(context)}
      <div class="row">
        ${step.until ? nothing : html`<button id="lesson-next" type="button" class="small strong" @click=${() => act.lessons.next()}>${t(page.learn.step + 1 < lesson.steps.length ? "learn.next" : "learn.done")}</button>`}
        ${step.until ? html`<button id="lesson-skip" type="button" class="small" @click=${() => act.lessons.next()}>${t("learn.skip")}</button>` : nothing}
        <button id="lesson-end" type="button" class="small" @click=${() => act.lessons.end()}>${t("learn.end")}</button>
      </div>
    </section>`;
}

/** A text with the labels of the controls that it names by their keys: [tab.move]. @param {Context["t"]} t @param {string} text */
const withLabels = (t, text) => text.split(LABEL).map((part, n) => (n % 2 ? html`<strong>${t(/** @type {import("../i18n/i18n.js").TextKey} */ (part)).replace(/ ?…$/, "")}</strong>` : part));

/** @param {Context} context */
const answer = ({ page, t, act }) => html`
  <label class="answer">${t("learn.answer")} <input id="lesson-answer" inputmode="decimal" autocomplete="off" .value=${live(page.learn.answer)} @input=${(/** @type {Event} */ event) => act.send({ type: "lesson_answer", text: /** @type {HTMLInputElement} */ (event.target).value })}></label>`;

/** Under what name the board shows how far this page is. @param {Context} context */
function student(context) {
  const { page, t, act } = context;
  if (page.name) return html`<p class="row"><span id="lesson-student" class="quiet">${page.learn.reportProblem ? problemText(t, page.learn.reportProblem) : t("learn.student.shown", { name: page.name })}</span> <button id="lesson-not-me" type="button" class="small" @click=${() => act.setName("")}>${t("name.not_me")}</button></p>`;
  return html`<p class="quiet">${t("learn.student")}</p>${nameForm(context, "lesson-who")}`;
}

/** @param {Context} context */
const list = ({ t, act }) => html`
  <section id="lessons" class="first" aria-labelledby="lessons-title">
    <p><strong id="lessons-title">${t("learn")}</strong></p>
    <div class="row">
      ${LESSONS.map((name) => html`<button type="button" class="small" data-lesson=${name} @click=${() => void act.lessons.open(name)}>${t(`learn.${name}`)}</button>`)}
      <button id="lessons-close" type="button" class="small" @click=${() => act.send({ type: "lesson_choose", open: false })}>${t("close")}</button>
    </div>
  </section>`;

/** Marks the element that the step points to. @param {import("../state/state.js").Page} page */
export function point(page) {
  const wanted = page.learn.chooses ? undefined : stepNow(page)?.show;
  const now = document.querySelector("[data-here]"), next = wanted ? document.querySelector(wanted) : null;
  if (now === next) return;
  now?.removeAttribute("data-here");
  next?.setAttribute("data-here", "");
}
