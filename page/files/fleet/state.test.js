import assert from "node:assert/strict";
import { test } from "node:test";

import { begin, reduce } from "./state.js";
import { member } from "./sample.test.js";

const after = (...messages) => messages.reduce(reduce, begin({ language: "en", theme: "auto" }));
const fleet = (...names) => ({ type: "fleet", name: names[0], members: names.map((it) => member(it)), now_ms: 1 });
const requested = (number, what) => ({ type: "requested", request: { number, what, to: "all", answers: null, problem: null } });
const answered = (number, ...answers) => ({ type: "answered", number, answers, problem: null });
const answer = (name, status, body = {}) => ({ member: name, id: name, took_ms: 1, answer: { status, body } });

test("a station that changes keeps its place, and a new one is inserted by name", () => {
  const changed = member("desk-2", { presence: { type: "away" } });
  const before = after(fleet("desk-1", "desk-2", "desk-3"));
  const now = reduce(before, { type: "members", members: [changed], gone: [], now_ms: 2 });
  assert.deepEqual(now.members, [before.members[0], changed, before.members[2]]);
  const grown = reduce(now, { type: "members", members: [member("desk-10"), member("desk-0")], gone: [], now_ms: 3 });
  assert.deepEqual(grown.members.map(({ name }) => name), ["desk-0", "desk-1", "desk-2", "desk-3", "desk-10"]);
});

test("stations that did not answer a stop stay listed during other requests", () => {
  const board = after(requested(1, "stop"), answered(1, answer("desk-1", 200)), requested(2, "message"), answered(2));
  assert.equal(board.stop.answers.length, 1);
  assert.equal(board.request.what, "message");
});

test("a second press sends a new request, and answers to the first do not count for it", () => {
  const board = after(requested(1, "stop"), requested(2, "stop"), answered(1, answer("desk-1", 200)));
  assert.equal(board.stop.answers, null);
});

test("one station that requires a token is enough to ask for it, in its own words", () => {
  const denied = { detail: "this takes the role control", hint: "use another token", status: 403 };
  assert.deepEqual(after(requested(1, "reset"), answered(1, answer("desk-1", 200), answer("desk-2", 403, denied))).denied, denied);
  assert.equal(after(requested(1, "reset"), answered(1, answer("desk-1", 409, denied))).denied, null);
});

test("the jobs of a station are not shown for another one", () => {
  const board = after(fleet("a", "b"), { type: "chosen", id: "id-a" }, { type: "jobs", id: "id-b", jobs: [{ job: 1 }] });
  assert.equal(board.jobs, null);
});

test("the students of a station stay listed while its arm moves, and disappear when it no longer answers", () => {
  const learner = { student: "Anna", lesson: "tour", done: 2, steps: 12, for_s: 5 };
  const learning = after(fleet("desk-1", "desk-2"), { type: "learners", answers: [answer("id-desk-1", 200, [learner]), answer("id-desk-2", 503, { detail: "away" })] });
  assert.deepEqual(learning.members.map(({ learners }) => learners), [[learner], []]);
  const moved = reduce(learning, { type: "members", members: [member("desk-1")], gone: [], now_ms: 2 });
  assert.deepEqual(moved.members[0].learners, [learner]);
  assert.deepEqual(reduce(moved, { type: "learners", answers: [] }).members[0].learners, []);
});

test("a board that reconnects to its station shows that until it succeeds", () => {
  const lost = after(fleet("a"), { type: "closed", problem: null }, { type: "connecting" });
  assert.equal(lost.connection, "closed");
  assert.equal(reduce(lost, fleet("a")).connection, "open");
});
