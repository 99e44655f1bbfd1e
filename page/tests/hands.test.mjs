// The jog buttons with a real pointer in a real browser, judged by the packets to the arm.
import assert from "node:assert/strict";
import { after, afterEach, before, beforeEach, test } from "node:test";
import { buttonAt, moved, open, passed, pose, press, rest, takeControl } from "./bench.mjs";

// As the buttons are numbered in the protocol.
const AXES = { x_plus: "linear 1", x_minus: "linear 2", y_plus: "linear 3", y_minus: "linear 4", z_plus: "linear 5", z_minus: "linear 6" };
const RELEASED = "linear 0";

let bench, page, traffic, from;

before(async () => {
  bench = await open();
  ({ page, traffic } = bench);
  await takeControl(page);
});
after(() => bench.end());
beforeEach(async () => {
  await rest(page);
  from = traffic.packets.length;
});
afterEach(async () => {
  await page.mouse.up();
  await rest(page);
  assert.deepEqual(bench.errors, []);
});

/** The presses since the test began, without those that follow their like. A release is said more than once, and may be from before. */
function toldOfButtons() {
  const all = traffic.jogs(from).map((it) => it.text);
  const texts = all.slice(all.findIndex((text) => text !== RELEASED));
  return texts.filter((text, index) => text !== texts[index - 1]);
}

test("each pressed button moves the arm for as long as it is held, also the first time after another one", async () => {
  for (const [axis, name] of [["y_minus", "y_mm"], ["x_minus", "x_mm"], ["z_plus", "z_mm"], ["y_plus", "y_mm"]]) {
    from = traffic.packets.length;
    await press(page, axis);
    await moved(page, name, 8);
    await page.mouse.up();
    await rest(page);
    assert.deepEqual(toldOfButtons(), [AXES[axis], RELEASED], axis);
  }
});

test("an immediate second press and a quick reversal are accepted, and both move the arm", async () => {
  await press(page, "y_plus");
  await moved(page, "y_mm", 8);
  await page.mouse.up();
  await page.mouse.down();
  await moved(page, "y_mm", 8);
  await page.mouse.up();
  const far = await pose(page, "y_mm");
  await press(page, "y_minus");
  await page.waitForFunction((far) => Number(document.querySelector("[data-pose=y_mm]").textContent) < far - 8, far);
  await page.mouse.up();
  await rest(page);
  assert.deepEqual(toldOfButtons(), [AXES.y_plus, RELEASED, AXES.y_plus, RELEASED, AXES.y_minus, RELEASED]);
  assert.equal(await page.isVisible("#problem"), false);
});

test("at a limit the button is released once, and the reason is shown beside it", async () => {
  const box = await page.locator("[data-axis=z_minus]:visible").boundingBox();
  await press(page, "z_minus");
  await page.waitForFunction(() => document.querySelector("#jog-why").textContent.includes("table"), undefined, { timeout: 20_000 });
  await rest(page);
  const stood = await pose(page, "z_mm");
  // Still held: the arm stays, and so does everything under the pointer.
  await passed(page, 1.5);
  assert.equal(await pose(page, "z_mm"), stood);
  assert.equal(await buttonAt(page, box), "z_minus");
  assert.match(await page.textContent("#jog-why"), /^Z−: .*Jog slower/);
  assert.equal(await page.isVisible("#problem"), false);
  await page.mouse.up();
  assert.deepEqual(toldOfButtons(), [AXES.z_minus, RELEASED]);
});

test("a page that is blocked for 3 s releases at once, and does not move the arm again when it wakes", async () => {
  await bench.setDeadMan();
  await press(page, "y_plus");
  await moved(page, "y_mm", 5);
  const blocked = performance.now();
  await page.evaluate(() => { const until = Date.now() + 3000; while (Date.now() < until); });
  const jogs = traffic.jogs(from);
  const released = jogs.find((it) => it.text === RELEASED);
  assert.ok(released.at - blocked < 400, `released ${released.at - blocked} ms after it was blocked`);
  await page.waitForFunction(() => document.querySelector("#jog-why").textContent.includes("did not respond"));
  await rest(page);
  assert.deepEqual(toldOfButtons(), [AXES.y_plus, RELEASED]);
  await bench.setDeadMan(1);
  // A new press is a new press.
  await page.mouse.up();
  await page.mouse.down();
  await moved(page, "y_mm", 3);
});

