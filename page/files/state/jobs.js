// The jobs of the station, and the last refusal.

/** @typedef {import("./types.js").Schemas} Schemas */
/** @typedef {import("./types.js").Problem} Problem */
/** A job as the list shows it. @typedef {Schemas["JobView"]} JobView */

/**
 * @typedef {object} Jobs
 * @property {readonly JobView[] | null} all In the order of the station; nothing where they are not known yet.
 * @property {boolean} starting Whether a new job is being created and started.
 * @property {{ job: number, problem: Problem } | null} refused Why the last request was refused.
 */

/** @type {Jobs} */
export const NO_JOBS = { all: null, starting: false, refused: null };

/** @typedef {{ type: "jobs", all: readonly JobView[] }
 * | { type: "job_starting", starting: boolean }
 * | { type: "job_refused", job: number, problem: Problem | null }} JobsMessage */

/** @param {Jobs} jobs @param {import("./message.js").Message} message @returns {Jobs} */
export function reduceJobs(jobs, message) {
  switch (message.type) {
    case "hello":
      return NO_JOBS;
    case "jobs":
      return { ...jobs, all: message.all };
    case "job_starting":
      return { ...jobs, starting: message.starting };
    case "job_refused":
      return { ...jobs, refused: message.problem && { job: message.job, problem: message.problem } };
    default:
      return jobs;
  }
}

/** @param {JobView} job */
const isOver = ({ phase }) => phase === "done" || phase === "stopped" || phase === "failed";

/**
 * Groups the jobs: active (with the current state of the running job), waiting (next first), and finished (newest first).
 * @param {readonly JobView[]} all @param {JobView | null} now
 */
export function groupJobs(all, now) {
  const jobs = all.map((job) => (job.job === now?.job ? now : job));
  return {
    active: jobs.filter(({ phase }) => phase === "running" || phase === "paused"),
    waiting: jobs.filter(({ phase }) => phase === "queued"),
    finished: jobs.filter(isOver).sort((a, b) => b.job - a.job),
  };
}

/**
 * Returns the job that a queued job precedes after it moves one place up or down: null for the end of the queue, undefined if it
 * cannot move.
 * @param {readonly JobView[]} waiting @param {number} job @param {-1 | 1} way @returns {number | null | undefined}
 */
export function placeFor(waiting, job, way) {
  const at = waiting.findIndex((entry) => entry.job === job);
  const to = at + way;
  if (at < 0 || to < 0 || to >= waiting.length) return undefined;
  return waiting[way < 0 ? to : to + 1]?.job ?? null;
}
