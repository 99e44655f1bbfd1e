// Small and enlarged windows: every panel is usable, STOP is never covered, and what is pressed is large enough.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { open, panelIsShown } from "./bench.mjs";

/** 1440 x 900 at 200 and 300 %, the size of WCAG 1.4.10, and phones. */
const SIZES = { "200 %": [720, 450], "300 %": [480, 300], "320 x 256": [320, 256], "a phone in landscape": [844, 390], "a phone": [390, 844], "1280 x 720": [1280, 720] };
const TABS = ["move", "draw", "teach", "look", "jobs", "watch", "set_up"];
/** The least size of what is pressed: WCAG 2.5.8, and that of a finger. */
const LEAST_PX = 24, FINGER_PX = 44;

let bench;

before(async () => {
  bench = await open({ virtual: true });
});
after(() => bench.end());
afterEach(() => assert.deepEqual(bench.errors, []));

/** Whether the middle of STOP belongs to STOP, and it lies within the window. */
const isStopFree = (page) => page.evaluate(() => {
  const { left, right, top, bottom } = document.getElementById("stop").getBoundingClientRect();
  const found = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
  return found?.closest("#stop") !== null && top >= 0 && bottom <= innerHeight && left >= 0 && right <= innerWidth;
});

/** Whether an element can be brought into sight and pressed there, and nothing lies over it. */
async function canPress(page, selector) {
  await page.click(selector, { trial: true });
}

/** The pressed elements that are smaller than allowed, with their sizes. Links in a text, and sliders across, count by their height. */
const tooSmall = (page, least) => page.evaluate((least) => {
  const all = document.querySelectorAll("button, select, a, summary, input:not([type=file])");
  const seen = [...all].filter((it) => it.checkVisibility({ visibilityProperty: true, opacityProperty: false }) && !it.closest("[hidden]"));
  return seen.flatMap((it) => {
    // A label around a choice belongs to what is pressed.
    const { width, height } = (it.matches("[type=radio], [type=checkbox]") ? it.closest("label") ?? it : it).getBoundingClientRect();
    return width === 0 || (width >= least && height >= least - 0.5) ? [] : [`${it.id || it.dataset.act || it.dataset.axis || it.name || it.className}: ${width.toFixed(0)} x ${height.toFixed(0)}`];
  });
}, least);

for (const [name, [width, height]] of Object.entries(SIZES)) {
  test(`on ${name}, STOP is free, each panel is usable, and nothing is cut off`, async () => {
    const page = await bench.visit({ viewport: { width, height } });
    assert.ok(await isStopFree(page), "with the welcome card");
    await page.click("#tab-set_up");
    for (const id of ["#first-close", "#jog-fold"]) await canPress(page, id);
    await page.click("#first-close");
    for (const tab of TABS) {
      await canPress(page, `#tab-${tab}`);
      await page.click(`#tab-${tab}`);
      assert.ok(await isStopFree(page), tab);
      await panelIsShown(page, tab);
      const room = await page.evaluate(() => document.getElementById("panel").clientHeight);
      assert.ok(room >= 120, `${tab}: ${room} px for the panel`);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true, `${tab} is wider than the window`);
      const least = name === "a phone" ? FINGER_PX : LEAST_PX;
      assert.deepEqual(await tooSmall(page, least), [], tab);
    }
    await page.click("#tab-move");
    for (const id of ["[data-axis=z_minus]:visible", "#home", "#arm-laser"]) await canPress(page, id);
    await page.click("#tab-draw");
    await page.check("#draw-title ~ .segments input[value=text]", { force: true });
    await page.fill("#draw-text", "Hello");
    await page.waitForFunction(() => document.querySelector("#draw-status")?.textContent.includes("Takes"));
    for (const id of ["#draw-start", "#draw-frame"]) {
      await page.waitForSelector(id);
      const { y, height: high } = await page.locator(id).boundingBox();
      if (height >= 700) assert.ok(y > 0 && y + high < height, `${id} is out of sight`);
    }
    await page.click("#stop");
    await page.waitForSelector("#stopped");
    await canPress(page, "#reset");
    assert.ok(await isStopFree(page), "while the arm is stopped");
    await page.click("#reset");
    await page.click("#confirm-yes");
    await page.waitForSelector("#stopped", { state: "detached" });
    await page.context().close();
  });
}

test("a message lies over the picture, and never over tabs, panel or STOP", async () => {
  for (const [width, height] of [[1280, 720], [1440, 900], [390, 844]]) {
    const page = await bench.visit({ viewport: { width, height } });
    await page.click("#first-close");
    await page.evaluate(async () => {
      await fetch("api/v1/message", { method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify({ text: "a message to all ".repeat(12) }) });
    });
    await page.waitForSelector("#message");
    for (const tab of TABS) await canPress(page, `#tab-${tab}`);
    assert.ok(await isStopFree(page));
    await page.context().close();
  }
});

test("with forced colours STOP has a border", async () => {
  const page = await bench.visit({ viewport: { width: 1280, height: 720 }, forcedColors: "active" });
  const { width, style } = await page.evaluate(() => {
    const { borderTopWidth: width, borderTopStyle: style } = getComputedStyle(document.getElementById("stop"));
    return { width, style };
  });
  assert.deepEqual({ width, style }, { width: "2px", style: "solid" });
  await page.context().close();
});
