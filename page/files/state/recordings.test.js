import assert from "node:assert/strict";
import { test } from "node:test";

import { NO_RECORDINGS, extent, isCoarse, recorded, reduceRecordings, sampleAt } from "./recordings.js";

const sample = (at_s, x_mm) => ({ at_s, x_mm, y_mm: 0, z_mm: 50, rotation_deg: 0, base_deg: 0, rear_deg: 45, fore_deg: 45, servo_deg: 0, suction: x_mm > 205, gripper_deg: 0 });
const SAMPLES = [sample(1, 200), sample(3, 200), sample(4, 210)];
const after = (messages, from = NO_RECORDINGS) => messages.reduce(reduceRecordings, from);
const PLAYER = after([{ type: "recording_chosen", name: "a.mcap" }, { type: "recording_read", name: "a.mcap", states: { begin_ms: 0, spacing_s: 0, samples: SAMPLES } }]);

test("between two samples the arm is between them, and before and after all samples at the nearest", () => {
  const xs = [0, 1, 2, 3.5, 4, 9].map((at_s) => sampleAt(SAMPLES, at_s)?.x_mm);
  assert.deepEqual(xs, [200, 200, 200, 205, 210, 210]);
  assert.equal(sampleAt(SAMPLES, 3.5)?.suction, false, "a pump is on only from when it was told");
  assert.equal(sampleAt([], 1), null);
});

test("a recording plays from its first moment to its last one, and then starts again", () => {
  assert.deepEqual(extent(PLAYER), { from_s: 1, to_s: 4 });
  const plays = after([{ type: "recording_plays", now_ms: 5000 }, { type: "recording_speed", speed: 4 }, { type: "recording_passed", now_ms: 5500 }], PLAYER);
  assert.equal(plays.at_s, 3);
  const ended = after([{ type: "recording_passed", now_ms: 9000 }], plays);
  assert.deepEqual([ended.at_s, ended.played_ms], [4, null]);
  assert.equal(after([{ type: "recording_plays", now_ms: 9100 }], ended).at_s, 1);
  assert.equal(after([{ type: "recording_at", at_s: 2 }], plays).played_ms, null, "whoever scrubs does not play");
});

test("the live arm is shown again on request, on another tab, or when the person moves it", () => {
  assert.equal(recorded(PLAYER)?.x_mm, 200);
  for (const message of [{ type: "recording_chosen", name: null }, { type: "tab", tab: "move" }, { type: "jog_held", axis: "x_plus" }]) assert.equal(recorded(after([message], PLAYER)), null, message.type);
});

test("the details of the shown moment of a long recording appear as soon as they are read", () => {
  const coarse = after([{ type: "recording_read", name: "a.mcap", states: { begin_ms: 0, spacing_s: 2, samples: SAMPLES } }, { type: "recording_at", at_s: 3.5 }], PLAYER);
  assert.deepEqual([isCoarse(PLAYER), isCoarse(coarse), recorded(coarse)?.x_mm], [false, true, 205]);
  const fine = after([{ type: "recording_near", name: "a.mcap", near: { from_s: 3, to_s: 4, samples: [sample(3, 200), sample(3.5, 201), sample(4, 210)] } }], coarse);
  assert.deepEqual([isCoarse(fine), recorded(fine)?.x_mm], [false, 201]);
  assert.equal(isCoarse(after([{ type: "recording_at", at_s: 2 }], fine)), true);
});

test("data of a recording that is no longer selected is not shown", () => {
  const other = after([{ type: "recording_chosen", name: "b.mcap" }, { type: "recording_read", name: "a.mcap", states: { begin_ms: 0, spacing_s: 0, samples: SAMPLES } }], PLAYER);
  assert.equal(recorded(other), null);
});
