// Failures around the page: it stays usable and reports them, and nothing moves unless it is held.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { isStop, moved, open, pose, press, rest, takeControl, passed } from "./bench.mjs";

let bench, page, traffic;

before(async () => {
  bench = await open();
  ({ page, traffic } = bench);
  await takeControl(page);
});
after(() => bench.end());
afterEach(async () => {
  bench.slow(0);
  bench.mend();
  assert.deepEqual(bench.errors, []);
});

const RELEASED = "linear 0";

test("on a slow network the arm follows with a delay, and stops after the release", async () => {
  bench.slow(200);
  await press(page, "y_plus");
  await moved(page, "y_mm", 5);
  const released = performance.now();
  await page.mouse.up();
  const stops = () => traffic.jogs().find((it) => it.at > released && it.text === RELEASED);
  while (!stops()) await page.evaluate(() => new Promise(requestAnimationFrame));
  // What is on its way moves the arm; what comes after the release does not.
  assert.ok(stops().at - released < 500, `${stops().at - released} ms`);
  await rest(page);
  const y_mm = await pose(page, "y_mm");
  assert.equal(traffic.jogs().at(-1).text, RELEASED);
  assert.equal(await pose(page, "y_mm"), y_mm);
});

test("one of two pages has control; the other shows the lease holder, and gets control when it is granted", async () => {
  const other = await bench.visit({ viewport: { width: 1024, height: 768 } });
  await other.waitForFunction(() => document.querySelector("#jog-why").textContent.includes("Another client has control"));
  assert.equal(await other.isDisabled("[data-axis=y_plus]"), true);
  assert.equal(await other.isVisible("#take"), false);
  await other.click("#ask");
  await page.click(".give");
  await other.waitForFunction(() => document.querySelector("#holder").textContent === "You have control.");
  await page.waitForFunction(() => document.querySelector("[data-axis=y_plus]").disabled);
  const from = traffic.packets.length;
  await press(other, "y_minus");
  await moved(other, "y_mm", 4);
  // Anybody stops, also without control.
  await page.keyboard.press("Escape");
  await page.waitForSelector("#stopped");
  await other.mouse.up();
  // The laser goes off first, then the button is let go, by the line's own time.
  await passed(page, 0.4);
  assert.equal(traffic.jogs(from).at(-1).text, RELEASED);
  await page.click("#reset");
  await page.click("#confirm-yes");
  await other.context().close();
  await page.click("#take");
  await page.waitForFunction(() => document.querySelector("#holder").textContent === "You have control.");
});

test("a condition that blocks the arm has its button beside it", async () => {
  const other = await bench.visit({ viewport: { width: 1130, height: 640 } });
  await other.click("#jog-why [data-remedy=others_control]");
  await page.click(".give");
  await other.waitForFunction(() => document.querySelector("#holder").textContent === "You have control.");
  await other.keyboard.press("Escape");
  await other.click("#jog-why [data-remedy=stopped]");
  await other.click("#confirm-yes");
  await other.waitForSelector("#stopped", { state: "detached" });
  await other.context().close();
});

test("a station killed while a button is held stops the arm, and the page reports it and continues with the next station", async () => {
  await page.waitForFunction(() => !document.querySelector("[data-axis=y_plus]").disabled);
  await press(page, "y_plus");
  await moved(page, "y_mm", 4);
  const killed = performance.now();
  await bench.restart();
  await page.waitForFunction(() => document.querySelector("#jog-why").textContent.startsWith("The pose is not confirmed.") || !document.querySelector("[data-axis=y_plus]").disabled);
  await page.mouse.up();
  const later = traffic.jogs().filter((it) => it.at > killed).map((it) => it.text);
  // The watchdog lets go; the button that was still held presses nothing.
  assert.ok(later.length > 0 && later.every((it) => it.endsWith(" 0")), later.join());
  await rest(page);
  if (await page.isVisible("#confirm-pose")) {
    await page.click("#confirm-pose");
    await page.click("#confirm-yes");
  }
  // A new press is a new press, and takes control where nobody has it.
  await page.waitForFunction(() => !document.querySelector("[data-axis=y_minus]").disabled);
  await press(page, "y_minus");
  await moved(page, "y_mm", 4);
  await page.mouse.up();
  await rest(page);
});

test("an unanswered STOP is shown in red beside it and sent again, and its answer is shown when it arrives", async () => {
  const stop = await page.locator("#stop").boundingBox();
  bench.cut();
  await page.mouse.move(stop.x + stop.width / 2, stop.y + stop.height / 2);
  await page.mouse.down();
  await page.waitForSelector("#late-stop[data-tone=bad]");
  assert.equal(await page.textContent("#late-stop"), "No answer to STOP. Switch the arm off.");
  await page.mouse.up();
  // What appears moves nothing that a hand is on.
  assert.deepEqual(await page.locator("#stop").boundingBox(), stop);
  await page.waitForSelector("#link-chip[data-tone=off]");
  const from = traffic.packets.length;
  bench.mend();
  assert.ok(await traffic.next(from, isStop), "the arm is stopped once the network is back");
  await page.waitForSelector("#late-stop[data-tone=good]");
  assert.match(await page.textContent("#late-stop"), /^STOP was answered after \d+ s\.$/);
  // The page is back on a connection of its own making, without being told of the end of the other one.
  await page.waitForSelector("#link-chip[data-tone=good]");
  await page.waitForSelector("#reset:enabled");
  await page.click("#reset");
  await page.click("#confirm-yes");
  await page.waitForSelector("#late-stop", { state: "detached" });
});

test("a page that receives nothing for 2 s reconnects, while its connection is still open", async () => {
  await page.waitForSelector("#link-chip[data-tone=good]");
  await page.evaluate(() => {
    const { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (message) {
      if (message.open) window.opened = true;
      return postMessage.call(this, message);
    };
  });
  bench.cut();
  await page.waitForFunction(() => window.opened);
  await page.waitForSelector("#link-chip[data-tone=off]");
  assert.equal(await page.textContent("#link-chip"), "not connected to station");
  bench.mend();
  await page.waitForSelector("#link-chip[data-tone=good]");
});

test("a page that lost its station shows the age of its picture", async () => {
  bench.slow(60_000);
  await page.waitForFunction(() => document.querySelector("#stage").classList.contains("is-old"));
  await page.waitForSelector("#old");
  assert.match(await page.textContent("#old"), /This view is \d+ s old/);
});

test("a condition that blocks the arm has its button beside it", async () => {
  const other = await bench.visit({ viewport: { width: 1130, height: 640 } });
  // It may be reconnecting since the last test.
  await page.waitForSelector("#link-chip[data-tone=good]");
  await page.waitForSelector("#take, #release");
  if (await page.isVisible("#take")) await page.click("#take");
  await other.click("#jog-why [data-remedy=others_control]");
  await page.click(".give");
  await other.waitForFunction(() => document.querySelector("#holder").textContent === "You have control.");
  await other.keyboard.press("Escape");
  await other.click("#jog-why [data-remedy=stopped]");
  await other.click("#confirm-yes");
  await other.waitForSelector("#stopped", { state: "detached" });
  await other.context().close();
});