test("a window that loses the focus and a hidden tab release the button", async () => {
  await press(page, "x_plus");
  await moved(page, "x_mm", 3);
  await page.evaluate(() => window.dispatchEvent(new Event("blur")));
  await rest(page);
  assert.deepEqual(toldOfButtons(), [AXES.x_plus, RELEASED]);
});

test("a page that is hidden, navigates away or is closed releases its button at once, without waiting for the dead-man time", async () => {
  const ways = {
    // No page of a browser without a screen is ever hidden, so that it has to be told.
    hidden: (it) => it.evaluate(() => document.dispatchEvent(new Event("visibilitychange"))),
    "another address": (it) => it.goto("about:blank"),
    closed: (it) => it.close(),
  };
  for (const [name, leave] of Object.entries(ways)) {
    if (await page.isVisible("#release")) await page.click("#release");
    await page.waitForSelector("#take");
    const other = await bench.visit();
    await other.click("#take");
    await other.waitForSelector("[data-axis=y_plus]:enabled");
    await press(other, "y_plus");
    await moved(other, "y_mm", 3);
    const [left, before] = [performance.now(), traffic.packets.length];
    await leave(other);
    const { at } = await traffic.next(before, ({ floats: [state, axis] }) => state === 7 && axis === 0);
    assert.ok(at - left < 900, `${name}: ${at - left} ms, and the dead-man time is 1 s`);
    await other.context().close();
  }
  await page.click("#take");
  await page.waitForSelector("[data-axis=y_plus]:enabled");
});

test("an unrelated error does not move the layout under the pointer", async () => {
  // So tall that nothing has to be scrolled.
  await page.setViewportSize({ width: 1130, height: 1800 });
  await page.click("#voice > summary");
  await page.click("#say-text");
  const box = await page.locator("[data-axis=y_minus]:visible").boundingBox();
  await page.fill("#say-text", "dance");
  await page.press("#say-text", "Enter");
  await page.waitForSelector("#problem:visible");
  assert.deepEqual(await page.locator("[data-axis=y_minus]:visible").boundingBox(), box);
  assert.equal(await buttonAt(page, box), "y_minus");
  await page.click("#problem-close");
});

test("a mouse that slides off a held button by more than 20 px releases it, and does not press it again on the way back", async () => {
  const { x, y, width, height } = await page.locator("[data-axis=y_plus]:visible").boundingBox();
  await press(page, "y_plus");
  await moved(page, "y_mm", 3);
  await page.mouse.move(x - 15, y + height / 2);
  await moved(page, "y_mm", 3);
  await page.mouse.move(x - 25, y + height / 2, { steps: 3 });
  await rest(page);
  await page.mouse.move(x + width / 2, y + height / 2, { steps: 3 });
  await passed(page, 0.5);
  assert.deepEqual(toldOfButtons(), [AXES.y_plus, RELEASED]);
});

test("a press while the arm brakes says that it waits, and one that is too short says that nothing moved", async () => {
  await page.fill("#speed", "100");
  await press(page, "y_minus");
  await moved(page, "y_mm", 15);
  await page.mouse.up();
  await page.mouse.down();
  await page.waitForFunction(() => document.querySelector("#jog-why").textContent.includes("still braking"));
  await page.mouse.up();
  await page.waitForFunction(() => document.querySelector("#jog-why").textContent.includes("nothing moved"));
  await rest(page);
  assert.deepEqual(toldOfButtons(), [AXES.y_minus, RELEASED]);
  await page.fill("#speed", "30");
});
