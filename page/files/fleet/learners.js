// A student in a lesson, on a tile and in the details.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { LESSONS } from "../state/learn.js";
import { formatDuration } from "../i18n/i18n.js";
import { isStuck } from "./members.js";

/** @typedef {import("./members.js").Learner} Learner */

/** Returns the name of a lesson; another version of the page may have others. @param {import("../i18n/i18n.js").Translate} t @param {string} name */
function lessonName(t, name) {
  const known = LESSONS.find((lesson) => lesson === name);
  return known ? t(`learn.${known}`) : name;
}

/** A line of a tile or of the details. @param {import("../i18n/i18n.js").Translate} t @param {Learner} learner @param {number} others number of further students */
export function learnerLine(t, learner, others = 0) {
  const { student, lesson, done, steps, for_s } = learner;
  return html`<p class="learner" data-stuck=${String(isStuck(learner))}><strong>${student}${others ? ` +${others}` : nothing}</strong> <span class="lesson-name">${lessonName(t, lesson)}</span> <span class="lesson-step">${done < steps ? t("fleet.learner", { step: done + 1, steps }) : t("fleet.learner.done")}</span> <span class="lesson-time">${t("fleet.learner.for", { time: formatDuration(t, for_s) })}</span></p>`;
}
