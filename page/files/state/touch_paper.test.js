import assert from "node:assert/strict";
import { test } from "node:test";

import { bent_mm, NO_TOUCH_PAPER, reduceTouchPaper } from "./touch_paper.js";

const after = (...messages) => messages.reduce(reduceTouchPaper, NO_TOUCH_PAPER);
const touch = (...place) => ({ type: "paper_touched", place });
const BEGUN = { type: "paper_begun" };
const THREE = [touch(180, -60, -30), touch(180, 60, -33), touch(250, 0, -28)];
const FOUND = { paper: { z_mm: -40, slope_x: 0, slope_y: 0 }, away_mm: [0.2, -0.3, 0.1], slope_deg: 0 };

test("a result of the station belongs to the touches that it was asked about", () => {
  const paper = after(BEGUN, ...THREE);
  const judged = { type: "paper_judged", places: paper.places, found: FOUND, problem: null };
  assert.equal(reduceTouchPaper(paper, judged).found, FOUND);
  const more = reduceTouchPaper(paper, touch(220, 20, -30));
  assert.equal(reduceTouchPaper(more, judged).found, null);
  assert.equal(bent_mm(FOUND), 0.5);
});

test("the last touch is undone, and an arm that lost its pose has touched nothing", () => {
  assert.equal(after(touch(1, 2, 3)).places, null);
  const paper = after(BEGUN, ...THREE, { type: "paper_back" });
  assert.deepEqual([paper.places.length, paper.found], [2, null]);
  assert.deepEqual(reduceTouchPaper(paper, { type: "state", station: { trust: { trusted: false } } }).places, []);
});
