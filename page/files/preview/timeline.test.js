import assert from "node:assert/strict";
import { test } from "node:test";
import { MOST_BYTES, Refused, checkSize, lastAt, placeAt, readTimeline } from "./timeline.js";
import { sample } from "./sample.test.js";

/** What is said of the sample when something in it is otherwise. */
function refusal(change) {
  const file = sample();
  change(file);
  try {
    readTimeline(JSON.stringify(file));
  } catch (error) {
    assert.ok(error instanceof Refused, error);
    return error.message;
  }
  assert.fail("it is read");
}

test("a timeline is read into columns", () => {
  const { duration_s, passes, moves, path } = readTimeline(JSON.stringify(sample()));
  assert.equal(duration_s, 4);
  assert.deepEqual(passes, sample().passes);
  assert.deepEqual(moves.kinds, ["travel", "draw"]);
  assert.deepEqual([...path.x_mm], sample().path.x_mm);
  assert.deepEqual([...path.ink], [0, 0, 1, 0]);
});

test("a line belongs to the pass of its start", () => {
  const file = sample();
  file.passes.push({ name: "sea", tool: "pen", color: null });
  file.moves.pass = [0, 0, 1];
  // The line ends at 3 s, the moment in which the second pass begins.
  assert.deepEqual([...readTimeline(JSON.stringify(file)).path.pass], [0, 0, 0, 1]);
});

test("an error in a file is reported with its place, the found and the expected value", () => {
  const cases = [
    [(it) => delete it.version, "has no version; expected a timeline of version 1"],
    [(it) => (it.version = 2), "has version 2; expected a timeline of version 1"],
    [(it) => (it.duration_s = -1), "has -1 as duration_s; expected a number from 0 to"],
    [(it) => (it.passes = []), "has nothing in passes; expected a list of at least one"],
    [(it) => (it.passes[0].tool = "brush"), 'has "brush" at passes[0].tool; expected "pen" or "laser"'],
    [(it) => (it.passes[0].color = [0, 0, 256]), "has a list of 3 at passes[0].color; expected red, green and blue"],
    [(it) => (it.moves.pass[1] = 1), "has 1 at moves.pass[1]; expected a number from 0 to 0"],
    [(it) => (it.moves.from_s[1] = 3.5), "has 3 at moves.from_s[2], after 3.5; expected a time that does not decrease"],
    [(it) => it.path.z_mm.pop(), "has 3 rows in path.z_mm; expected 4"],
    [(it) => (it.path.x_mm[2] = 1001), "has 1001 at path.x_mm[2]; expected a number from -1000 to 1000"],
    [(it) => (it.path.ink[0] = 0.5), "has 0.5 at path.ink[0]; expected a whole number"],
    [(it) => (it.path.y_mm[0] = null), "has null at path.y_mm[0]; expected a number"],
    [(it) => delete it.path.error_mm, "has no path.error_mm; expected a list"],
  ];
  for (const [change, text] of cases) {
    const found = refusal(change);
    assert.ok(found.startsWith(text), `${found}\nexpected: ${text}`);
  }
});

test("other files are refused and identified", () => {
  assert.throws(() => readTimeline("<svg/>"), /^Error: is not JSON/);
  assert.throws(() => readTimeline("[1, 2]"), /^Error: holds a list of 2; expected a timeline/);
  assert.throws(() => checkSize(0), /is empty/);
  assert.throws(() => checkSize(MOST_BYTES + 1), /has 50\.0 MB; expected a timeline of at most 50 MB/);
  checkSize(MOST_BYTES);
});

test("the last row at or before the time is found, even if several have the same time", () => {
  const column = Float64Array.of(0, 1, 1, 3);
  for (const [t_s, row] of [[-1, 0], [0, 0], [0.9, 0], [1, 2], [2.9, 2], [3, 3], [9, 3]]) {
    assert.equal(lastAt(column, t_s), row, `at ${t_s} s`);
  }
});

test("between two rows the tool is on the straight line between them", () => {
  const timeline = readTimeline(JSON.stringify(sample()));
  assert.deepEqual(placeAt(timeline, 0.5), { row: 0, x_mm: 205, y_mm: 20, z_mm: 5, inks: false, kind: "travel", pass: 0 });
  assert.deepEqual(placeAt(timeline, 2), { row: 1, x_mm: 210, y_mm: 0, z_mm: 0, inks: true, kind: "draw", pass: 0 });
  assert.deepEqual(placeAt(timeline, 4), { row: 3, x_mm: 200, y_mm: 20, z_mm: 10, inks: false, kind: "travel", pass: 0 });
});
