// A press of each jog button as a step, judged on the packets that the arm got and on where it came to.
import assert from "node:assert/strict";
import { test } from "node:test";
import { waitForAnswer, open, rest, takeControl } from "./bench.mjs";

const STEPS = [0.1, 1, 10];
/** What each button changes: by frame, in the order of the buttons. Each pair leads back to where it began. */
const CHANGES = { linear: { x: "x_mm", y: "y_mm", z: "z_mm", servo: "servo_deg" }, joint: { base: "base_deg", rear: "rear_deg", fore: "fore_deg", servo: "servo_deg" } };
const PLACE = ["x_mm", "y_mm", "z_mm", "rotation_deg"], JOINTS = ["base_deg", "rear_deg", "fore_deg", "servo_deg"];
const TO_PLACE = 3, TO_JOINTS = 6;
/** Float 8 of a target (Table 3.7; note N2). */
const MODES = { specification: { line: 1, joints: 2 }, "firmware-1.1": { line: 2, joints: 1 } };
/** As far as an arm comes to stand from where it was sent: it counts the steps of its motors. */
const OFF = 0.03;

const isTarget = ({ floats: [state] }) => state === TO_PLACE || state === TO_JOINTS;
const isNear = (found, expected) => Math.abs(found - expected) < OFF;
const choose = (page, name, value) => page.check(`[name=${name}][value='${value}']`, { force: true });

/** The one target that a press sends, and where the arm rests afterwards. */
async function pressed(bench, axis, isThere) {
  const { page, traffic } = bench, from = traffic.packets.length;
  await page.click(`[data-axis=${axis}]:visible`);
  const target = await traffic.next(from, isTarget);
  assert.ok(target, `${axis}: no target; ${await page.textContent("#jog-why")}`);
  const { arm } = await waitForAnswer(page, "api/v1/state", ({ arm, queue }) => !arm.moving && queue.waiting + queue.under_way === 0 && isThere(arm));
  await rest(page);
  assert.equal(traffic.packets.slice(from).filter(isTarget).length, 1, axis);
  return { floats: target.floats, arm };
}

for (const personality of Object.keys(MODES)) {
  test(`each of the 16 buttons moves an arm of ${personality} by the selected step`, async () => {
    const bench = await open({ personality, speed: 5 });
    try {
      const { page } = bench;
      await takeControl(page);
      for (const [frame, changes] of Object.entries(CHANGES)) {
        await choose(page, "frame", frame);
        for (const step of STEPS) {
          await choose(page, "step", step);
          for (const [axis, name] of Object.entries(changes)) {
            for (const [way, by] of [["plus", step], ["minus", -step]]) {
              const what = `${frame} ${axis}_${way} by ${step}`;
              const { arm: before } = await bench.ask("api/v1/state");
              const { floats, arm } = await pressed(bench, `${axis}_${way}`, (now) => isNear(now[name], before[name] + by));
              // A turn of the tool is one of its servo, also where the tip moves in lines: the tip stays where it is.
              const isLine = frame === "linear" && axis !== "servo", names = isLine ? PLACE : JOINTS;
              assert.equal(floats[0], isLine ? TO_PLACE : TO_JOINTS, what);
              names.forEach((it, n) => assert.ok(Math.abs(floats[2 + n] - before[it] - (it === name ? by : 0)) < 1e-3, `${what}: ${it} is ${floats[2 + n]}, and was ${before[it]}`));
              assert.equal(floats[7], MODES[personality][isLine ? "line" : "joints"], what);
              for (const it of names) assert.ok(isNear(arm[it], before[it] + (it === name ? by : 0)), `${what}: ${it} came to ${arm[it]} from ${before[it]}`);
            }
          }
        }
      }
      assert.equal(await page.isVisible("#problem"), false);
      assert.deepEqual(bench.errors, []);
    } finally {
      await bench.end();
    }
  });
}
