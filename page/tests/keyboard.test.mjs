// The main tasks with the keyboard alone: Tab, arrows, Enter and Space, with no pointer at all.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { open, panelIsShown, passed, pose, rest, waitForAnswer } from "./bench.mjs";

/** More Tab stops than any panel has. */
const MOST_TABS = 80;

let bench, page;

before(async () => {
  bench = await open({ viewport: { width: 1280, height: 720 } });
  ({ page } = bench);
});
after(() => bench.end());
afterEach(() => assert.deepEqual(bench.errors, []));

/** Presses Tab until an element that matches has the focus, and it is in sight. */
async function tabTo(selector) {
  for (let n = 0; n < MOST_TABS; n += 1) {
    await page.keyboard.press("Tab");
    if (await page.evaluate((selector) => document.activeElement.matches(selector), selector)) {
      const isSeen = await page.evaluate(() => {
        const { x, y, width, height } = document.activeElement.getBoundingClientRect();
        return document.activeElement.parentElement.contains(document.elementFromPoint(x + width / 2, y + height / 2));
      });
      return assert.ok(isSeen, `${selector} has the focus, but is covered`);
    }
  }
  assert.fail(`Tab does not reach ${selector}`);
}

/** Opens a tab of the panel with the arrow keys. */
async function openTab(name) {
  await tabTo("[role=tab]");
  for (let n = 0; n < 6 && (await page.evaluate(() => document.activeElement.id)) !== `tab-${name}`; n += 1) await page.keyboard.press("ArrowRight");
  await panelIsShown(page, name);
}

const phase = (name) => waitForAnswer(page, "api/v1/state", ({ job }) => job?.phase === name);

test("the pose is confirmed, and the arm jogs while Enter is held", async () => {
  await tabTo("#confirm-pose");
  await page.keyboard.press("Enter");
  await tabTo("#confirm-yes");
  await page.keyboard.press("Enter");
  await page.waitForSelector("[data-axis=y_plus]:enabled");
  await rest(page);
  const y_mm = await pose(page, "y_mm");
  await tabTo("[data-axis=y_plus]");
  await page.keyboard.down("Enter");
  await page.waitForFunction((y_mm) => Number(document.querySelector("[data-pose=y_mm]").textContent) > y_mm + 5, y_mm);
  await page.keyboard.up("Enter");
  await rest(page);
  await passed(page, 0.4);
});

test("arrow keys pressed faster than the page draws move one tab each", async () => {
  await openTab("move");
  await Promise.all(["ArrowRight", "ArrowRight", "ArrowRight", "ArrowLeft"].map((key) => page.keyboard.press(key)));
  await panelIsShown(page, "teach");
});

test("two positions are taught, looped, paused, resumed and ended", async () => {
  await openTab("teach");
  await tabTo("#capture");
  await page.keyboard.press("Enter");
  await page.waitForSelector("#step-0");
  await tabTo("[data-axis=y_minus]");
  await page.keyboard.down(" ");
  await page.waitForFunction(() => document.querySelector("#moving").dataset.moving === "true");
  await page.keyboard.up(" ");
  await rest(page);
  await passed(page, 0.4);
  await tabTo("#capture");
  await page.keyboard.press("Enter");
  await page.waitForSelector("#step-1");
  await page.waitForSelector("#teach-loop:enabled");
  await tabTo("#teach-loop");
  await page.keyboard.press("Enter");
  await phase("running");
  await tabTo("#pause");
  await page.keyboard.press(" ");
  await phase("paused");
  await waitForAnswer(page, "api/v1/state", ({ arm }) => !arm.moving);
  await passed(page, 0.4);
  await page.keyboard.press(" ");
  await phase("running");
  await tabTo("#job-end");
  await page.keyboard.press("Enter");
  await waitForAnswer(page, "api/v1/state", ({ job, arm }) => !job && !arm.moving);
  assert.equal(await page.isVisible("#stopped"), false);
});

test("a text is drawn, and Escape stops the arm", async () => {
  await openTab("draw");
  await tabTo("[name=draw-what]");
  await page.keyboard.press("ArrowRight");
  await tabTo("#draw-text");
  await page.keyboard.type("Hi");
  await page.waitForSelector("#draw-start:enabled");
  await tabTo("#draw-start");
  await page.keyboard.press("Enter");
  await phase("running");
  await page.keyboard.press("Escape");
  await page.waitForSelector("#stopped");
});
