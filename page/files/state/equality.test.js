import assert from "node:assert/strict";
import { test } from "node:test";

import { reduce } from "./reduce.js";
import { onlyMoved, rendersSame } from "./equality.js";
import { begin } from "./state.js";

const STATION = {
  at_s: 1,
  link: { address: "virtual:", phase: "up", problem: null, cause: null, remedy: null, bluetooth: false, statuses_per_s: 12.5, lost_statuses: 0, damaged_bytes: 0, latency_ms: 1 },
  arm: { x_mm: 200, y_mm: 0, z_mm: 50, rotation_deg: 10, base_deg: 0, rear_deg: 45, fore_deg: 45, servo_deg: 10, suction: false, gripper_deg: 0, moving: false },
  dialect: "firmware-1.1", trust: { trusted: true, reason: null }, queue: { waiting: 0, under_way: 0, ahead_s: 0 },
  lease: null, stop: null, laser: { armed_for_s: 0, on: false }, job: null, clients: 1, slots: null,
};
const after = (messages, page) => messages.reduce(reduce, page);
const BEGUN = begin({ language: "en", theme: "auto", greeted: false, program: "" });
const OPEN = after([{ type: "hello", client: 7, role: "control", version: "1", now_ms: 1000 }, { type: "state", station: STATION, now_ms: 1000 }], BEGUN);
const afterState = (change, page = OPEN) => reduce(page, { type: "state", station: { ...STATION, at_s: 1.08, ...structuredClone(change) }, now_ms: 1080 });

test("an arm at rest looks the same in every report", () => {
  assert.ok(rendersSame(OPEN, afterState({})));
  assert.ok(rendersSame(OPEN, afterState({ at_s: 3, link: { ...STATION.link, statuses_per_s: 12.52, latency_ms: 7 } })));
});

test("any change read from a station is new", () => {
  const changes = {
    arm: { ...STATION.arm, x_mm: 200.1 }, link: { ...STATION.link, phase: "lost" }, trust: { trusted: false, reason: "reset" }, clients: 2,
    lease: { client: 7, name: "desk", is_program: false, since_s: 0, asked_by: [] }, laser: { armed_for_s: 2, on: false }, job: { job: 3, completed: 1 },
  };
  for (const [name, value] of Object.entries(changes)) assert.ok(!rendersSame(OPEN, afterState({ [name]: value })), name);
  assert.ok(!rendersSame(BEGUN, OPEN));
});

test("any other change of the page is new, and so is a report after a silence", () => {
  assert.ok(!rendersSame(OPEN, reduce(OPEN, { type: "tab", tab: "watch" })));
  const silent = reduce(OPEN, { type: "tick", now_ms: 3000 });
  assert.ok(!rendersSame(OPEN, silent));
  assert.ok(!rendersSame(silent, afterState({}, silent)));
});

test("an arm that moves changes nothing but its pose, and a stop is more than that", () => {
  const arm = { ...STATION.arm, y_mm: 3, moving: true };
  assert.ok(onlyMoved(OPEN, afterState({ arm, link: { ...STATION.link, statuses_per_s: 11.9, latency_ms: 8 } })));
  assert.ok(!onlyMoved(OPEN, afterState({ arm, stop: { by: "desk" } })));
  assert.ok(!onlyMoved(OPEN, afterState({ arm, laser: { armed_for_s: 9, on: false } })));
  assert.ok(!onlyMoved(OPEN, reduce(OPEN, { type: "jog_held", axis: "y_plus" })));
});

test("Watch shows the link and each sample of the charts", () => {
  const watched = reduce(OPEN, { type: "tab", tab: "watch" });
  assert.ok(rendersSame(watched, afterState({}, watched)));
  assert.ok(!rendersSame(watched, afterState({ link: { ...STATION.link, latency_ms: 7 } }, watched)));
  assert.ok(!rendersSame(watched, afterState({ at_s: 1.6 }, watched)));
});

test("the remaining time of a slot is counted down", () => {
  const slots = { now: { student: "Anna", starts_s: 0, ends_s: 250 }, next: null, free_s: 250 };
  const timed = afterState({ slots });
  assert.ok(rendersSame(timed, afterState({ slots, at_s: 1.1 }, timed)));
  assert.ok(!rendersSame(timed, afterState({ slots, at_s: 1.6 }, timed)));
});
