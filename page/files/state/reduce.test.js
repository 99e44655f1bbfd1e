import assert from "node:assert/strict";
import { test } from "node:test";

import { FACTS } from "../stage/sample.test.js";
import { reduce } from "./reduce.js";
import { createViewOf, blockedReason, shownPolicy, silence_ms } from "./selectors.js";
import { begin } from "./state.js";
import { placeOf } from "./target.js";

const ARM = { x_mm: 200, y_mm: 0, z_mm: 50, rotation_deg: 10, base_deg: 0, rear_deg: 45, fore_deg: 45, servo_deg: 10, suction: false, gripper_deg: 0, moving: false };
const STATION = {
  at_s: 1,
  link: { address: "virtual:", phase: "up", problem: null, cause: null, remedy: null, bluetooth: false, statuses_per_s: 12.5, lost_statuses: 0, damaged_bytes: 0, latency_ms: 1 },
  arm: ARM, dialect: "firmware-1.1", trust: { trusted: true, reason: null }, queue: { waiting: 0, under_way: 0, ahead_s: 0 },
  lease: null, stop: null, laser: { armed_for_s: 0, on: false }, job: null, clients: 1,
};
const NEW = begin({ language: "en", theme: "auto", greeted: false, program: "" });

/** The page after these messages. */
const after = (messages, page = NEW) => messages.reduce(reduce, page);
const OPEN = after([{ type: "hello", client: 7, role: "control", version: "1", now_ms: 1000 }, { type: "state", station: STATION, now_ms: 1000 }]);
const afterState = (change, page = OPEN) => after([{ type: "state", station: { ...STATION, ...change }, now_ms: 1000 }], page);

test("the arm can be moved by hand if control is free or held by this page, and nothing prevents it", () => {
  assert.equal(blockedReason(NEW), "no_connection");
  assert.equal(blockedReason(OPEN), null);
  const lease = (client) => ({ client, name: "desk", is_program: false, since_s: 0, asked_by: [] });
  assert.equal(blockedReason(afterState({ lease: lease(7) })), null);
  assert.equal(blockedReason(afterState({ lease: lease(8) })), "others_control");
  assert.equal(blockedReason(afterState({ stop: { by: "x", reason: null, at_s: 0, rests_by_s: 0, at_rest: true } })), "stopped");
  assert.equal(blockedReason(afterState({ trust: { trusted: false, reason: "reset" } })), "not_confirmed");
  assert.equal(blockedReason(afterState({ link: { ...STATION.link, phase: "lost" } })), "no_arm");
  assert.equal(blockedReason(after([{ type: "hello", client: 7, role: "watch", version: "1", now_ms: 0 }], OPEN)), "watching_only");
  assert.equal(blockedReason(after([{ type: "hello", client: 7, role: "queue", version: "1", now_ms: 0 }], OPEN)), "queueing_only");
  assert.equal(blockedReason(after([{ type: "closed", needs_token: false }], OPEN)), "no_connection");
});

test("a locked arm is moved by administrators alone, and the page knows that in advance", () => {
  const lock = { by: "Ms Lee", message: "eyes on me", at_s: 1 };
  assert.equal(blockedReason(afterState({ lock })), "locked");
  const admin = after([{ type: "hello", client: 7, role: "admin", version: "1", now_ms: 1000 }, { type: "state", station: { ...STATION, lock }, now_ms: 1000 }]);
  assert.equal(blockedReason(admin), null);
});

test("a message to all is shown until it is closed, and other events do not hide it", () => {
  const notice = (type, text) => ({ type: "notice", notice: { number: 1, at_s: 1, type, text } });
  const said = after([notice("message", "Ms Lee: five minutes"), notice("stopped", "the arm was stopped by Bo")], OPEN);
  assert.equal(said.message, "Ms Lee: five minutes");
  assert.equal(after([{ type: "message_closed" }], said).message, null);
});

test("the picture is outdated half a second after the last status, except while there is no arm", () => {
  const later = (now_ms, page = OPEN) => silence_ms(after([{ type: "tick", now_ms }], page));
  assert.equal(later(1400), 0);
  assert.equal(later(1600), 600);
  assert.equal(later(1600, afterState({ link: { ...STATION.link, phase: "searching" } })), 0);
  assert.equal(later(1600, after([{ type: "closed", needs_token: false }], OPEN)), 600);
});

test("fields that were not edited follow the arm", () => {
  const { target } = after([{ type: "target_typed", field: "x_mm", text: "250" }], OPEN);
  assert.deepEqual(placeOf(target), { x_mm: 250, y_mm: 0, z_mm: 50, rotation_deg: 10 });
});

