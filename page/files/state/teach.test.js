import assert from "node:assert/strict";
import { test } from "node:test";

import { NO_TEACH, reduceTeach, rowAt, rowsOf, stepOf, stepsIn, titled } from "./teach.js";

const TEXT = 'title = "two"\n\n[[steps]]\n# above\ngo = { x = 1 } # there\npath = "movl"\n\n[[steps]]\nrepeat = 2\n[[steps.steps]]\npause = 1\n\n[points]\na = { x = 2 }\n';
const REPORT = { title: "", problems: [], once_s: 3, steps: [{ label: "go", file: null, line: 3, first: 0, takes_s: 1 }, { label: "pause", file: null, line: 10, first: 1, takes_s: 1 }, { label: "pause", file: null, line: 10, first: 1, takes_s: 1 }] };

const after = (messages, teach = NO_TEACH) => messages.reduce(reduceTeach, teach);
const typed = (text) => ({ type: "teach_text", text });

test("a row is a step of the text, with what stands below it, without comments", () => {
  assert.deepEqual(rowsOf(TEXT), [
    { line: 3, last: 7, says: 'go = { x = 1 }, path = "movl"' },
    { line: 8, last: 12, says: "repeat = 2, [[steps.steps]], pause = 1" },
  ]);
  assert.deepEqual(rowsOf(""), []);
});

test("a program without a title is called as its file", () => {
  assert.equal(titled("[[steps]]", "my cubes.toml"), 'title = "my cubes"\n\n[[steps]]');
  assert.equal(titled(TEXT, "x.toml"), TEXT);
});

test("lines, times and numbers of steps belong to their rows", () => {
  const rows = rowsOf(TEXT);
  assert.deepEqual([rowAt(rows, 5), rowAt(rows, 11), rowAt(rows, 14), rowAt(rows, null)], [0, 1, null, null]);
  assert.deepEqual(stepsIn(rows, REPORT).map(({ takes_s, label }) => [takes_s, label]), [[1, "go"], [2, "repeat = 2, [[steps.steps]], pause = 1"]]);
  assert.equal(stepsIn(rows, null)[0].label, 'go = { x = 1 }, path = "movl"');
  assert.deepEqual([stepOf(rows[0], REPORT), stepOf(rows[1], REPORT), stepOf(undefined, REPORT)], [1, 2, null]);
});

test("a thousand changes can be undone and done again", () => {
  let teach = NO_TEACH;
  for (let n = 1; n <= 1200; n += 1) teach = reduceTeach(teach, typed(`# ${n}`));
  for (let n = 0; n < 1000; n += 1) teach = reduceTeach(teach, { type: "teach_undo" });
  assert.equal(teach.text, "# 200");
  assert.equal(reduceTeach(teach, { type: "teach_undo" }), teach);
  for (let n = 0; n < 1000; n += 1) teach = reduceTeach(teach, { type: "teach_redo" });
  assert.equal(teach.text, "# 1200");
});

test("a change after an undo forgets what was undone", () => {
  const teach = after([typed("a"), typed("b"), { type: "teach_undo" }, typed("c"), { type: "teach_redo" }]);
  assert.equal(teach.text, "c");
});

test("an answer to an earlier text is not taken", () => {
  const teach = after([typed("a"), typed("b")]);
  assert.equal(reduceTeach(teach, { type: "teach_checked", asked: teach.asked - 1, report: REPORT }).report, null);
});
