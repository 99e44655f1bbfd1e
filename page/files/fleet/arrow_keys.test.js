import assert from "node:assert/strict";
import { test } from "node:test";

import { nextTile } from "./arrow_keys.js";

// Three in a row, and two in the next one, which is a section of its own.
const box = (column, row) => ({ left: column * 100, right: column * 100 + 90, top: row * 80, bottom: row * 80 + 70 });
const BOXES = [box(0, 0), box(1, 0), box(2, 0), box(0, 2), box(1, 2)];

test("arrows move the focus to the visible neighbour tile and stop at the ends", () => {
  const way = (from, key) => nextTile(BOXES, from, key);
  assert.deepEqual([way(0, "ArrowRight"), way(2, "ArrowRight"), way(0, "ArrowLeft"), way(4, "ArrowRight")], [1, 3, 0, 4]);
  assert.deepEqual([way(1, "ArrowDown"), way(2, "ArrowDown"), way(4, "ArrowUp"), way(1, "ArrowUp"), way(4, "ArrowDown")], [4, 4, 1, 1, 4]);
  assert.deepEqual([way(3, "Home"), way(0, "End")], [0, 4]);
});

test("other keys do not move the focus", () => {
  for (const key of ["Enter", " ", "Escape", "a", "Tab"]) assert.equal(nextTile(BOXES, 1, key), undefined, key);
});
