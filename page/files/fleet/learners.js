// The students in lessons: read of all stations, and told.

import { html } from "../vendor/lit-html/lit-html.js";
import { LESSONS } from "../state/learn.js";
import { span } from "../words/words.js";
import { isStuck, isThere } from "./members.js";

/** @typedef {import("./fleet.js").Store} Store */
/** @typedef {import("./members.js").Learner} Learner */

/** How far students are no station tells by itself: all are asked so often. */
const AGAIN_MS = 4000;

/** Asks all stations that are there, for as long as the board is seen. @param {Store} store @param {import("../station/http.js").Http} http */
export function followLearners(store, http) {
  /** @type {number | undefined} */ let timer;

  async function read() {
    clearTimeout(timer);
    const { connection, members } = store.page;
    if (connection !== "open") return;
    const names = document.hidden ? [] : [...new Set(members.filter(isThere).map(({ name }) => name))];
    /** @type {import("../station/http.js").Outcome<import("./state.js").MemberAnswer[]>} */
    const { value } = names.length ? await http.ask("POST", "api/v1/fleet/requests", { to: { members: names }, method: "GET", path: "/api/v1/learners" }) : { value: [] };
    if (value?.length) store.send({ type: "learners", answers: value });
    timer = setTimeout(() => void read(), AGAIN_MS);
  }

  store.listen((_, { type }) => {
    if (type === "fleet") void read();
  });
}

/** What a lesson is called; another version of the page may have others. @param {import("../words/words.js").Say} say @param {string} name */
function lessonName(say, name) {
  const known = LESSONS.find((it) => it === name);
  return known ? say(`learn.${known}`) : name;
}

/** A line of a tile or of the details. @param {import("../words/words.js").Say} say @param {Learner} learner */
export function learnerLine(say, learner) {
  const { student, lesson, done, steps, for_s } = learner;
  return html`<p class="learner" data-stuck=${String(isStuck(learner))}><strong>${student}</strong> <span class="lesson-name">${lessonName(say, lesson)}</span> <span class="lesson-step">${done < steps ? say("fleet.learner", { step: done + 1, steps }) : say("fleet.learner.done")}</span> <span class="lesson-time">${say("fleet.learner.for", { time: span(say, for_s) })}</span></p>`;
}