test("a field without a number is not a place", () => {
  for (const text of ["", " ", "2x", "Infinity"]) assert.equal(placeOf(after([{ type: "target_typed", field: "x_mm", text }], OPEN).target), null, text);
});

test("an answer to an earlier question is ignored", () => {
  const asked = after([{ type: "target_typed", field: "x_mm", text: "250" }], OPEN);
  const typed = after([{ type: "target_typed", field: "x_mm", text: "260" }], asked);
  const free = { type: "free", takes_s: 1 };
  assert.equal(after([{ type: "target_checked", revision: asked.target.revision, check: free }], typed).target.check.type, "unknown");
  assert.equal(after([{ type: "target_checked", revision: typed.target.revision, check: free }], typed).target.check.type, "free");
});

test("a target is cleared when the arm sent there has arrived, not when it merely passes", () => {
  const there = after([{ type: "target_typed", field: "x_mm", text: "250" }], OPEN);
  const arrives = { arm: { ...ARM, x_mm: 249.9 } };
  assert.notEqual(afterState(arrives, there).target.typed, null);
  assert.equal(afterState(arrives, after([{ type: "target_goes" }], there)).target.typed, null);
});

test("a new connection checks the target again", () => {
  const there = after([{ type: "target_typed", field: "x_mm", text: "250" }, { type: "closed", needs_token: false }], OPEN);
  const again = after([{ type: "hello", client: 8, role: "control", version: "1", now_ms: 0 }], there);
  assert.ok(again.target.revision > there.target.revision);
});

test("a target is checked again when the policy, the link, the trust in the pose or the dialect changes", () => {
  const there = after([{ type: "target_typed", field: "x_mm", text: "250" }], OPEN);
  const isAskedAgain = (page) => page.target.revision > there.target.revision;
  assert.ok(isAskedAgain(after([{ type: "notice", notice: { at_s: 1, type: "policy_changed", client: 8 } }], there)));
  assert.ok(isAskedAgain(afterState({ link: { ...STATION.link, phase: "lost" } }, there)));
  assert.ok(isAskedAgain(afterState({ arm: null }, there)));
  assert.ok(isAskedAgain(afterState({ trust: { trusted: false, reason: "reset" } }, there)));
  assert.ok(isAskedAgain(afterState({ dialect: null }, there)));
  assert.ok(!isAskedAgain(afterState({ at_s: 2, arm: { ...ARM, x_mm: 201 } }, there)));
  assert.equal(after([{ type: "target_goes" }, { type: "notice", notice: { at_s: 1, type: "policy_changed", client: 8 } }], there).target.goes, true);
});

test("STOP closes a question, so that a later yes does nothing", () => {
  assert.equal(after([{ type: "question", question: { about: "arm_laser" } }, { type: "stop_pressed" }], OPEN).question, null);
});

test("a refusal of a press is shown until the next press", () => {
  const refused = after([{ type: "jog_held", axis: "z_minus" }, { type: "jog_held", axis: null }, { type: "jog_refused", axis: "z_minus", problem: { title: "", detail: "the table" } }], OPEN);
  assert.deepEqual(refused.jog.refused, { axis: "z_minus", problem: { title: "", detail: "the table" } });
  assert.equal(after([{ type: "jog_held", axis: "z_plus" }], refused).jog.refused, null);
});

test("a view keeps the same objects for unchanged parts", () => {
  const viewOf = createViewOf();
  const words = { dark: false, note: "", label: "" };
  const policy = { joints: {}, workspace: {}, tool_length: { suction_cup_mm: 60 }, table: { z_mm: -100 }, keep_out: { a: { box: {} } } };
  const page = after([{ type: "policy", policy }, { type: "facts", facts: FACTS }, { type: "target_typed", field: "x_mm", text: "250" }], OPEN);
  const one = viewOf(page, words), two = viewOf(after([{ type: "tick", now_ms: 1001 }], page), words);
  for (const part of ["arm", "ghost", "limits", "keepOuts", "tool", "shape", "near"]) assert.equal(one[part], two[part], part);
  assert.notEqual(viewOf(afterState({ at_s: 2 }, page), words).arm, one.arm);
});

test("the stage has no arm before the station has served its lengths, and then those of the mounted tool", () => {
  const viewOf = createViewOf();
  const words = { dark: false, note: "", label: "" };
  assert.equal(viewOf(OPEN, words).arm, null);
  const around = { tool: { kind: "laser", length_mm: 38 }, table_z_mm: -103, paper: null, things: [], marks: null };
  const view = viewOf(after([{ type: "facts", facts: FACTS }, { type: "around", around }], OPEN), words);
  assert.deepEqual([view.arm.rear_deg, view.shape.rear_arm_mm, view.shape.reach_mm, view.status_s], [45, 135, 49.57, 0.08]);
});

