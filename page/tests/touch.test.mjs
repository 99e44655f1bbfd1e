// A phone beside the machine: a finger holds a button, and the arm stays in sight.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { moved, open, passed, rest, takeControl } from "./bench.mjs";

let bench, page, told, session;

before(async () => {
  bench = await open({ viewport: { width: 390, height: 844 }, options: { hasTouch: true, isMobile: true } });
  ({ page, told } = bench);
  session = await page.context().newCDPSession(page);
  await takeControl(page);
  await rest(page);
  await passed(page, 0.4);
});
after(async () => {
  assert.deepEqual(bench.errors, []);
  await bench.end();
});

/** Fingers that are on the glass: each on the middle of an element. */
async function fingers(type, ...selectors) {
  const boxes = await Promise.all(selectors.map((selector) => page.locator(selector).boundingBox()));
  await session.send("Input.dispatchTouchEvent", { type, touchPoints: boxes.map(({ x, y, width, height }, id) => ({ x: x + width / 2, y: y + height / 2, id })) });
}

test("a finger that holds a button jogs, its lifting stops, and the stage stays in sight", async () => {
  const from = told.packets.length;
  await fingers("touchStart", "[data-axis=y_plus]");
  await moved(page, "y_mm", 5);
  const stage = await page.locator("#stage").boundingBox();
  assert.ok(stage.y >= 0 && stage.height > 200 && stage.y + stage.height < 500);
  await fingers("touchEnd");
  await rest(page);
  const jogs = told.jogs(from).map((it) => it.text);
  assert.deepEqual(new Set(jogs), new Set(["linear 3", "linear 0"]));
  assert.equal(jogs.at(-1), "linear 0");
});

test("STOP is within reach of a thumb, and nothing hangs over the edge", async () => {
  const stop = await page.locator("#stop").boundingBox();
  assert.ok(stop.y > 600 && stop.width > 300);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  const from = told.packets.length;
  await fingers("touchStart", "[data-axis=x_plus]");
  await moved(page, "x_mm", 3);
  // The thumb of the other hand, while the finger stays.
  await fingers("touchStart", "[data-axis=x_plus]", "#stop");
  await fingers("touchEnd", "[data-axis=x_plus]");
  await page.waitForSelector("#stopped");
  await fingers("touchEnd");
  assert.equal(told.jogs(from).at(-1).text, "linear 0");
});
