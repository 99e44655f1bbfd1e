// A person calibrates an arm on the page: judged on what the station then knows of it.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { open } from "./bench.mjs";

/** How far the arm of this test is from its drawing, in degrees: base, rear arm, forearm. */
const ZEROS = [3, -4, 2];
/** The wrist when the tip is on the paper, in mm; the links, and how far the suction cup stands out. */
const PAPER_MM = -30, REAR_MM = 135, FORE_MM = 160, CUP_MM = 55.07;

let bench, page, lease;

before(async () => {
  bench = await open({ virtual: true });
  ({ page } = bench);
  await page.click("#first-close");
  await page.click("#take");
  await page.waitForSelector("#release");
});
after(() => bench.end());
afterEach(() => assert.deepEqual(bench.errors, []));

const waitForText = (id, part) => page.waitForFunction(([id, part]) => document.getElementById(id)?.textContent.includes(part), [id, part]);
const known = () => bench.ask("api/v1/calibration");
const deg = (angle) => (angle * 180) / Math.PI;

/** What that arm says when its tip is at a place of the sheet, from `out` and `z` of docs/calibration.md. */
function toldAt([x, y]) {
  const out = Math.hypot(x, y) - CUP_MM;
  const far = Math.hypot(out, PAPER_MM);
  // The triangle of the two links, and how steep it stands.
  const rear = Math.atan2(out, PAPER_MM) - Math.acos((far ** 2 + REAR_MM ** 2 - FORE_MM ** 2) / (2 * far * REAR_MM));
  const fore = Math.atan2(REAR_MM * Math.cos(rear) - PAPER_MM, out - REAR_MM * Math.sin(rear));
  return [deg(Math.atan2(y, x)), deg(rear), deg(fore)].map((it, joint) => it - ZEROS[joint]);
}

async function ask(method, path, body) {
  const headers = { "content-type": "application/json", ...(lease && { "dobot-lease": lease }) };
  const answer = await fetch(new URL(path, bench.url), { method, headers, body: JSON.stringify(body) });
  const text = await answer.text();
  assert.ok(answer.ok, text);
  return text && JSON.parse(text);
}

/** A sheet as it is printed: its number, and the length of its bar as drawn. */
async function print() {
  const answer = await fetch(new URL("api/v1/calibration/sheet", bench.url));
  const svg = await answer.text();
  const [, left, right] = /M([\d.]+) 188H([\d.]+)M/.exec(svg);
  return { sheet: /sheet (\d+):/.exec(svg)[1], bar_mm: right - left };
}

/** Moves the arm to a pose from the right and from above. */
async function approach({ base_deg, rear_deg, fore_deg }) {
  for (const more of [-1, 0]) {
    const command = { type: "move_joints", base_deg: base_deg + more, rear_deg: rear_deg + more, fore_deg: fore_deg + more, servo_deg: 0, suction: false, gripper_deg: 0, mode: "movj", pause_s: 0 };
    await ask("POST", "api/v1/commands", { command });
  }
}

/** Has the arm stand as it would with its tip on a point. */
async function stand(place) {
  const [base_deg, rear_deg, fore_deg] = toldAt(place);
  await approach({ base_deg, rear_deg, fore_deg });
  await page.waitForFunction((angles) => {
    const isThere = ([name, angle]) => Math.abs(Number(document.querySelector(`[data-pose=${name}]`).textContent) - angle) < 0.06;
    return Object.entries(angles).every(isThere) && !document.querySelector("#calibrate-touch").disabled;
  }, { base_deg, rear_deg, fore_deg });
}

