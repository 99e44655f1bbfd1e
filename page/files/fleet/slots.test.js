import assert from "node:assert/strict";
import { test } from "node:test";
import { deal, listsOf, namesOf } from "./slots.js";

const members = ["desk-1", "desk-2"].map((name) => /** @type {import("./members.js").Member} */ (/** @type {unknown} */ ({ name, id: `id-${name}` })));

test("names are read one per line, without empty lines", () => {
  assert.deepEqual(namesOf(" Anna\n\nBen  \r\nZoë\n"), ["Anna", "Ben", "Zoë"]);
});

test("names are distributed over the arms in turn, and at each arm one follows the other", () => {
  assert.deepEqual(deal(["Anna", "Ben", "Chen"], 15, members, "room-1"), [
    { name: "desk-1", id: "id-desk-1", slots: [{ student: "Anna", group: "room-1", starts_in_s: 0, ends_in_s: 900 }, { student: "Chen", group: "room-1", starts_in_s: 900, ends_in_s: 1800 }] },
    { name: "desk-2", id: "id-desk-2", slots: [{ student: "Ben", group: "room-1", starts_in_s: 0, ends_in_s: 900 }] },
  ]);
  assert.deepEqual(deal(["Anna"], 1, members, null).map(({ name }) => name), ["desk-1"], "the other one keeps its slots");
});

test("a station that does not answer has reported no slots", () => {
  const slots = [{ student: "Anna", starts_in_s: 0, ends_in_s: 60 }];
  const answers = [{ member: "desk-1", id: "a", answer: { status: 200, body: { type: "slots", slots } }, took_ms: 1 }, { member: "desk-2", id: "b", answer: { status: 503, body: { detail: "away" } }, took_ms: 1 }];
  assert.deepEqual(listsOf(answers), { a: slots });
});
