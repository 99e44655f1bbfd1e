// The shared queue: submitted jobs, and the form for a new one. Pure.

import { isThere } from "./members.js";

/** @typedef {import("../state/types.js").Schemas} Schemas */
/** @typedef {import("../state/types.js").Problem} Problem */
/** @typedef {import("./members.js").Member} Member */
/** @typedef {Schemas["WorkView"]} WorkView */
/** The form. `down` is the pen-down height in mm; empty for the height known by the arm's station. @typedef {{ what: "file" | "text", file: File | null, text: string, student: string, group: string, needs: readonly string[], down: string, fit: boolean }} Form */

/**
 * @typedef {object} Queue
 * @property {boolean} open
 * @property {readonly WorkView[] | null} all In the order in which it came; nothing where it is not known yet.
 * @property {import("../state/draw.js").Formats} formats The supported formats.
 * @property {Form} form
 * @property {boolean} submitting
 * @property {string | null} submitted Title of the last submission.
 * @property {{ work: string | null, problem: Problem } | null} refused Why the last request was refused; `work` is null for a submission.
 */

/** @type {Queue} */
export const NO_QUEUE = {
  open: false,
  all: null,
  formats: [],
  form: { what: "file", file: null, text: "", student: "", group: "", needs: [], down: "", fit: false },
  submitting: false,
  submitted: null,
  refused: null,
};

/** @typedef {{ type: "queue_open", open: boolean }
 * | { type: "queue", all: readonly WorkView[] }
 * | { type: "queue_formats", formats: Queue["formats"] }
 * | { type: "queue_form", form: Partial<Form> }
 * | { type: "queue_asked", work: string | null }
 * | { type: "queue_submitted", form: Form, title: string }
 * | { type: "queue_refused", work: string | null, problem: Problem }} QueueMessage */

/** @param {Queue} queue @param {QueueMessage} message @returns {Queue} */
export function reduceQueue(queue, message) {
  switch (message.type) {
    case "queue_open":
      return { ...queue, open: message.open };
    case "queue":
      return { ...queue, all: message.all };
    case "queue_formats":
      return { ...queue, formats: message.formats };
    case "queue_form":
      return { ...queue, form: { ...queue.form, ...message.form }, submitted: null };
    case "queue_asked":
      return { ...queue, submitting: queue.submitting || message.work === null, refused: null };
    case "queue_submitted":
      // Keeps text typed in the meantime.
      return { ...queue, submitting: false, submitted: message.title, form: queue.form === message.form ? { ...queue.form, file: null, text: "" } : queue.form };
    case "queue_refused":
      return { ...queue, submitting: queue.submitting && message.work !== null, refused: { work: message.work, problem: message.problem } };
  }
}

/** @param {WorkView} work */
const isDoubtful = ({ doubt }) => doubt != null;

/** Whether it can be cancelled. @param {WorkView} work */
export const canCancel = ({ phase }) => phase === "waiting" || phase === "offered" || phase === "taken";

/** Whether it can be reassigned. @param {WorkView} work */
export const canReassign = (work) => isDoubtful(work) || work.phase === "failed";

/** Groups the jobs by state. @param {readonly WorkView[]} all */
export const groupWork = (all) => ({
  doubt: all.filter(isDoubtful),
  assigned: all.filter((work) => !isDoubtful(work) && (work.phase === "offered" || work.phase === "taken")),
  waiting: all.filter(({ phase }) => phase === "waiting"),
  finished: all.filter((work) => !canCancel(work)).reverse(),
});

/** The number of open jobs, and of those in an uncertain state. @param {readonly WorkView[] | null} all */
export const counts = (all) => ({ open: all?.filter(canCancel).length ?? 0, doubt: all?.filter(isDoubtful).length ?? 0 });

/** @param {Member} member */
const takes = (member) => isThere(member) && member.about?.takes_work != null;

/** The arms that have all of it, and whose stations take work. @param {readonly Member[]} members @param {readonly string[]} needs */
export const arms = (members, needs) => members.filter((member) => takes(member) && needs.every((need) => member.about?.offers.includes(need)));

/** Equipment that can be required: offered by members that accept work, or already selected. @param {readonly Member[]} members @param {readonly string[]} chosen */
export const offers = (members, chosen) => [...new Set([...members.filter(takes).flatMap(({ about }) => about?.offers ?? []), ...chosen])].sort();

/** The jobs assigned or offered to an arm, and the waiting jobs that it could take. @param {readonly WorkView[] | null} all @param {Member} member */
export function ofMember(all, member) {
  const { assigned, doubt, waiting } = groupWork(all ?? []);
  const wasThere = (/** @type {WorkView} */ { before }) => before?.some((attempt) => attempt.member.id === member.id);
  return {
    has: [...doubt, ...assigned].filter((work) => work.member?.id === member.id),
    suitable: waiting.filter((work) => arms([member], work.needs).length && !wasThere(work)),
  };
}

/** @param {Form} form */
const height = ({ down }) => (down.trim() === "" ? undefined : Number(down.replace(",", ".")));

/** Whether the height is not a number. @param {Form} form */
export const isWrongHeight = (form) => Number.isNaN(height(form) ?? 0);

/** Whether the form is complete. @param {Form} form */
export const canSubmit = (form) => (form.what === "file" ? form.file !== null : form.text.trim() !== "") && form.student.trim() !== "" && !isWrongHeight(form);

/** The drawing options; omitted ones are chosen by the arm's station. @param {Form} form */
export function optionsOf(form) {
  const pen_down = height(form);
  return { ...(form.what === "text" && { what: { text: form.text } }), place: { fit: form.fit, ...(pen_down !== undefined && { pen_down }) } };
}
