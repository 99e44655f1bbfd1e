// What a person watches: the link, the last minutes, what happened.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { moved, open, press, rest, takeControl } from "./bench.mjs";

let bench, page;

before(async () => {
  bench = await open();
  ({ page } = bench);
  await takeControl(page);
  await page.click("#tab-watch");
});
after(async () => {
  assert.deepEqual(bench.errors, []);
  await bench.end();
});

test("the numbers of the link are those of the station", async () => {
  const { link, dialect } = await bench.ask("api/v1/state");
  assert.equal(await page.textContent("#address"), link.address);
  assert.equal(await page.textContent("#dialect"), dialect);
  assert.match(await page.textContent("#statuses"), /^1[0-9]\.\d of 12\.5/);
});

test("events are listed, the newest first, and can be searched", async () => {
  await page.waitForFunction(() => document.querySelector("#notices li")?.textContent.includes("has control"));
  await page.fill("#filter", "CONFIRMED");
  await page.waitForFunction(() => document.querySelectorAll("#notices li").length === 1);
  assert.match(await page.textContent("#notices li"), /confirmed/);
});

test("each line of the charts is drawn, with its newest value beside it", async () => {
  await page.waitForFunction(() => document.querySelectorAll(".chart canvas").length === 4);
  const value = (name) => page.evaluate((name) => Number(document.querySelector(`[data-last=${name}]`).textContent), name);
  const before = await value("base_deg");
  await page.click("#tab-move");
  await press(page, "y_plus");
  await moved(page, "y_mm", 12);
  await page.mouse.up();
  await rest(page);
  await page.click("#tab-watch");
  await page.waitForFunction(([before]) => Number(document.querySelector("[data-last=base_deg]")?.textContent) > before + 1, [before]);
  // The arm rests; on a busy machine the page is told of it a little later than whoever asks.
  const rear = (await bench.ask("api/v1/state")).arm.rear_deg.toFixed(1);
  await page.waitForFunction((rear) => document.querySelector("[data-last=rear_deg]")?.textContent === rear, rear);
});
