import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { parse } from "../vendor/smol-toml/index.js";
import { begunNow, isDone, LESSONS, progressOf, stepNow } from "./learn.js";
import { reduce } from "./reduce.js";
import { TEXTS } from "../i18n/i18n.js";
import { begin } from "./state.js";

const NEW = begin({ language: "en", theme: "auto", greeted: true, program: "" });
const lessonOf = (name) => parse(readFileSync(new URL(`../lessons/${name}.toml`, import.meta.url), "utf8"));

/** A page in a lesson of one step. */
function waiting(until, more = {}) {
  const page = { ...NEW, ...more };
  return reduce(page, { type: "lesson", lesson: { title: {}, minutes: 1, steps: [{ text: {}, until }] }, begun: begunNow(page) });
}
const at = (x_mm, y_mm, z_mm, moving = false) => ({ station: { arm: { x_mm, y_mm, z_mm, moving }, job: null } });

test("each step of a lesson has a text, and waits only for known conditions", () => {
  const known = new Set(["moved_mm", "near", "steps", "cycles", "notice", "drawing", "idle", "refused", "answer"]);
  for (const name of LESSONS) {
    const { minutes, steps } = lessonOf(name);
    assert.ok(minutes > 0 && steps.length > 4, name);
    assert.deepEqual(Object.keys(TEXTS.en).filter((key) => key.startsWith(`lesson.${name}.`)), steps.map((_, n) => `lesson.${name}.${n + 1}`));
    for (const { until, show } of steps) {
      assert.ok(Object.keys(until ?? {}).every((it) => known.has(it)), JSON.stringify(until));
      assert.ok(show === undefined || show.startsWith("#"));
    }
  }
});

test("the progress of a student is reported under the given name, and not without one", () => {
  const begun = begunNow(NEW);
  const lesson = { name: "tour", title: {}, minutes: 1, steps: [{ text: {} }, { text: {} }] };
  const page = [{ type: "name", name: "Anna" }, { type: "lesson", lesson, begun }, { type: "lesson_step", step: 1, begun }].reduce(reduce, NEW);
  assert.deepEqual(progressOf(page), { student: "Anna", lesson: "tour", done: 1, steps: 2 });
  assert.equal(progressOf(reduce(page, { type: "name", name: "" })), null);
  const reportProblem = reduce(page, { type: "lesson_reported", problem: { title: "", detail: "this takes the role queue" } });
  assert.equal(reportProblem.learn.reportProblem.detail, "this takes the role queue");
  assert.equal(reduce(reportProblem, { type: "name", name: "Ben" }).learn.reportProblem, null);
  const left = reduce(page, { type: "lesson", lesson: null, begun });
  assert.equal(progressOf(left), null);
  assert.equal(left.name, "Anna", "the next lesson is hers, too");
});

test("a step that waits for a motion is done when the arm has moved that far since the step began", () => {
  const page = waiting({ moved_mm: 15 }, at(200, 0, 50));
  assert.equal(isDone(page, 0), false);
  assert.equal(isDone({ ...page, ...at(200, 10, 50) }, 0), false);
  assert.equal(isDone({ ...page, ...at(200, 10, 38) }, 0), true);
});

test("a place counts when the arm is at rest there", () => {
  const page = waiting({ near: { x: 200, y: 100, z: 0, within: 3 } });
  assert.equal(isDone({ ...page, ...at(201, 99, 1, true) }, 0), false);
  assert.equal(isDone({ ...page, ...at(201, 99, 1) }, 0), true);
});

test("events from before a step do not count for it", () => {
  const page = waiting({ notice: "stopped" }, { notices: [{ number: 7, type: "stopped" }] });
  assert.equal(isDone(page, 0), false);
  assert.equal(isDone(reduce(page, { type: "notice", notice: { number: 8, type: "stopped" } }), 0), true);
});

test("an answer may contain a decimal comma, and must be near enough", () => {
  const page = waiting({ answer: { is: 26.57, within: 0.2 } });
  const said = (text) => isDone(reduce(page, { type: "lesson_answer", text }), 0);
  assert.deepEqual(["", "26", "26,6", "26.5", "x"].map(said), [false, false, true, true, false]);
});

test("a step without a condition waits for its button", () => {
  const page = waiting(undefined);
  assert.equal(isDone(page, 9), false);
  const next = reduce(page, { type: "lesson_step", step: 1, begun: begunNow(page) });
  assert.equal(stepNow(next), null);
});

test("the numbers of the lesson on kinematics are those of the arm", () => {
  const [L1, L2, TOOL] = [135, 160, 59.7], degrees = 180 / Math.PI;
  const wrist = Math.hypot(200, 100) - TOOL;
  const corner = Math.acos((L1 ** 2 + wrist ** 2 - L2 ** 2) / (2 * L1 * wrist)) * degrees;
  const elbow = L1 * Math.cos((90 - corner) / degrees);
  const right = [Math.atan2(100, 200) * degrees, wrist, corner, 90 - corner, Math.asin(elbow / L2) * degrees];
  const answers = lessonOf("kinematics").steps.flatMap(({ until }) => until?.answer ?? []);
  answers.forEach(({ is, within }, n) => assert.ok(Math.abs(is - right[n]) < within / 2, `${is} instead of ${right[n]}`));
});
