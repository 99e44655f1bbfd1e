// Opens lessons, which are files of the page, and goes on in them when what a step waits for has happened.

import { begunNow, isDone, stepNow } from "../state/learn.js";
import { rowsOf } from "../state/teach.js";
import { parse } from "../vendor/smol-toml/index.js";

/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {ReturnType<typeof createLessons>} Lessons */

/** @param {Store} store */
export function createLessons(store) {
  const { send } = store;

  const next = () => send({ type: "lesson_step", step: store.page.learn.step + 1, begun: begunNow(store.page) });

  store.listen((page, message) => {
    if (page.learn.lesson === null || message.type === "tick") return;
    if (isDone(page, rowsOf(page.teach.text).length)) next();
    else if (stepNow(page) === null) send({ type: "lesson", lesson: null, begun: begunNow(page) });
  });

  return {
    next,
    /** @param {typeof import("../state/learn.js").LESSONS[number]} name */
    async open(name) {
      const text = await (await fetch(`lessons/${name}.toml`)).text();
      const lesson = /** @type {import("../state/learn.js").Lesson} */ (/** @type {unknown} */ (parse(text)));
      send({ type: "lesson", lesson, begun: begunNow(store.page) });
    },
    end: () => send({ type: "lesson", lesson: null, begun: begunNow(store.page) }),
  };
}
