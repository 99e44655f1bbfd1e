import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { forward, inverse, links } from "./kinematics.js";
import { CUP, LASER } from "./sample.test.js";

const { rear_arm_mm: REAR_MM, forearm_mm: FORE_MM, crank_mm: CRANK_MM } = CUP;

// What a real arm reported where it stood.
const REAL = readFileSync(new URL("../../../crates/arm/tests/data/real-arm-poses.csv", import.meta.url), "utf8")
  .split("\n").filter((line) => /^\d/.test(line)).map((line) => {
    const [, base_deg, rear_deg, fore_deg, x_mm, y_mm, z_mm] = line.split(",").map(Number);
    return { joints: { base_deg, rear_deg, fore_deg, servo_deg: 0 }, x_mm, y_mm, z_mm };
  });

const between = ([r0, z0], [r1, z1]) => Math.hypot(r1 - r0, z1 - z0);

function near(found, expected, allowed, what) {
  assert.ok(Math.abs(found - expected) <= allowed, `${what}: ${found}, expected ${expected} to ${allowed}`);
}

test("the computed tool is at the place that a real arm reported", () => {
  assert.equal(REAL.length, 30);
  for (const { joints, ...place } of REAL) {
    const found = forward(joints, CUP);
    // Its program has 3.1416 for pi.
    for (const name of ["x_mm", "y_mm", "z_mm"]) near(found[name], place[name], 0.002, `${name} at ${JSON.stringify(joints)}`);
  }
});

test("the inverse of a pose gives the joints of that pose", () => {
  for (const { joints } of REAL) {
    const found = inverse(forward({ ...joints, servo_deg: 12 }, LASER), LASER);
    for (const name of Object.keys(joints)) near(found[name], name === "servo_deg" ? 12 : joints[name], 1e-9, name);
  }
});

test("a place beyond the links has no joints", () => {
  assert.equal(inverse({ x_mm: 360, y_mm: 0, z_mm: 0, rotation_deg: 0 }, CUP), null);
  assert.equal(inverse({ x_mm: 60, y_mm: 0, z_mm: 0, rotation_deg: 0 }, CUP), null);
  assert.equal(inverse({ x_mm: NaN, y_mm: 0, z_mm: 0, rotation_deg: 0 }, CUP), null);
});

test("rods and crank keep their lengths in every pose", () => {
  for (const { joints } of REAL) {
    const at = links(joints, CUP);
    near(between(...at.rearRod), REAR_MM, 1e-9, "rear rod");
    near(between(...at.frontRod), FORE_MM, 1e-9, "front rod");
    near(between(at.crank, at.tail), REAR_MM, 1e-9, "crank's rod");
    near(between([0, 0], at.crank), CRANK_MM, 1e-9, "crank");
    near(between(at.tail, at.wrist), CRANK_MM + FORE_MM, 1e-9, "forearm with its tail");
  }
});

test("the holder of the front rod is level at the elbow and at the wrist", () => {
  for (const { joints } of REAL) {
    const at = links(joints, CUP);
    for (const axis of [0, 1]) near(at.frontRod[1][axis] - at.wrist[axis], at.frontRod[0][axis] - at.elbow[axis], 1e-9, "offset");
  }
});
