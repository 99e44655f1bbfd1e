// The outcome of a request to several stations. Pure.

/** @typedef {import("./state.js").MemberAnswer} MemberAnswer */
/** @typedef {import("../state/types.js").Problem} Problem */

/**
 * @typedef {object} Outcome
 * @property {string[]} done Members that succeeded.
 * @property {string[]} silent Members without an answer: the request may still have been carried out.
 * @property {{ problem: Problem, members: string[] }[]} refused Refusals, with equal ones grouped.
 */

/** @param {readonly MemberAnswer[]} answers @returns {Outcome} */
export function outcomeOf(answers) {
  /** @type {Outcome} */ const outcome = { done: [], silent: [], refused: [] };
  for (const { member, answer } of answers) {
    const problem = problemOf(answer);
    if (!problem) outcome.done.push(member);
    else if (problem.type?.endsWith("/member-away")) outcome.silent.push(member);
    else refuse(outcome.refused, member, problem);
  }
  return outcome;
}

/** @param {Outcome["refused"]} refused @param {string} member @param {Problem} problem */
function refuse(refused, member, problem) {
  const same = refused.find((refusal) => refusal.problem.detail === problem.detail && refusal.problem.hint === problem.hint);
  if (same) same.members.push(member);
  else refused.push({ problem, members: [member] });
}

/** Returns the problem of an answer, or null. @param {MemberAnswer["answer"]} answer @returns {Problem | null} */
export function problemOf({ status, body }) {
  if (status >= 200 && status < 300) return null;
  const problem = /** @type {Partial<Problem> | null} */ (body);
  return typeof problem?.detail === "string" ? { title: "", ...problem, detail: problem.detail, status } : { title: "", detail: `the station answered with status ${status}`, status };
}

/** Names as a person lists them, each once: two stations may claim one. @param {string} language @param {readonly string[]} names */
export const list = (language, names) => new Intl.ListFormat(language, { type: "conjunction" }).format(new Set(names));
