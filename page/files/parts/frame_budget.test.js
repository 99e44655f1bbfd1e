import assert from "node:assert/strict";
import { test } from "node:test";
import { createFrameBudget } from "./frame_budget.js";

test("each frame is followed by four times as long for input", () => {
  let now_ms = 100;
  /** @type {(() => void)[]} */ const painted = [];
  const budget = createFrameBudget(() => now_ms, (action) => painted.push(action));
  assert.equal(budget.wait_ms(), 0);
  /** @type {number[]} */ const took = [];
  budget.begin((ms) => took.push(ms));
  now_ms = 180;
  painted.shift()?.();
  assert.deepEqual(took, [80]);
  assert.equal(budget.wait_ms(), 320);
  now_ms = 480;
  assert.equal(budget.wait_ms(), 20);
  now_ms = 501;
  assert.equal(budget.wait_ms(), 0);
});
