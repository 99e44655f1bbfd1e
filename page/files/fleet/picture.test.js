import assert from "node:assert/strict";
import { test } from "node:test";

import { forward } from "../stage/kinematics.js";
import { CUP, FACTS } from "../stage/sample.test.js";
import { armAt, placer, seen } from "./picture.js";

const JOINTS = { base_deg: 30, rear_deg: 40, fore_deg: 50, servo_deg: 0 };

test("the tool is drawn at the place given by the joints", () => {
  const { x_mm, y_mm, z_mm } = forward(JOINTS, CUP), { tool, tip } = armAt(JOINTS, FACTS);
  for (const [found, wanted] of [[tool[0], x_mm], [tool[1], y_mm], [tool[2], z_mm]]) assert.ok(Math.abs(found - wanted) < 1e-9);
  assert.ok(tip[2] < tool[2] && tip[0] === tool[0]);
});

test("ahead is to the right, up is up, and a turn to the left goes away from the viewer", () => {
  const [ahead, left, up] = [[100, 0, 0], [0, 100, 0], [0, 0, 100]].map(seen);
  assert.ok(ahead[0] > 50 && up[0] === 0 && up[1] > 50 && left[1] > 0);
});

test("an arm stays within its picture in every pose", () => {
  for (const size of [{ width: 140, height: 90, density: 1 }, { width: 400, height: 250, density: 2 }]) {
    const at = placer(size);
    for (let base_deg = -135; base_deg <= 135; base_deg += 15) {
      for (const [rear_deg, fore_deg] of [[-5, -10], [0, 0], [50, 0], [70, 30], [45, 45], [60, 20]]) {
        const { elbow, tip } = armAt({ base_deg, rear_deg, fore_deg, servo_deg: 0 }, FACTS);
        for (const point of [elbow, tip]) {
          const [x, y] = at(point);
          assert.ok(x >= 0 && x <= size.width && y >= 0 && y <= size.height, `${base_deg} ${rear_deg} ${fore_deg}: ${x} ${y}`);
        }
      }
    }
  }
});
