// STOP under stress: real fingers and a real mouse, judged by the packets to the arm. GESTURES says how many gestures, SEED
// which ones, and STOP_WITHIN_MS within what time of each press the arm has to have its packet: long enough for a busy machine, unless it is said.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { waitForAnswer, isJog, isStop, open, passed, pose, rest, serveFromDisk, takeControl } from "./bench.mjs";
import { gesture, hand, numbers, words } from "./gestures.mjs";

const { GESTURES = "60", SEED = "1", STOP_WITHIN_MS = "2000" } = process.env;

let bench, page, traffic, fingers;

before(async () => {
  bench = await open({ viewport: { width: 390, height: 844 }, options: { hasTouch: true, isMobile: true }, webgl: process.env.SOLID === "1", scripts: () => {
    // How long each press waits for the page, from when the browser has it.
    window.waited = [];
    addEventListener("pointerdown", ({ timeStamp, target }) => target.closest("#stop") && window.waited.push(performance.now() - timeStamp), true);
  } });
  ({ page, traffic } = bench);
  await takeControl(page);
  fingers = await hand(page);
});
after(async () => {
  assert.deepEqual(bench.errors, []);
  await bench.end();
});

/** A person has looked at the arm, and it may move again. */
async function clearStop() {
  if (!(await page.isVisible("#stopped"))) return;
  await waitForAnswer(page, "api/v1/state", ({ stop }) => stop?.at_rest);
  await fetch(new URL("api/v1/stop", bench.url), { method: "DELETE" });
  await page.waitForSelector("[data-axis=y_plus]:enabled");
  await rest(page);
}

/** Makes a gesture on STOP, and tells how long after the press the arm had its packet; nothing where it got none. */
async function stopBy(it) {
  // A stopped arm is told to stop by each press all the same, but no button moves it.
  if (it.rests?.includes("data-axis")) await clearStop();
  const resting = it.rests ? await fingers.rest(it.rests) : [];
  if (it.rests?.includes("data-axis")) await traffic.next(traffic.packets.length, isJog);
  const from = traffic.packets.length;
  const stopped = () => traffic.next(from, isStop);
  const pressed = await fingers.press("#stop", it, resting, stopped);
  const packet = await stopped();
  if (!packet) return undefined;
  await page.waitForSelector("#stopped");
  return packet.at - pressed;
}

/** One finger in the middle of the button, lifted at once. */
const TAP = { by: "finger", fingers: 1, rests: null, at: [0.5, 0.5], way: [0, 0], lasts: "tap" };
const PRESSES = {
  "a tap": {},
  "a finger that stays": { lasts: "until it stops" },
  "a finger that moves by 20 px": { way: [20, 0], lasts: "until it stops" },
  "a finger that slides off": { way: [0, -40], lasts: "until it stops" },
  "a second finger while another one holds a jog button": { rests: "[data-axis=y_plus]" },
  "a flat hand while another finger holds a jog button": { rests: "[data-axis=y_plus]", fingers: 3, lasts: "until it stops" },
  "a second finger while another one is on the picture": { rests: "#stage", lasts: "until it stops" },
  "a flat hand": { fingers: 3, lasts: "until it stops" },
  "a mouse that stays": { by: "mouse", lasts: "until it stops" },
  "a mouse that slips off": { by: "mouse", way: [0, -40], lasts: "until it stops" },
};
for (const [name, other] of Object.entries(PRESSES)) {
  test(`${name} stops the arm`, async () => {
    const took_ms = await stopBy({ ...TAP, ...other });
    // One that stops by being lifted is lifted after `traffic.next` has given up.
    assert.ok(took_ms < 5000, `${took_ms} ms`);
  });
}

test("a press and its release stop once, and so does a key on the button", async () => {
  await page.evaluate(() => {
    window.stops = 0;
    const { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (message) {
      if (message.text && JSON.parse(message.text).request.type === "stop") window.stops += 1;
      return postMessage.call(this, message);
    };
  });
  const sent = () => page.evaluate(() => window.stops);
  await stopBy(TAP);
  assert.equal(await sent(), 1);
  // A finger that slides off leaves no press behind that a key could be taken for.
  await stopBy({ ...TAP, way: [0, -40] });
  assert.equal(await sent(), 2);
  await page.focus("#stop");
  await page.keyboard.press("Enter");
  assert.equal(await sent(), 3);
});

test(`each of ${GESTURES} random presses stops the arm within ${STOP_WITHIN_MS} ms`, async (t) => {
  const random = numbers(Number(SEED)), took = [], missed = [];
  for (let n = 0; n < Number(GESTURES); n += 1) {
    // To and fro, so that the arm comes to no limit.
    const it = gesture(random, [`[data-axis=${(await pose(page, "y_mm")) > 0 ? "y_minus" : "y_plus"}]`, "#stage"]);
    if (n === 0) await page.evaluate(() => (window.waited.length = 0));
    const ms = await stopBy(it);
    if (ms !== undefined) took.push(ms);
    if (ms === undefined || ms > Number(STOP_WITHIN_MS)) missed.push(`${n}: ${words(it)}: ${ms === undefined ? "never" : `${ms.toFixed(0)} ms`}`);
  }
  const waited = await page.evaluate(() => window.waited);
  for (const [name, all] of [["from press to packet", took], ["of that until the page has it", waited]]) {
    all.sort((a, b) => a - b);
    const at = (share) => all[Math.floor((all.length - 1) * share)]?.toFixed(0);
    t.diagnostic(`${name}: median ${at(0.5)} ms, p99 ${at(0.99)} ms, at most ${at(1)} ms; ${all.filter((ms) => ms <= 30).length} of ${all.length} within 30 ms`);
  }
  assert.deepEqual(missed, []);
});

test("STOP works before the page is loaded, by pointer and by key", async () => {
  for (const press of [(early) => early.click("#stop"), (early) => early.keyboard.press("Escape")]) {
    const context = await page.context().browser().newContext();
    await serveFromDisk(context, bench.url);
    // The rest of the page never comes.
    await context.route("**/app.js", () => {});
    const early = await context.newPage();
    await early.goto(bench.url, { waitUntil: "commit" });
    while (!(await bench.ask("api/v1/state")).stop) {
      await press(early);
      await passed(page, 0.2);
    }
    await context.close();
    await page.waitForSelector("#stopped");
    await clearStop();
  }
});
