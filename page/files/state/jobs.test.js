import assert from "node:assert/strict";
import { test } from "node:test";

import { NO_JOBS, placeFor, reduceJobs, groupJobs } from "./jobs.js";

const job = (number, phase, more = {}) => ({ job: number, phase, ...more });
const numbers = (jobs) => jobs.map((it) => it.job);

test("jobs are sorted by what they need: waiting ones in their order, finished ones with the newest first", () => {
  const all = [job(1, "done"), job(5, "queued"), job(2, "failed"), job(3, "running", { completed: 1 }), job(4, "queued")];
  const { active, waiting, finished } = groupJobs(all, job(3, "paused", { completed: 7 }));
  assert.deepEqual(active, [job(3, "paused", { completed: 7 })], "as the state tells it, which is newer");
  assert.deepEqual(numbers(waiting), [5, 4]);
  assert.deepEqual(numbers(finished), [2, 1]);
});

test("a queued job moves one place up or down, and stays in the queue", () => {
  const waiting = [job(5, "queued"), job(4, "queued"), job(8, "queued")];
  const places = (way) => numbers(waiting).map((it) => placeFor(waiting, it, way));
  assert.deepEqual(places(-1), [undefined, 5, 4]);
  assert.deepEqual(places(1), [8, null, undefined]);
  assert.equal(placeFor(waiting, 9, 1), undefined);
});

test("a refusal is shown at its job until the next request", () => {
  const problem = { title: "no", detail: "job 4 is done" };
  const refused = reduceJobs(NO_JOBS, { type: "job_refused", job: 4, problem });
  assert.deepEqual(refused.refused, { job: 4, problem });
  assert.equal(reduceJobs(refused, { type: "job_refused", job: 5, problem: null }).refused, null);
});
