import assert from "node:assert/strict";
import { test } from "node:test";
import { areaOf, fineness } from "./marks_area.js";

const PAPER = { from_mm: [150, -105], to_mm: [298, 105] };

test("marks on the paper need no larger area than the paper", () => {
  assert.equal(areaOf(PAPER, [160, 0, 298, 105], 0), PAPER);
});

test("marks outside it enlarge the area by more than they need", () => {
  const area = areaOf(PAPER, [160, 0, 170, 0, 310, 0, 310, -110], 4);
  assert.deepEqual(area.from_mm, [150, -120]);
  assert.deepEqual(area.to_mm, [320, 105]);
});

test("without a paper the marks alone define the area, and without marks there is none", () => {
  assert.deepEqual(areaOf(null, [200, 10, 210, 20], 0), { from_mm: [160, 0], to_mm: [240, 40] });
  assert.equal(areaOf(null, [], 0), null);
});

test("a sheet of A4 is drawn with at least eight pixels per millimetre, and the whole table still fits", () => {
  assert.ok(fineness({ from_mm: [0, 0], to_mm: [210, 297] }) >= 8);
  const table = { from_mm: [-330, -330], to_mm: [330, 330] };
  assert.ok(fineness(table) * 660 <= 4096 && fineness(table) > 4);
});
