import assert from "node:assert/strict";
import { test } from "node:test";
import { createFrameBudget } from "./frame_budget.js";

test("each frame is followed by three times as long for input", () => {
  let now_ms = 100;
  /** @type {(() => void)[]} */ const painted = [];
  const budget = createFrameBudget(() => now_ms, (action) => painted.push(action));
  assert.equal(budget.wait_ms(), 0);
  budget.begin();
  now_ms = 180;
  painted.shift()?.();
  assert.equal(budget.wait_ms(), 240);
  now_ms = 400;
  assert.equal(budget.wait_ms(), 20);
  now_ms = 500;
  assert.equal(budget.wait_ms(), 0);
});
