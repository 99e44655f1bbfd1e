// How many clicks the main tasks take, and that Start says what is missing, with a button for each.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { moved, open, passed, press, rest, takeControl, waitForAnswer } from "./bench.mjs";

let bench, page, traffic, clicks;

before(async () => {
  bench = await open({ viewport: { width: 1280, height: 720 } });
  ({ page, traffic } = bench);
  await takeControl(page);
  await page.click("#release");
  await page.waitForSelector("#take");
});
after(() => bench.end());
afterEach(() => assert.deepEqual(bench.errors, []));

async function click(selector) {
  clicks += 1;
  await page.click(selector);
}
const isInSight = async (selector) => {
  const { y, height } = await page.locator(selector).boundingBox();
  return y > 0 && y + height < 720;
};
const phase = (name) => waitForAnswer(page, "api/v1/state", ({ job }) => job?.phase === name);
const missing = () => page.locator("#draw-missing li span").allTextContents();

test("two positions are taught and looped with five clicks", async (t) => {
  await page.click("#tab-teach");
  clicks = 0;
  await click("#capture");
  await page.waitForSelector("#step-0");
  clicks += 1;
  await press(page, "y_plus");
  await moved(page, "y_mm", 20);
  await page.mouse.up();
  await rest(page);
  await passed(page, 0.4);
  await click("#capture");
  await page.waitForSelector("#step-1");
  await page.waitForSelector("#teach-loop:enabled");
  await click("#teach-loop");
  await phase("running");
  t.diagnostic(`clicks: teach two positions and loop them: ${clicks}`);
  assert.ok(clicks <= 5, `${clicks} clicks`);
  assert.ok(await isInSight("#job-end"));
  await page.click("#job-end");
  await waitForAnswer(page, "api/v1/state", ({ job, arm }) => !job && !arm.moving);
  await passed(page, 0.4);
});

test("a drawing is burned, paused, resumed and stopped with fourteen clicks, and Start names what is missing", async (t) => {
  clicks = 0;
  await click("#tab-draw");
  clicks += 1;
  await page.check("#draw-title ~ .segments input[value=text]", { force: true });
  await page.fill("#draw-text", "HHHH");
  // Opens the list, and chooses from it.
  clicks += 2;
  await page.selectOption("#draw-tool", { label: await page.locator("#draw-tool optgroup:last-child option").first().textContent() });
  await page.waitForFunction(() => document.querySelector("#draw-status").textContent.includes("to burn"));
  assert.deepEqual(await missing(), ["The mounted tool is not the laser.", "The laser is not armed."]);
  assert.ok(await page.isDisabled("#draw-start"));
  for (const id of ["#draw-start", "#draw-frame"]) assert.ok(await isInSight(id), id);
  await click("[data-remedy=not-laser]");
  await page.waitForSelector("[data-remedy=not-laser]", { state: "detached" });
  await waitForAnswer(page, "api/v1/state", ({ queue }) => queue.waiting + queue.under_way === 0);
  const from = traffic.packets.length;
  await click("#draw-frame");
  await phase("running");
  await waitForAnswer(page, "api/v1/state", ({ job, arm }) => !job && !arm.moving);
  await passed(page, 0.4);
  assert.equal(traffic.packets.slice(from).some(({ floats: [state, axis] }) => state === 4 && axis === 1), false, "the frame burns nothing");
  await click("[data-remedy=laser-disarmed]");
  await click("#confirm-yes");
  await page.waitForSelector("#draw-start:enabled");
  assert.equal(await page.isVisible("#draw-missing"), false);
  await click("#draw-start");
  await phase("running");
  await click("#pause");
  await phase("paused");
  await waitForAnswer(page, "api/v1/state", ({ arm, laser }) => !arm.moving && !laser.on);
  await passed(page, 0.4);
  await click("#resume");
  await phase("running");
  await click("#stop");
  await page.waitForSelector("#stopped");
  await waitForAnswer(page, "api/v1/state", ({ laser, arm }) => laser.armed_for_s === 0 && !laser.on && !arm.moving);
  await click("#reset");
  await click("#confirm-yes");
  await page.waitForSelector("#stopped", { state: "detached" });
  t.diagnostic(`clicks: burn: material, frame, arm, start, pause, resume, STOP, clear: ${clicks}`);
  assert.ok(clicks <= 14, `${clicks} clicks`);
  await page.click("#job-end");
});

test("the mounted tool is marked", async () => {
  await page.click("#tab-move");
  assert.equal(await page.getAttribute("[data-mount=laser]", "aria-pressed"), "true");
  assert.equal(await page.getAttribute("[data-mount=gripper]", "aria-pressed"), "false");
});

test("nine points of a calibration are recorded with at most 23 clicks, which leaves two for Review and Save", async (t) => {
  // Not counted: the arm starts high enough for nine approaches.
  await page.click("#tab-move");
  for (const [field, mm] of [["x_mm", 200], ["y_mm", 0], ["z_mm", 60]]) await page.fill(`#target-${field}`, String(mm));
  await page.click("#target-go:enabled");
  await rest(page);
  clicks = 0;
  await click("#tab-set_up");
  clicks += 1;
  await page.check("#jog-float [name=step][value='10']", { force: true });
  await click("#calibrate-begin");
  // The number of the sheet has the focus, and Enter leads on.
  await page.waitForFunction(() => document.activeElement.id === "calibrate-number");
  await page.keyboard.type("417");
  await page.keyboard.press("Tab");
  await page.keyboard.type("189.5");
  await page.keyboard.press("Enter");
  for (let point = 1; point <= 9; point += 1) {
    await page.waitForFunction((point) => document.querySelector("#calibrate-point")?.textContent.includes(`point ${point} `), point);
    // From the right and from above, as the page asks for.
    for (const [axis, name] of point === 1 ? [["y_plus", "y_mm"], ["z_minus", "z_mm"]] : [["z_minus", "z_mm"]]) {
      const changed = moved(page, name, 0.5);
      await click(`#jog-float [data-axis=${axis}]`);
      await changed;
      await rest(page);
    }
    await page.waitForSelector("#calibrate-touch:enabled").catch(async () => assert.fail(await page.textContent("#calibrate-why")));
    await click("#calibrate-touch");
  }
  await page.waitForFunction(() => document.querySelectorAll("#calibrate-touches dt").length === 9);
  t.diagnostic(`clicks: calibrate by nine points, with Review and Save: ${clicks + 2}`);
  assert.match(await page.textContent("#calibrate-point"), /^All points are recorded/);
  assert.ok(clicks <= 23, `${clicks} clicks`);
});
