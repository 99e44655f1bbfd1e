// Lessons: steps with the condition for the next step. Pure; the steps are in `lessons/`, their texts in `i18n/`.

/** @typedef {import("./state.js").Page} Page */

/** The condition of a step; a step without one has a button.
 * @typedef {{ moved_mm?: number, near?: { x: number, y: number, z: number, within: number }, steps?: number, cycles?: number, notice?: string, drawing?: boolean, idle?: boolean, refused?: boolean, answer?: { is: number, within: number } }} Until
 */
/** @typedef {{ show?: string, until?: Until }} Step */
/** `name` is that of its file. @typedef {{ name: typeof LESSONS[number], minutes: number, steps: readonly Step[] }} Lesson */
/** Conditions at the start of a step. @typedef {{ at: readonly [number, number, number] | null, notice: number }} Begun */

/**
 * @typedef {object} Learn
 * @property {Lesson | null} lesson
 * @property {number} step Counted from 0.
 * @property {Begun} begun
 * @property {string} answer The typed answer.
 * @property {boolean} chooses Whether the lesson list is open.
 * @property {import("./types.js").Problem | null} reportProblem Why the last report was refused.
 */

/** @type {Learn} */
export const NO_LEARN = { lesson: null, step: 0, begun: { at: null, notice: 0 }, answer: "", chooses: false, reportProblem: null };

/** The lessons, by the names of their files, in their order. */
export const LESSONS = /** @type {const} */ (["tour", "coordinates", "kinematics", "pick_and_place"]);

/** @typedef {{ type: "lesson", lesson: Lesson | null, begun: Begun }
 * | { type: "lesson_step", step: number, begun: Begun }
 * | { type: "lesson_answer", text: string }
 * | { type: "lesson_choose", open: boolean }
 * | { type: "lesson_reported", problem: import("./types.js").Problem | null }} LearnMessage */

/** @param {Learn} learn @param {import("./message.js").Message} message @returns {Learn} */
export function reduceLearn(learn, message) {
  switch (message.type) {
    case "lesson":
      return { ...NO_LEARN, lesson: message.lesson, begun: message.begun, reportProblem: learn.reportProblem };
    case "lesson_step":
      return { ...learn, step: message.step, begun: message.begun, answer: "" };
    case "lesson_answer":
      return { ...learn, answer: message.text };
    case "lesson_choose":
      return { ...learn, chooses: message.open };
    case "name":
      return { ...learn, reportProblem: null };
    case "lesson_reported":
      return { ...learn, reportProblem: message.problem };
    default:
      return learn;
  }
}

/** Conditions now, for a step that starts. @param {Page} page @returns {Begun} */
export function begunNow(page) {
  const arm = page.station?.arm;
  return { at: arm ? [arm.x_mm, arm.y_mm, arm.z_mm] : null, notice: page.notices.at(-1)?.number ?? 0 };
}

/** The step that a person is at. @param {Page} page @returns {Step | null} */
export const stepNow = ({ learn }) => learn.lesson?.steps[learn.step] ?? null;

/** The progress report for the station; null without a name or a lesson. @param {Page} page */
export const progressOf = ({ learn: { lesson, step }, name }) => (lesson && name ? { student: name, lesson: lesson.name, done: step, steps: lesson.steps.length } : null);

/** Whether the condition of the current step is met. @param {Page} page @param {number} steps how many steps the program has */
export function isDone(page, steps) {
  const until = stepNow(page)?.until;
  return until !== undefined && Object.entries(until).every(([name, value]) => SO[/** @type {keyof Until} */ (name)]?.(page, /** @type {never} */ (value), steps) ?? false);
}

/** @type {{ [K in keyof Required<Until>]: (page: Page, value: NonNullable<Until[K]>, steps: number) => boolean }} */
const SO = {
  moved_mm({ learn, station }, least) {
    const arm = station?.arm, from = learn.begun.at;
    return Boolean(arm && from && Math.hypot(arm.x_mm - from[0], arm.y_mm - from[1], arm.z_mm - from[2]) >= least);
  },
  near({ station }, { x, y, z, within }) {
    const arm = station?.arm;
    return Boolean(arm && !arm.moving && Math.hypot(arm.x_mm - x, arm.y_mm - y, arm.z_mm - z) <= within);
  },
  steps: (_, least, steps) => steps >= least,
  cycles: ({ station }, least) => (station?.job?.program?.cycles_done ?? 0) >= least,
  notice: ({ learn, notices }, type) => notices.some((entry) => entry.number > learn.begun.notice && entry.type === type),
  drawing: ({ station }) => station?.job?.kind === "drawing" && station.job.phase === "running",
  idle: ({ station }) => station !== null && (station.job === null || station.job === undefined || station.job.phase === "done"),
  refused: ({ target }) => target.check.type === "refused",
  answer({ learn }, { is, within }) {
    const said = Number(learn.answer.replace(",", "."));
    return learn.answer.trim() !== "" && Math.abs(said - is) <= within;
  },
};
