// A person without an arm takes the tour, and the arm does what the tour promises.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { waitForAnswer, open, passed, rest } from "./bench.mjs";

let bench, page;

before(async () => {
  bench = await open({ virtual: true });
  ({ page } = bench);
});
after(() => bench.end());
afterEach(() => assert.deepEqual(bench.errors, []));

const at = async (step) => page.waitForFunction((step) => document.querySelector("#lesson")?.textContent.includes(`${step} of 12`), step);
const state = () => bench.ask("api/v1/state");

/** Moves the tip by ten millimetres, as often as said. */
async function steps(axis, times) {
  await page.click("#tab-move");
  await page.check("[name=step][value='10']", { force: true });
  for (let n = 0; n < times; n += 1) {
    const before = (await state()).arm;
    await page.click(`[data-axis=${axis}]`);
    while (JSON.stringify((await state()).arm) === JSON.stringify(before)) await passed(page, 0.1);
    // What the page says may be from before it moved.
    await waitForAnswer(page, "api/v1/state", ({ arm, queue }) => !arm.moving && queue.waiting + queue.under_way === 0);
    await rest(page);
    await passed(page, 0.4);
  }
}

test("the tour leads from the first motion to a drawing and a refusal", async () => {
  await page.click("#first-tour");
  await at(1);
  if (await page.isVisible("#confirm-pose")) {
    await page.click("#confirm-pose");
    await page.click("#confirm-yes");
  }
  await page.click("#lesson-next");
  await at(2);
  assert.ok(await page.evaluate(() => document.querySelector("#tab-move").hasAttribute("data-here")));
  await steps("y_plus", 2);
  await at(3);
  await page.keyboard.press("Space");
  await at(4);
  assert.notEqual((await state()).stop, null, "the arm is stopped");
  await page.click("#reset");
  await page.click("#confirm-yes");
  await at(5);
  await page.click("#tab-teach");
  await page.click("#capture");
  await at(6);
  await steps("z_plus", 2);
  await page.click("#tab-teach");
  await page.click("#capture");
  await at(7);
  await page.click("#teach-loop");
  await at(8);
  assert.ok((await state()).job.program.cycles_done >= 1, "the arm went from one place to the other");
  await page.click("#teach-end");
  await at(9);
  await page.click("#tab-draw");
  await page.check("#draw-title ~ .segments input[value=text]", { force: true });
  await page.fill("#draw-text", "Hi");
  await page.waitForFunction(() => document.querySelector("#draw-start") && !document.querySelector("#draw-start").disabled);
  await page.click("#draw-start");
  await at(10);
  assert.equal((await state()).job.kind, "drawing");
  await at(11);
  await page.click("#tab-move");
  const was = (await state()).arm;
  await page.fill("#target-x_mm", "600");
  await at(12);
  assert.deepEqual((await state()).arm, was, "what is refused moves nothing");
  await page.click("#lesson-next");
  await page.waitForSelector("#lesson", { state: "detached" });
});

test("a lesson asks for a number, and continues when it is correct", async () => {
  await page.click("#tab-set_up");
  await page.click("#lessons-open");
  await page.click("[data-lesson=kinematics]");
  await page.click("#lesson-next");
  await page.fill("#lesson-answer", "30");
  await page.fill("#lesson-answer", "26.57");
  await page.waitForFunction(() => document.querySelector("#lesson-text").textContent.includes("223.6 mm"));
  await page.click("#lesson-end");
  await page.waitForSelector("#lesson", { state: "detached" });
});
