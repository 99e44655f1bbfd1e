import assert from "node:assert/strict";
import { test } from "node:test";
import { Motion } from "./motion.js";

const STATUS_S = 0.08;
/** A status, and half a one. */
const BEHIND_S = 0.12;

function createMotion(status_s = STATUS_S) {
  const motion = new Motion();
  motion.status_s = status_s;
  return motion;
}

const joints = (base_deg) => ({ base_deg, rear_deg: 30, fore_deg: 40, servo_deg: 0 });

/** A motion that has heard these base angles, a status each 80 ms, the first at 10 s of the station and 100 s of ours. */
function heard(...angles) {
  const motion = createMotion();
  angles.forEach((angle, n) => motion.add({ at_s: 10 + 0.08 * n, joints: joints(angle) }, 100 + 0.08 * n));
  return motion;
}

/** The base angles that are drawn from the first status on, each millisecond. */
function drawn(motion, until_s) {
  return Array.from({ length: Math.round(until_s * 1000) }, (_, ms) => motion.at(100 + ms / 1000).joints.base_deg);
}

test("nothing is drawn before the first report", () => {
  assert.equal(new Motion().at(5), null);
});

test("a report is drawn at its time, with a small delay", () => {
  const motion = heard(0, 4, 10, 20);
  for (const [n, angle] of [0, 4, 10, 20].entries()) {
    const found = motion.at(100 + BEHIND_S + 0.08 * n).joints.base_deg;
    assert.ok(Math.abs(found - angle) < 1e-6, `status ${n}: ${found}, expected ${angle}`);
  }
});

test("the drawn arm stays between two reported statuses", () => {
  const angles = drawn(heard(0, 8, 8, 2, 30, 30.5), 0.8);
  assert.ok(Math.min(...angles.slice(120)) >= 0 && Math.max(...angles) <= 30.5);
  const stood = angles.slice(BEHIND_S * 1000 + 81, BEHIND_S * 1000 + 159);
  assert.deepEqual([...new Set(stood.map((it) => it.toFixed(6)))], ["8.000000"]);
});

test("it does not continue after the last status, and reports that it is at rest", () => {
  const motion = heard(0, 10);
  assert.deepEqual(motion.at(101), { joints: joints(10), moving: false });
  assert.equal(motion.at(100 + BEHIND_S + 0.04).moving, true);
});

test("an even turn is drawn evenly: no step is twice as large as another one", () => {
  const angles = drawn(heard(0, 5, 10, 15, 20, 25), 0.6).slice(BEHIND_S * 1000 + 5, BEHIND_S * 1000 + 390);
  const steps = angles.slice(1).map((angle, n) => angle - angles[n]);
  assert.ok(Math.max(...steps) < 2 * Math.min(...steps), `${Math.min(...steps)} to ${Math.max(...steps)}`);
});

test("other reports of a station between two statuses do not stop the arm on its path", () => {
  const motion = createMotion(), angles = [];
  // A status each 80 ms; the same place is told again 30 and 40 ms after it, as while a button is held.
  for (let n = 0; n < 12; n += 1) for (const ms of [0, 30, 40]) motion.add({ at_s: 10 + 0.08 * n + ms / 1000, joints: joints(5 * n) }, 100 + 0.08 * n + ms / 1000);
  for (let ms = 800; ms < 950; ms += 5) angles.push(motion.at(100 + ms / 1000).joints.base_deg);
  const steps = angles.slice(1).map((angle, n) => angle - angles[n]);
  assert.ok(Math.min(...steps) > 0.25 && Math.max(...steps) < 0.38, `${Math.min(...steps)} to ${Math.max(...steps)}, expected 0.3125`);
});

test("an arm at rest begins to move at the time of its motion, not at its first report at rest", () => {
  const motion = createMotion();
  for (let n = 0; n < 10; n += 1) motion.add({ at_s: 10 + 0.08 * n, joints: joints(0) }, 100 + 0.08 * n);
  motion.add({ at_s: 10.8, joints: joints(8) }, 100.8);
  assert.equal(motion.at(100.71 + BEHIND_S).joints.base_deg, 0);
  const half = motion.at(100.76 + BEHIND_S).joints.base_deg;
  assert.ok(half > 1 && half < 7, `${half}`);
});

test("a late status pauses the drawing and does not make it jump", () => {
  const motion = heard(0, 5, 10);
  const stood = motion.at(100.5).joints.base_deg;
  motion.add({ at_s: 10.24, joints: joints(15) }, 100.5);
  assert.equal(stood, 10);
  assert.ok(Math.abs(motion.at(100.5).joints.base_deg - 15) < 0.5);
});

test("a restarted station is followed again", () => {
  const motion = heard(0, 5, 10);
  motion.add({ at_s: 0.1, joints: joints(-20) }, 130);
  assert.equal(motion.at(130.2).joints.base_deg, -20);
});

test("an arm with more frequent reports is drawn with less delay", () => {
  const motion = createMotion(0.04);
  for (let n = 0; n < 5; n += 1) motion.add({ at_s: 10 + 0.04 * n, joints: joints(n) }, 100 + 0.04 * n);
  assert.ok(Math.abs(motion.at(100 + 0.06 + 0.04 * 3).joints.base_deg - 3) < 1e-6);
});
