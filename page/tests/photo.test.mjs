// Calibration by one photo: the arm draws the crosses, a rendered photo shows them.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, afterEach, before, test } from "node:test";
import { isStop, open, takeControl } from "./bench.mjs";
import { renderPhotos, writeBitmap } from "./photos.mjs";

let bench, page, traffic, folder;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), "photo-"));
  bench = await open({ speed: 20 });
  ({ page, traffic } = bench);
  await takeControl(page);
  await page.click("#tab-set_up");
  await page.click("#calibrate-begin");
  const svg = await fetch(new URL("api/v1/calibration/sheet", bench.url)).then((answer) => answer.text());
  const [, left, right] = /M([\d.]+) 188H([\d.]+)M/.exec(svg);
  await page.fill("#calibrate-number", /sheet (\d+):/.exec(svg)[1]);
  await page.fill("#calibrate-bar", String(right - left));
  await page.click("#calibrate-next");
  await page.click("#calibrate-photo summary");
});
after(async () => {
  await bench?.end();
  rmSync(folder, { recursive: true });
});
afterEach(() => assert.deepEqual(bench.errors, []));

const photo = (set, size) => writeBitmap(renderPhotos(folder, set, 1, size)[0]);
const waitForStatus = (part) => page.waitForFunction((part) => document.querySelector("#photo-status")?.textContent.includes(part), part);

test("a stop ends the drawing, and no photo can be taken of a part", async () => {
  assert.equal(await page.isDisabled("#photo-file"), true);
  const from = traffic.packets.length;
  await page.click("#photo-draw");
  await traffic.next(from, () => traffic.targets(from).length > 4);
  await page.keyboard.press("Escape");
  assert.ok(await traffic.next(from, isStop));
  await waitForStatus("interrupted");
  assert.equal(await page.isDisabled("#photo-file"), true);
  await page.click("#reset");
  await page.click("#confirm-yes");
  await page.waitForFunction(() => !document.querySelector("#photo-draw").disabled);
});

test("the arm draws 25 crosses; a photo of them calibrates it", async () => {
  const from = traffic.packets.length;
  await page.click("#photo-draw");
  await waitForStatus("All crosses are drawn");
  const downs = traffic.targets(from);
  const [z] = downs.map(([, , z]) => z).toSorted((a, b) => a - b);
  for (const n of Array.from({ length: 25 }, (_, n) => n)) {
    const [x, y] = [140 + 30 * Math.floor(n / 5), -90 + 45 * (n % 5)];
    const own = downs.filter(([ax, ay, az]) => Math.abs(az - z) < 0.01 && Math.hypot(ax - x, ay - y) < 5);
    assert.ok(own.some(([ax, ay]) => Math.hypot(ax - x, ay - y) < 0.01), `${x}, ${y}`);
    assert.equal(own.filter(([ax, ay]) => Math.abs(Math.hypot(ax - x, ay - y) - 4) < 0.01).length, 4, `${x}, ${y}`);
  }
  await page.setInputFiles("#photo-file", photo("covered"));
  await waitForStatus("Fewer than three corners");
  await page.setInputFiles("#photo-file", photo("still"));
  await waitForStatus("crosses were found; 12 are needed");
  await page.setInputFiles("#photo-file", photo("drawn", "1024x768"));
  await waitForStatus("crosses were found. The result is below");
  await page.waitForSelector("#calibrate-result");
  // This arm has no errors but those of its rounding.
  for (const joint of ["base", "rear", "fore"]) {
    const text = await page.textContent(`#calibrate [data-number=${joint}] >> nth=-1`);
    assert.ok(Math.abs(Number.parseFloat(text.replace("−", "-"))) < 0.6, `${joint}: ${text}`);
  }
});
