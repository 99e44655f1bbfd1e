import assert from "node:assert/strict";
import { test } from "node:test";
import { isSamePerson, timeNext, timeNow } from "./slots.js";

test("names belong to one person regardless of capital letters and spaces", () => {
  assert.ok(isSamePerson(" anna", "Anna"));
  assert.ok(!isSamePerson("Anna B", "Anna"));
});

test("the current student, the remaining time and the end of the slots follow the clock of the station", () => {
  const now = { student: "Anna", starts_s: 0, ends_s: 130 }, next = { student: "Ben", starts_s: 130, ends_s: 400 };
  const station = { at_s: 100, slots: { now, next, free_s: 400 } };
  assert.deepEqual(timeNow(station), { student: "Anna", left_s: 30, free_in_s: 300 });
  assert.deepEqual(timeNext(station), { student: "Ben", in_s: 30 });
  assert.equal(timeNow({ at_s: 100, slots: { next } }), null);
  assert.equal(timeNow({ at_s: 100 }), null);
});
