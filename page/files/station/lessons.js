// Opens lessons (files of the page), advances them when the condition of a step is met, and reports the student's progress to
// the station of a fleet.

import { begunNow, isDone, progressOf, stepNow } from "../state/learn.js";
import { rowsOf } from "../state/teach.js";

/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {ReturnType<typeof createLessons>} Lessons */

/** Under what name it is reported, for as long as this tab is open: on a computer of a school the next one is another one. */
const STUDENT = "dobot.student";
/** Report interval: a station forgets a student after a minute without a report. */
const REPORT_MS = 20_000;

/** @param {Store} store @param {import("./http.js").Http} http */
export function createLessons(store, http) {
  const { send } = store;
  let reported = "";

  const next = () => send({ type: "lesson_step", step: store.page.learn.step + 1, begun: begunNow(store.page) });

  /** Reports the student's progress if it changed, for the board of the fleet. */
  async function reportProgress() {
    const progress = store.page.fleet === null ? null : progressOf(store.page.learn);
    const text = JSON.stringify(progress);
    if (text === reported) return;
    reported = text;
    if (!progress) return;
    const { problem } = await http.ask("POST", "api/v1/learners", progress);
    send({ type: "lesson_reported", problem: problem ?? null });
  }

  store.subscribe((page, message) => {
    void reportProgress();
    if (page.learn.lesson === null || message.type === "tick") return;
    if (isDone(page, rowsOf(page.teach.text).length)) next();
    else if (stepNow(page) === null) send({ type: "lesson", lesson: null, begun: begunNow(page) });
  });
  setInterval(() => {
    reported = "";
    void reportProgress();
  }, REPORT_MS);
  send({ type: "lesson_student", name: sessionStorage.getItem(STUDENT) ?? "" });

  return {
    next,
    /** @param {typeof import("../state/learn.js").LESSONS[number]} name */
    async open(name) {
      // Few visits open a lesson.
      const { parse } = await import("../vendor/smol-toml/index.js");
      const text = await (await fetch(new URL(`../lessons/${name}.toml`, import.meta.url))).text();
      const lesson = /** @type {import("../state/learn.js").Lesson} */ (/** @type {unknown} */ ({ ...parse(text), name }));
      send({ type: "lesson", lesson, begun: begunNow(store.page) });
    },
    end: () => send({ type: "lesson", lesson: null, begun: begunNow(store.page) }),
    /** Sets the student's name; empty for none. @param {string} name */
    setStudent(name) {
      sessionStorage.setItem(STUDENT, name);
      send({ type: "lesson_student", name });
    },
  };
}
