import assert from "node:assert/strict";
import { test } from "node:test";
import { Ink, partsOf } from "./ink.js";

const PEN = { down_z_mm: -40, give_mm: 2, kind: { type: "pen", width_mm: 0.4 } };
const LASER = { down_z_mm: -60, give_mm: 0, kind: { type: "laser", focus_mm: 5, depth_mm: 1, power_w: 0.5 } };

/** A world with these lines of ink; `from` leaves those before it out, as the station does. */
function world(time_s, lines, from = 0, more = {}) {
  const strokes = lines.slice(from).map((points_mm) => ({ points_mm }));
  return { time_s, tool: PEN, table_z_mm: -103, objects: [], held: [], strokes, burns: [], holes: [], event_count: 0, events: [], ...more };
}

test("the length of the tool is that from the wrist to the table where it touches it", () => {
  const parts = partsOf(world(1, []));
  assert.deepEqual(parts.tool, { kind: "pen", length_mm: 63 });
  assert.equal(parts.paper, null);
});

test("a growing line is continued from its end, and the marks stay the same object", () => {
  const ink = new Ink();
  assert.ok(ink.take(world(1, [[[0, 0], [10, 0]]]), 0));
  const { marks } = ink;
  assert.ok(ink.take(world(2, [[[0, 0], [10, 0], [10, 5]], [[20, 20], [30, 20]]]), 0));
  assert.deepEqual(marks.ends_mm, [0, 0, 10, 0, 10, 0, 10, 5, 20, 20, 30, 20]);
  assert.equal(ink.from, 1);
  assert.ok(ink.take(world(3, [[], [[20, 20], [30, 20], [30, 30]]], 1), 1));
  assert.deepEqual(marks.ends_mm.slice(-4), [30, 20, 30, 30]);
  assert.equal(marks.shades.length, 4);
  assert.equal(ink.marks, marks);
});

test("the end of a straight line moves, and only its new part is drawn", () => {
  const ink = new Ink();
  ink.take(world(1, [[[0, 0], [5, 5], [10, 5]]]), 0);
  ink.take(world(2, [[[0, 0], [5, 5], [40, 5]]]), 0);
  assert.deepEqual(ink.marks.ends_mm.slice(-4), [5, 5, 40, 5]);
  const count = ink.marks.shades.length;
  ink.take(world(3, [[[0, 0], [5, 5], [40, 5]]]), 0);
  assert.equal(ink.marks.shades.length, count);
});

test("a single point is a dot", () => {
  const ink = new Ink();
  ink.take(world(1, [[[5, 6]]]), 0);
  assert.deepEqual(ink.marks.ends_mm, [5, 6, 5, 6]);
});

test("a world that was set up again is another drawing, and is requested as a whole", () => {
  const ink = new Ink();
  ink.take(world(10, [[[0, 0], [1, 0]], [[2, 0], [3, 0]]]), 0);
  const { marks } = ink;
  assert.equal(ink.take(world(0.5, [], 1), 1), false);
  assert.notEqual(ink.marks, marks);
  assert.equal(ink.from, 0);
  assert.ok(ink.take(world(0.6, [[[7, 7], [8, 7]]]), 0));
  assert.deepEqual(ink.marks.ends_mm, [7, 7, 8, 7]);
});

test("a slow burn is darker than a fast one, and a hole is a dot", () => {
  const ink = new Ink();
  const burn = (speed_mm_s) => ({ points_mm: [[0, 0], [10, 0]], power_w: 0.5, speed_mm_s });
  ink.take(world(1, [], 0, { tool: LASER, burns: [burn(10), burn(100)], holes: [{ at_mm: [3, 4], power_w: 0.5, time_s: 1 }] }), 0);
  const [slow, fast, hole] = ink.marks.shades;
  assert.ok(slow > fast && fast > 0.1 && hole === 1);
  assert.deepEqual(ink.marks.ends_mm.slice(-4), [3, 4, 3, 4]);
});
