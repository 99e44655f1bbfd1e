import assert from "node:assert/strict";
import { test } from "node:test";

import { ROW_PX, rowBelow, scrollAt } from "./row_drag.js";

test("a dragged row follows the pointer, and never leaves the list", () => {
  assert.deepEqual([-5, 0, ROW_PX - 1, ROW_PX, 99 * ROW_PX].map((y) => rowBelow(y, 4)), [0, 0, 0, 1, 3]);
});

test("the list scrolls while the pointer is at its edge, and nowhere else", () => {
  assert.deepEqual([5, 120, 235].map((y) => Math.sign(scrollAt(y, 240))), [-1, 0, 1]);
});