test("limits near the ghost are highlighted if there is one, and keep-outs near either", () => {
  const viewOf = createViewOf();
  const words = { dark: false, note: "", label: "" };
  const [rear, z] = [{ quantity: "rear", bound: 85, closeness: 0.4 }, { quantity: "z", bound: 136, closeness: 1 }];
  const page = afterState({ arm: { ...ARM, near: { limits: [rear], keep_outs: { cup: 0.5, lamp: 0.2 } } } });
  assert.deepEqual(viewOf(page, words).near, { limits: [rear], keep_outs: { cup: 0.5, lamp: 0.2 } });
  const aimed = after([{ type: "ghost_near", near: { limits: [z], keep_outs: { cup: 0.1, lamp: 0.9 } } }], page);
  assert.deepEqual(viewOf(aimed, words).near, { limits: [z], keep_outs: { cup: 0.5, lamp: 0.9 } });
  assert.deepEqual(viewOf(after([{ type: "ghost_near", near: {} }], page), words).near.limits, []);
  assert.deepEqual(viewOf(OPEN, words).near, { limits: [], keep_outs: {} });
});

test("a STOP without an answer is shown until there is one, and its answer until the arm may move again", () => {
  const stop = { by: "page", reason: null, at_s: 1, rests_by_s: 1, at_rest: true };
  const answered = { type: "stop_answered", after_s: 0.1 };
  assert.equal(after([{ type: "stop_pressed" }, answered], OPEN).late_stop, null);
  const late = after([{ type: "stop_pressed" }, { type: "stop_late" }], OPEN);
  assert.deepEqual(after([{ type: "stop_pressed" }, { type: "closed", needs_token: false }], late).late_stop, { after_s: null });
  const lateStopped = afterState({ stop }, after([{ ...answered, after_s: 13 }], late));
  assert.deepEqual(lateStopped.late_stop, { after_s: 13 });
  assert.equal(afterState({ stop: null }, lateStopped).late_stop, null);
  assert.equal(after([{ type: "stop_pressed" }], lateStopped).late_stop, null);
});

test("a drafted keep-out is shown while the next change of the draft is checked, until the draft is discarded", () => {
  const policy = { joints: {}, workspace: {}, tool_length: { suction_cup_mm: 60 }, table: { z_mm: -100 }, keep_out: {} };
  const drafted = { ...policy, keep_out: { a: { box: {} } } };
  const page = after([{ type: "policy", policy }, { type: "tab", tab: "set_up" }, { type: "policy_text", text: "kept" }, { type: "policy_typed", text: "with a" }], OPEN);
  assert.deepEqual(shownPolicy(page), policy);
  const known = after([{ type: "policy_checked", revision: page.set_up.revision, check: { type: "good" }, policy: drafted }], page);
  const changed = after([{ type: "policy_typed", text: "with a, wider" }], known);
  for (const it of [known, changed]) assert.deepEqual(shownPolicy(it), drafted);
  const bad = after([{ type: "policy_checked", revision: changed.set_up.revision, check: { type: "bad", problem: { detail: "no" } }, policy: null }], changed);
  assert.deepEqual(shownPolicy(bad), drafted);
  const inForce = after([{ type: "policy_kept", text: "with a, wider" }, { type: "policy_text", text: "with a, wider" }], changed);
  assert.deepEqual(shownPolicy(inForce), drafted);
  assert.deepEqual(shownPolicy(after([{ type: "policy_forgotten" }], bad)), policy);
  assert.deepEqual(shownPolicy(after([{ type: "tab", tab: "move" }], bad)), policy);
});

test("while a recording is shown the stage is grey, and no live data is shown beside the recorded arm", () => {
  const states = { begin_ms: 0, spacing_s: 0, samples: [{ ...ARM, at_s: 0, base_deg: 30 }, { ...ARM, at_s: 2, base_deg: 50 }] };
  const page = after([{ type: "tab", tab: "jobs" }, { type: "planned", planned: [[0, 0, 0]] }, { type: "recording_chosen", name: "a" }, { type: "recording_read", name: "a", states }, { type: "recording_at", at_s: 1 }, { type: "facts", facts: FACTS }], OPEN);
  const viewOf = createViewOf();
  const words = { dark: false, note: "", label: "" };
  const view = viewOf(page, words);
  assert.deepEqual([view.arm.base_deg, view.old, view.draggable, view.planned, view.ghost], [40, true, false, null, null]);
  const live = viewOf(after([{ type: "recording_chosen", name: null }], page), words);
  assert.deepEqual([live.arm.base_deg, live.old, live.draggable, live.planned?.length], [0, false, true, 1]);
});
