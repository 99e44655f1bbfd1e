import assert from "node:assert/strict";
import { test } from "node:test";

import { step } from "./step.js";

const ARM = { x_mm: 200, y_mm: 0, z_mm: 50, rotation_deg: 10, base_deg: 5, rear_deg: 40, fore_deg: 30, servo_deg: 8, suction: true, gripper_deg: 20, moving: false };

test("a step of the tip is a straight line along one axis, with the tool as it is", () => {
  assert.deepEqual(step(ARM, "linear", "y_minus", 10), { type: "move_to", x_mm: 200, y_mm: -10, z_mm: 50, rotation_deg: 10, suction: true, gripper_deg: 20, mode: "movl", pause_s: 0 });
});

test("a step of a joint moves that joint only", () => {
  assert.deepEqual(step(ARM, "joint", "rear_plus", 1), { type: "move_joints", base_deg: 5, rear_deg: 41, fore_deg: 30, servo_deg: 8, suction: true, gripper_deg: 20, mode: "movj", pause_s: 0 });
});

test("a turn of the tool is a turn of the rotation, or of the servo", () => {
  assert.equal(step(ARM, "linear", "servo_plus", 10).rotation_deg, 20);
  assert.equal(step(ARM, "joint", "servo_plus", 10).servo_deg, 18);
});

test("a second click begins where the first one ends, unless it is of another frame", () => {
  const first = step(ARM, "linear", "x_plus", 10);
  assert.equal(step({ ...ARM, x_mm: 204 }, "linear", "x_plus", 10, first).x_mm, 220);
  assert.equal(step({ ...ARM, rear_deg: 42 }, "joint", "rear_plus", 1, first).rear_deg, 43);
});
