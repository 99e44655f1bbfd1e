// What a person watches: the link, the last minutes, what happened.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { open, takeControl } from "./bench.mjs";

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

test("what happened stands there, the newest first, and can be searched", async () => {
  await page.waitForFunction(() => document.querySelector("#notices li")?.textContent.includes("has control"));
  await page.fill("#sought", "CONFIRMED");
  await page.waitForFunction(() => document.querySelectorAll("#notices li").length === 1);
  assert.match(await page.textContent("#notices li"), /confirmed/);
});

test("the charts draw what the arm does", async () => {
  const dark = () => page.evaluate(() => {
    const canvas = document.querySelectorAll(".chart canvas")[3];
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    return data.filter((it, n) => n % 4 === 3 && it > 0).length;
  });
  await page.waitForFunction(() => document.querySelectorAll(".chart canvas").length === 4);
  await page.locator(".chart").last().scrollIntoViewIfNeeded();
  const before = await dark();
  await page.waitForFunction(async (until_s) => (await (await fetch("api/v1/state")).json()).at_s > until_s, (await bench.ask("api/v1/state")).at_s + 3);
  assert.ok((await dark()) > before);
});
