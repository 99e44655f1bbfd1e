import assert from "node:assert/strict";
import { test } from "node:test";

import { NO_TOUCH_PAPER, planeThrough, reduceTouchPaper } from "./touch_paper.js";

const after = (...messages) => messages.reduce(reduceTouchPaper, NO_TOUCH_PAPER);
const touch = (...place) => ({ type: "paper_touched", place });
const BEGUN = { type: "paper_begun" };
const THREE = [touch(180, -60, -30), touch(180, 60, -33), touch(250, 0, -28)];

test("three touches tell a plane that goes through them", () => {
  const { plane } = after(BEGUN, ...THREE);
  for (const { place: [x, y, z] } of THREE) assert.ok(Math.abs(plane.z_mm + plane.slope_x * x + plane.slope_y * y - z) < 1e-9);
});

test("touches in a line tell none", () => {
  assert.equal(planeThrough([[150, 0, -30], [200, 0, -31], [250, 1, -30]]), null);
});

test("the last touch is taken back, and an arm that forgot where it is has touched nothing", () => {
  assert.equal(after(touch(1, 2, 3)).places, null);
  const paper = after(BEGUN, ...THREE, { type: "paper_back" });
  assert.deepEqual([paper.places.length, paper.plane], [2, null]);
  assert.deepEqual(reduceTouchPaper(paper, { type: "state", station: { trust: { trusted: false } } }).places, []);
});