test("a person finds the zeros of an arm, sees the result, saves it, and undoes it", async () => {
  await page.click("#tab-set_up");
  await waitForText("calibrate-known", "Not calibrated");
  assert.equal(await page.isDisabled("#calibrate-before"), true);
  await page.click("#calibrate-begin");
  const { sheet, bar_mm } = await print();
  await page.fill("#calibrate-number", sheet);
  await page.fill("#calibrate-bar", String(bar_mm * 0.97));
  await page.click("#calibrate-next");
  await waitForText("calibrate", "97.0 %");
  await page.fill("#calibrate-bar", String(bar_mm + 0.2));
  await page.keyboard.press("Enter");
  await waitForText("calibrate-point", "point 1");

  // Who moves the arm does not matter to the page: here it is the test.
  await page.click("#release");
  lease = (await ask("POST", "api/v1/lease", { name: "calibrate.test" })).token;
  const { points_mm } = await bench.ask("api/v1/calibration/points");
  const touch = async (point) => {
    await waitForText("calibrate-point", `point ${point + 1} `);
    await stand(points_mm[point]);
    await page.click("#calibrate-touch");
  };
  for (const point of [0, 1, 2]) await touch(point);
  // Another tab forgets nothing, and what was left out or touched is taken back.
  await page.click("#tab-move");
  await page.click("#tab-set_up");
  await page.click("#calibrate-skip");
  await waitForText("calibrate-point", "point 5 ");
  await page.click("#calibrate-back");
  for (const point of [3, 4, 5, 6, 7]) await touch(point);
  await waitForText("calibrate-result", "typically");
  assert.equal(await page.textContent("#calibrate-trust"), "good");
  await waitForText("calibrate-touches", "Point 8");
  assert.equal(await page.locator("#calibrate-touches dt").count(), 8);
  // There is no block on the point, so the touch is far below where its top would be, and is named.
  await page.fill("#calibrate-block", "-3");
  await waitForText("calibrate-why", "0 to 100 mm");
  assert.equal(await page.isDisabled("#calibrate-touch"), true);
  await page.fill("#calibrate-block", "40");
  await waitForText("calibrate-point", "point 9 ");
  await stand(points_mm[8]);
  await page.click("#calibrate-touch");
  await waitForText("calibrate-touches", "Point 9, 40 mm higher");
  await waitForText("calibrate-touches", "excluded");
  assert.equal(await page.inputValue("#calibrate-block"), "");
  await page.click("#calibrate-back");
  await waitForText("calibrate-result", "typically");
  assert.deepEqual(await known(), { calibration: null, before: null });
  assert.equal(await page.locator("#calibrate-keep").count(), 0);
  await page.click("#calibrate-show");
  await page.click("#calibrate-keep");
  await waitForText("calibrate-known", "8 points agreed");
  const { zeros } = (await known()).calibration;
  for (const [joint, wanted] of ZEROS.entries()) assert.ok(Math.abs(Object.values(zeros)[joint] - wanted) < 1.5, JSON.stringify(zeros));

  await page.click("#calibrate-forget");
  await page.click("#confirm-yes");
  await waitForText("calibrate-known", "Not calibrated");
  assert.equal((await known()).calibration, null);
  await page.click("#calibrate-before");
  await waitForText("calibrate-known", "8 points agreed");
  assert.deepEqual((await known()).calibration.zeros, zeros);
});

test("the arm gets its angles with its base straight ahead, and a reset makes touches void", async () => {
  await ask("DELETE", "api/v1/lease");
  lease = undefined;
  await page.click("#calibrate-angles");
  await page.click("#confirm-yes");
  await waitForText("calibrate-known", "angles were sent");
  await page.waitForFunction(() => Math.abs(Number(document.querySelector("[data-pose=base_deg]").textContent)) < 0.1);
  assert.equal((await bench.ask("api/v1/state")).calibrated.angles_set, true);
  assert.equal(await page.locator("#calibrate-angles").count(), 0);
  await page.click("#confirm-pose");
  await page.click("#confirm-yes");
  await page.click("#calibrate-begin");
  const { sheet, bar_mm } = await print();
  await page.fill("#calibrate-number", sheet);
  await page.fill("#calibrate-bar", String(bar_mm));
  await page.keyboard.press("Enter");
  await page.click("#release");
  lease = (await ask("POST", "api/v1/lease", { name: "calibrate.test" })).token;
  await approach((await bench.ask("api/v1/state")).arm);
  await page.click("#calibrate-touch");
  await waitForText("calibrate-point", "point 2 ");
  await ask("PUT", "api/v1/faults", { faults: ["reset@10ms"], seed: 0 });
  await waitForText("calibrate-lost", "Discarded points: 1");
  await waitForText("calibrate-point", "point 1 ");
  assert.equal(await page.isDisabled("#calibrate-touch"), true);
  await page.click("#calibrate-leave");
  await page.waitForSelector("#calibrate-begin");
});
