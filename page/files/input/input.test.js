import assert from "node:assert/strict";
import { test } from "node:test";

import { pushed } from "./gamepad.js";
import { axisOf, isStop } from "./keys.js";
import { gesturePacket, mousePacket } from "./pad_packets.js";

const ARM = { rotation_deg: 12, servo_deg: 8, suction: true };
const focused = (...selectors) => ({ matches: (list) => selectors.some((it) => list.includes(it)) });

test("Escape always stops, and Space stops except where it types or presses", () => {
  assert.equal(isStop("Escape", focused("textarea"), false), true);
  assert.equal(isStop(" ", focused("textarea"), false), false);
  assert.equal(isStop(" ", null, false), true);
  assert.equal(isStop(" ", focused("button"), true), false);
  assert.equal(isStop(" ", focused("button"), false), true);
  assert.equal(isStop("a", null, false), false);
});

test("keys on the stage act as the buttons of the moving part; with Shift or Ctrl they move the camera", () => {
  const key = (key, more = {}) => ({ key, ctrlKey: false, altKey: false, metaKey: false, shiftKey: false, ...more });
  assert.equal(axisOf(key("ArrowLeft"), "linear"), "y_plus");
  assert.equal(axisOf(key("ArrowLeft"), "joint"), "base_plus");
  assert.equal(axisOf(key("ArrowLeft", { shiftKey: true }), "linear"), undefined);
  assert.equal(axisOf(key("x"), "linear"), undefined);
});

test("the stick with the largest deflection counts, and one near its centre is at rest", () => {
  assert.equal(pushed([0.2, -0.2, 0, 0]), null);
  assert.deepEqual(pushed([0.3, -1, 0, 0]), { axis: "x_plus", share: 1 });
  assert.equal(pushed([0, 0, 0, 0.5]).axis, "z_minus");
});

test("up on the mouse pad is ahead and left is left, in both dialects", () => {
  const up = mousePacket([0, -8], ARM, false).command;
  assert.deepEqual([up.x, up.y, up.rotation_deg, up.suction], [2, -0, 12, true]);
  assert.equal(mousePacket([-8, 0], ARM, false).command.y, 2);
  // There a positive Y swings the base to the right.
  const stock = mousePacket([-8, 0], ARM, true).command;
  assert.deepEqual([stock.y, stock.rotation_deg], [-2, 8]);
});

test("a distance too long for one packet is divided among several", () => {
  const { command, used } = mousePacket([0, -100], ARM, false);
  assert.equal(command.x, 5);
  assert.deepEqual(used.map((it) => it + 0), [0, -20]);
});

test("the middle of the hand pad is the same place in both dialects", () => {
  const hand = { far: 0, left: 0.5, z_mm: 40, grab: false };
  const mm = { zero_mm: 0, units_per_mm: 1 };
  assert.deepEqual(gesturePacket(hand, { x: mm, y: mm, z: mm }), { type: "gesture", x: 230, y: 45, z: 40, grab: false });
  // x is 230 mm and half of X; z is half of what Z is above 200, above the lowest place.
  assert.deepEqual(gesturePacket(hand, { x: { zero_mm: 230, units_per_mm: 2 }, y: mm, z: { zero_mm: -130, units_per_mm: 2 } }), { type: "gesture", x: 0, y: 45, z: 340, grab: false });
});
