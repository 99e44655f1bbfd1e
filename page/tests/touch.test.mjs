// A phone beside the machine: a finger holds a button, and the arm stays in sight.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { moved, open, passed, rest, takeControl } from "./bench.mjs";

let bench, page, traffic, session;

before(async () => {
  bench = await open({ viewport: { width: 390, height: 844 }, options: { hasTouch: true, isMobile: true } });
  ({ page, traffic } = bench);
  session = await page.context().newCDPSession(page);
  await takeControl(page);
  await rest(page);
  await passed(page, 0.4);
});
after(async () => {
  assert.deepEqual(bench.errors, []);
  await bench.end();
});

/** Puts a finger on the middle of an element, or takes it away. */
async function finger(type, selector) {
  const { x, y, width, height } = await page.locator(selector).boundingBox();
  const touchPoints = type === "touchEnd" ? [] : [{ x: x + width / 2, y: y + height / 2 }];
  await session.send("Input.dispatchTouchEvent", { type, touchPoints });
}

test("a finger on a button jogs, lifting it stops, and the stage stays in sight", async () => {
  const from = traffic.packets.length;
  await finger("touchStart", "[data-axis=y_plus]");
  await moved(page, "y_mm", 5);
  const stage = await page.locator("#stage").boundingBox();
  assert.ok(stage.y >= 0 && stage.height > 200 && stage.y + stage.height < 500);
  await finger("touchEnd", "[data-axis=y_plus]");
  await rest(page);
  const jogs = traffic.jogs(from).map((it) => it.text);
  assert.deepEqual(new Set(jogs), new Set(["linear 3", "linear 0"]));
  assert.equal(jogs.at(-1), "linear 0");
});

test("STOP is within reach of a thumb, and nothing extends beyond the screen", async () => {
  const stop = await page.locator("#stop").boundingBox();
  assert.ok(stop.y > 600 && stop.width > 300);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  const from = traffic.packets.length;
  await finger("touchStart", "[data-axis=x_plus]");
  await moved(page, "x_mm", 3);
  // By a mouse, while the finger stays.
  await page.mouse.click(stop.x + stop.width / 2, stop.y + stop.height / 2);
  await page.waitForSelector("#stopped");
  await finger("touchEnd", "[data-axis=x_plus]");
  assert.equal(traffic.jogs(from).at(-1).text, "linear 0");
});

test("a finger that slides off a held button releases it while it is still on the screen", async () => {
  await page.click("#reset");
  await page.click("#confirm-yes");
  await page.waitForSelector("[data-axis=y_minus]:enabled");
  const from = traffic.packets.length;
  const { x, y, width, height } = await page.locator("[data-axis=y_minus]").boundingBox();
  await finger("touchStart", "[data-axis=y_minus]");
  await moved(page, "y_mm", 3);
  await session.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: [{ x: x + width / 2, y: y + height + 30 }] });
  await rest(page);
  assert.equal(traffic.jogs(from).at(-1).text, "linear 0");
  await finger("touchEnd", "[data-axis=y_minus]");
});
