import assert from "node:assert/strict";
import { test } from "node:test";

import { NO_TEACH, changeOf, currentLine, placeOfStep, reduceTeach, rowAt, rowsOf, stepsIn, titled, withPlace } from "./teach.js";

const TEXT = 'title = "two"\n\n[[steps]]\n# above\ngo = { x = 1 } # there\npath = "movl"\n\n[[steps]]\nrepeat = 2\n[[steps.steps]]\npause = 1\n\n[points]\na = { x = 2 }\n';
const REPORT = { title: "", problems: [], once_s: 3, steps: [{ label: "go", file: null, line: 3, first: 0, takes_s: 1 }, { label: "pause", file: null, line: 10, first: 1, takes_s: 1 }, { label: "pause", file: null, line: 10, first: 1, takes_s: 1 }] };

const after = (messages, teach = NO_TEACH) => messages.reduce(reduceTeach, teach);
const typed = (text) => ({ type: "teach_text", text });

test("a row is a step of the text with its nested lines, without comments", () => {
  assert.deepEqual(rowsOf(TEXT), [
    { line: 3, last: 7, says: 'go = { x = 1 }, path = "movl"' },
    { line: 8, last: 12, says: "repeat = 2, [[steps.steps]], pause = 1" },
  ]);
  assert.deepEqual(rowsOf(""), []);
});

test("a program without a title has the name of its file", () => {
  assert.equal(titled("[[steps]]", "my cubes.toml"), 'title = "my cubes"\n\n[[steps]]');
  assert.equal(titled(TEXT, "x.toml"), TEXT);
});

test("lines, times and numbers of steps belong to their rows", () => {
  const rows = rowsOf(TEXT);
  assert.deepEqual([rowAt(rows, 5), rowAt(rows, 11), rowAt(rows, 14), rowAt(rows, null)], [0, 1, null, null]);
  assert.deepEqual(stepsIn(rows, REPORT).map(({ takes_s, label }) => [takes_s, label]), [[1, "go"], [2, "repeat = 2, [[steps.steps]], pause = 1"]]);
  assert.equal(stepsIn(rows, null)[0].label, 'go = { x = 1 }, path = "movl"');
});

test("the current step is on its line only while the text is that of the job", () => {
  const job = { job: 7, program: { line: 5 } };
  const of = (text) => reduceTeach({ ...NO_TEACH, text }, { type: "teach_job", ran: { job: 7, text, chosen: null } });
  assert.equal(currentLine(of(TEXT), job), 5);
  // The job has a title of two lines.
  assert.equal(currentLine(of("[[steps]]\npause = 1\n[[steps]]\n"), job), 3);
  assert.equal(currentLine(reduceTeach(of(TEXT), typed(`${TEXT} `)), job), null);
  assert.equal(currentLine(of(TEXT), { ...job, job: 8 }), null);
  assert.equal(currentLine(of(TEXT), null), null);
});

test("a thousand changes can be undone and redone", () => {
  let teach = NO_TEACH;
  for (let n = 1; n <= 1200; n += 1) teach = reduceTeach(teach, typed(`# ${n}`));
  for (let n = 0; n < 1000; n += 1) teach = reduceTeach(teach, { type: "teach_undo" });
  assert.equal(teach.text, "# 200");
  assert.equal(reduceTeach(teach, { type: "teach_undo" }), teach);
  for (let n = 0; n < 1000; n += 1) teach = reduceTeach(teach, { type: "teach_redo" });
  assert.equal(teach.text, "# 1200");
});

test("a change after an undo discards the undone changes", () => {
  const teach = after([typed("a"), typed("b"), { type: "teach_undo" }, typed("c"), { type: "teach_redo" }]);
  assert.equal(teach.text, "c");
});

test("an answer to an earlier text is ignored", () => {
  const teach = after([typed("a"), typed("b")]);
  assert.equal(reduceTeach(teach, { type: "teach_checked", revision: teach.revision - 1, report: REPORT }).report, null);
});

test("a change is stored as a difference, so that a thousand changes of a long program fit into memory", () => {
  const long = "pause = 1\n".repeat(10_000);
  assert.deepEqual(changeOf(`a${long}z`, `a${long}yz`), { at: long.length + 1, was: "", is: "y" });
  assert.deepEqual(changeOf("aa", "aaa"), { at: 2, was: "", is: "a" });
  assert.deepEqual(changeOf("same", "same"), { at: 4, was: "", is: "" });
});

test("the place of a step is that in its text or of its named point, and never one in angles or another frame", () => {
  const text = '[points]\nhigh = { x = 1, y = -2.5, z = 3e1 }\n[[steps]]\ngo = "high"\n[[steps]]\ngo = { x = 1, y = 2, z = 3, rotation = 4 }\n[[steps]]\ngo = { base = 1, rear = 2, fore = 3 }\n[[steps]]\ngo = { x = 1, y = 2, z = 3, frame = "tray" }\n[[steps]]\npause = 1\n';
  const rows = rowsOf(text);
  const places = rows.map((row) => placeOfStep(text, row));
  assert.deepEqual(places.slice(0, 2), [{ x_mm: 1, y_mm: -2.5, z_mm: 30, rotation_deg: 0 }, { x_mm: 1, y_mm: 2, z_mm: 3, rotation_deg: 4 }]);
  assert.deepEqual(places.slice(2), [null, null, null]);
  assert.match(withPlace(text, rows[0], { x_mm: 7, y_mm: 8, z_mm: 9, rotation_deg: 5 }), /^high = \{ x = 7, y = 8, z = 9, rotation = 5 \}$/m);
});

test("dragging a place is one change when it is released, and none when the arm was stopped", () => {
  const text = "[[steps]] # first\ngo = { x = 1, y = 2, z = 3 } # here\n", place = (x_mm) => ({ x_mm, y_mm: 2, z_mm: 3, rotation_deg: 0 });
  const drag = (x_mm, phase = "drag") => ({ type: "teach_placed", place: place(x_mm), phase });
  const held = after([typed(text), { type: "teach_chosen", row: 0 }, drag(5), drag(6)]);
  assert.ok(held.text.includes("x = 6") && held.past.length === 1);
  const dropped = after([drag(7, "drop")], held);
  assert.equal(dropped.text, text.replace("x = 1", "x = 7"));
  assert.equal(after([{ type: "teach_undo" }], dropped).text, text);
  const stopped = after([{ type: "stop_pressed" }, drag(8), drag(9, "drop")], held);
  assert.deepEqual([stopped.text, stopped.past.length, stopped.dragged], [text, 1, null]);
});
