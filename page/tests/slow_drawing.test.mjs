// A computer that draws slowly: input comes first while a button is held, and the stage becomes flat rather than to interrupt it.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { moved, open, passed, press, rest, takeControl } from "./bench.mjs";

/** How long each frame takes; and one that could release a button if another delay were added to it. */
const FRAME_MS = 40, SLOW_FRAME_MS = 220;

let bench, page, traffic;

before(async () => {
  bench = await open({ webgl: true, scripts: slowDown });
  ({ page, traffic } = bench);
  await takeControl(page);
  await page.waitForSelector("#stage[data-shown='3d']");
});
after(() => bench.end());
afterEach(async () => {
  await page.mouse.up();
  assert.deepEqual(bench.errors, []);
});

/** Makes each copied frame of the stage as slow as wished, and keeps when it began. */
function slowDown() {
  window.frames = [];
  window.slow_ms = 0;
  const { drawImage } = CanvasRenderingContext2D.prototype;
  CanvasRenderingContext2D.prototype.drawImage = function (...all) {
    window.frames.push(performance.now());
    const until = performance.now() + window.slow_ms;
    while (performance.now() < until);
    return drawImage.apply(this, all);
  };
}

/** Opens the page anew: it has not seen a slow frame yet. */
async function reload() {
  await page.reload();
  await page.waitForSelector("#stage[data-shown='3d']");
  await page.click("#take");
  await page.waitForSelector("[data-axis=y_plus]:enabled");
  await rest(page);
}

/** Waits until the stage is flat, with the reason. */
async function isFlat() {
  await page.waitForSelector("#stage[data-shown='2d']");
  assert.match(await page.textContent("#flattened"), /Flat view/);
}

test("without a graphics card the page shows a copy of each frame, and waits for none", async () => {
  assert.ok(await page.evaluate(() => document.querySelector("#stage canvas").getContext("webgl2") === null && window.frames.length > 0));
});

test("a press changes the button, and restyles no other part of the page", async () => {
  await rest(page);
  await page.evaluate(() => {
    window.restyled = [];
    new MutationObserver((all) => window.restyled.push(...all.map((it) => it.attributeName))).observe(document.documentElement, { attributes: true });
  });
  await press(page, "y_plus");
  await page.waitForSelector("[data-axis=y_plus].is-held");
  await moved(page, "y_mm", 5);
  await page.mouse.up();
  await rest(page);
  assert.deepEqual(await page.evaluate(() => window.restyled), []);
});

test("while a button is held, each slow frame is followed by four times as long for input", async () => {
  await rest(page);
  await page.evaluate((ms) => { window.slow_ms = ms; window.frames.length = 0; }, FRAME_MS);
  const from = traffic.packets.length;
  await press(page, "y_plus");
  await page.waitForFunction(() => window.frames.length > 3);
  await page.evaluate(() => { window.held = window.frames.slice(1); });
  await page.mouse.up();
  const held = await page.evaluate(() => window.held);
  assert.ok(held.length > 1, `${held.length} frames`);
  for (const [n, at] of held.slice(1).entries()) assert.ok(at - held[n] >= 5 * FRAME_MS - 1, `${at - held[n]} ms between two frames`);
  await page.evaluate(() => { window.slow_ms = 0; });
  await rest(page);
  assert.deepEqual(new Set(traffic.jogs(from).map((it) => it.text)), new Set(["linear 3", "linear 0"]));
});

test("after two interrupted holds the stage is flat, and says why", async () => {
  await reload();
  await bench.setDeadMan();
  for (const axis of ["y_minus", "y_plus"]) {
    assert.equal(await page.getAttribute("#stage", "data-shown"), "3d");
    await rest(page);
    await passed(page, 0.4);
    await press(page, axis);
    await moved(page, "y_mm", 3);
    await page.evaluate(() => { const until = performance.now() + 1500; while (performance.now() < until); });
    await page.waitForFunction(() => document.querySelector("#jog-why").dataset.tone === "bad");
    await page.mouse.up();
  }
  await isFlat();
  await bench.setDeadMan(1);
});

test("after two slow frames while a button is held the stage is flat, and the hold goes on", async () => {
  await reload();
  await page.evaluate((ms) => { window.slow_ms = ms; }, SLOW_FRAME_MS);
  // The frames are slow enough: a busy machine may add to them.
  await bench.setDeadMan(2);
  const from = traffic.packets.length;
  // From before the press: on a busy machine the arm may be at the end of its reach when the stage is flat.
  const hasMoved = moved(page, "y_mm", 5);
  await press(page, "y_minus");
  await isFlat();
  await hasMoved;
  await passed(page, 0.5);
  assert.deepEqual(new Set(traffic.jogs(from).map((it) => it.text)), new Set(["linear 4"]));
  await page.mouse.up();
  await bench.setDeadMan(1);
});
