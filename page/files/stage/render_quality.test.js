import assert from "node:assert/strict";
import { test } from "node:test";
import { createLimit, createRenderQuality } from "./render_quality.js";

const FINEST = { density: 2, mirrors: true, shadows: true };

/** Draws frames that take so long, and tells how it is drawn after them. */
function after(pace, count, each_ms) {
  for (let n = 0; n <= count; n += 1) pace.drawn(n * each_ms, n < count);
  return pace.quality(2);
}

test("a fast computer draws at the full resolution of its screen", () => {
  assert.deepEqual(after(createRenderQuality(true), 500, 16.7), FINEST);
  assert.equal(createRenderQuality(true).quality(1.5).density, 1.5);
});

test("a slow one reduces the resolution step by step, down to a visible minimum", () => {
  const pace = createRenderQuality(true);
  assert.deepEqual(after(pace, 16, 60), { density: 1, mirrors: true, shadows: true });
  assert.deepEqual(after(pace, 16, 60), { density: 1, mirrors: false, shadows: true });
  assert.deepEqual(after(pace, 500, 60), { density: 0.75, mirrors: false, shadows: false });
});

test("one without a graphics card starts with a resolution that it can draw", () => {
  assert.deepEqual(createRenderQuality(false).quality(2), { density: 0.75, mirrors: false, shadows: true });
});

test("a single slow frame, or a pause between two motions, changes nothing", () => {
  const pace = createRenderQuality(true);
  for (let n = 0; n < 100; n += 1) pace.drawn(n * 5000, false);
  for (let n = 0; n < 100; n += 1) pace.drawn(n * 16 + (n > 50 ? 900 : 0), true);
  assert.deepEqual(pace.quality(2), FINEST);
});

for (const hz of [24, 50, 59.94, 60, 75, 120, 144, 240]) {
  test(`a screen of ${hz} Hz draws as often as it can, and at most 60 times per second`, () => {
    const isDue = createLimit();
    let drawn = 0;
    // After a pause, as an arm that begins to move.
    for (let frame = 0; frame < 10 * hz; frame += 1) drawn += Number(isDue(5000 + (frame * 1000) / hz));
    assert.ok(drawn <= 601, `${drawn} in ten seconds`);
    assert.ok(drawn >= 10 * Math.min(hz, 60) - 2, `${drawn} in ten seconds`);
  });
}
