import assert from "node:assert/strict";
import { test } from "node:test";
import { inverse } from "./links.js";
import { nearKeepOut, nearLimits } from "./near.js";
import { STOCK } from "./view.js";

const at = (x_mm, y_mm, z_mm, servo = 0) => ({ ...inverse({ x_mm, y_mm, z_mm, rotation_deg: 0 }, "suction_cup"), servo_deg: servo });
const names = (joints) => nearLimits(joints, "suction_cup", STOCK).map(({ quantity, bound }) => `${quantity} ${bound}`);

test("in the middle of its room the arm is near no limit", () => {
  assert.deepEqual(names(at(220, 0, 0)), []);
});

test("the height and the reach are near from 20 mm on", () => {
  assert.ok(!names(at(200, 0, 115.9)).includes("z 136"));
  assert.ok(names(at(200, 0, 116.5)).includes("z 136"));
  assert.ok(names(at(0, -148, 20)).includes("reach 129"));
});

test("a joint is near its limit from 5 degrees on, and the closer the more", () => {
  const [near] = nearLimits(at(220, 0, 0, 86), "suction_cup", STOCK);
  assert.equal(near.quantity, "servo");
  assert.equal(near.bound, 90);
  assert.ok(Math.abs(near.closeness - 0.2) < 1e-9);
  assert.equal(nearLimits(at(220, 0, 0, 95), "suction_cup", STOCK)[0].closeness, 1);
});

test("a keep-out is near from 20 mm on, in every direction", () => {
  const box = { box: { x_mm: [0, 10], y_mm: [0, 10], z_mm: [0, 10] } };
  assert.equal(nearKeepOut(box, [5, 5, 5]), 1);
  assert.equal(nearKeepOut(box, [20, 5, 5]), 0.5);
  assert.equal(nearKeepOut(box, [5, 5, 40]), 0);
  const cylinder = { cylinder: { x_mm: 100, y_mm: 0, radius_mm: 10, z_mm: [0, 50] } };
  assert.equal(nearKeepOut(cylinder, [100, 25, 20]), 0.25);
});
