import assert from "node:assert/strict";
import { test } from "node:test";

import { NO_PACKETS, exported, line, reducePackets, wanted } from "./packets.js";

const STATUS = { direction: "from_arm", at_s: 1, bytes: "a500", status: { x_mm: 200.123, suction: false } };
const MOVE = { direction: "to_arm", at_s: 2, bytes: "a540", command: { type: "move_to", x_mm: 210, mode: "jump" }, problem: null };
const UNKNOWN = { direction: "to_arm", at_s: 3, bytes: "a5ff", command: null, problem: "float 1 (state) is 11" };
const after = (messages, from = NO_PACKETS) => messages.reduce(reducePackets, from);
const SOME = after([{ type: "packets", packets: [STATUS, MOVE, UNKNOWN] }]);
const numbers = (packets) => wanted(packets).map((it) => it.number);

test("a packet is shown in one line, and one without a meaning with the reason", () => {
  assert.deepEqual([STATUS, MOVE, UNKNOWN].map(line), ["x_mm 200.12 suction false", "move_to x_mm 210 mode jump", "float 1 (state) is 11"]);
});

test("packets are filtered by direction, by meaning and by their bytes", () => {
  assert.deepEqual(numbers(SOME), [1, 2, 3]);
  assert.deepEqual(numbers(after([{ type: "packets_way", way: "to_arm" }], SOME)), [2, 3]);
  assert.deepEqual(numbers(after([{ type: "packets_filter", text: " MOVE_TO" }], SOME)), [2]);
  assert.deepEqual(numbers(after([{ type: "packets_filter", text: "a5ff" }], SOME)), [3]);
});

test("a paused list does not change, and shows all packets when it continues", () => {
  const paused = after([{ type: "packets_frozen", frozen: true }, { type: "packets", packets: [MOVE] }], SOME);
  assert.deepEqual(numbers(paused), [1, 2, 3]);
  assert.deepEqual(numbers(after([{ type: "packets_frozen", frozen: false }], paused)), [1, 2, 3, 4]);
});

test("only the newest are kept, and their numbers continue", () => {
  const many = after([{ type: "packets", packets: Array.from({ length: 2500 }, () => STATUS) }], SOME);
  assert.deepEqual([many.passed.length, many.passed[0].number, many.passed.at(-1).number], [2000, 504, 2503]);
});

test("the export has one line of JSON for each packet", () => {
  const lines = exported(wanted(SOME)).trimEnd().split("\n");
  assert.deepEqual(JSON.parse(lines[1]), { ...MOVE, number: 2 });
  assert.equal(lines.length, 3);
});
