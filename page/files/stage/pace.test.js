import assert from "node:assert/strict";
import { test } from "node:test";
import { createPace } from "./pace.js";

/** Draws frames that take so long, and tells what is drawn after them. */
function after(pace, count, each_ms) {
  for (let n = 0; n <= count; n += 1) pace.drawn(n * each_ms, n < count);
  return pace.quality(2);
}

test("a computer that keeps up draws as fine as its screen is", () => {
  assert.deepEqual(after(createPace(), 500, 16.7), { density: 2, shadows: true });
  assert.deepEqual(createPace().quality(1.5), { density: 1.5, shadows: true });
});

test("a slow one draws coarser, step by step, and not coarser than that it can be seen", () => {
  const pace = createPace();
  assert.deepEqual(after(pace, 24, 60), { density: 1, shadows: true });
  assert.deepEqual(after(pace, 24, 60), { density: 1, shadows: false });
  assert.deepEqual(after(pace, 500, 60), { density: 0.7, shadows: false });
});

test("a single slow frame, or a pause between two motions, is nothing", () => {
  const pace = createPace();
  for (let n = 0; n < 100; n += 1) pace.drawn(n * 5000, false);
  for (let n = 0; n < 100; n += 1) pace.drawn(n * 16 + (n > 50 ? 900 : 0), true);
  assert.deepEqual(pace.quality(2), { density: 2, shadows: true });
});
