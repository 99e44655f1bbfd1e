// STOP under stress: real fingers and a real mouse, judged by the packets to the arm. GESTURES says how many gestures, SEED
// which ones, SOLID=1 draws the arm in three dimensions, and STOP_WITHIN_MS says within what time of each press the arm has to have
// its packet: long enough for a busy machine, unless it is said.
import assert from "node:assert/strict";
import { loadavg } from "node:os";
import { after, before, test } from "node:test";
import { waitForAnswer, isJog, isStop, open, passed, pose, rest, serveFromDisk, takeControl } from "./bench.mjs";
import { gesture, hand, numbers, words } from "./gestures.mjs";

const { GESTURES = "60", SEED = "1", STOP_WITHIN_MS = "2000" } = process.env;

let bench, page, traffic, fingers;

before(async () => {
  bench = await open({ viewport: { width: 390, height: 844 }, options: { hasTouch: true, isMobile: true }, webgl: process.env.SOLID === "1" });
  ({ page, traffic } = bench);
  await takeControl(page);
  if (process.env.SOLID === "1") await page.waitForSelector("#stage[data-shown='3d']");
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

/** Waits until the packets of the last stop are all repeated and executed: until then, none is sent for another press, or one is that is no answer to it. */
async function settle() {
  await passed(page, 0.5);
  await waitForAnswer(page, "api/v1/state", ({ stop, queue }) => !stop || (stop.at_rest && queue.under_way === 0));
}

/**
 * Notes when the browser hands a press to the page. The driver's call is up to two frames earlier: it waits for a picture of the
 * page, which no finger does. The result ends it, and gives the times, as of `performance.now()`.
 */
async function notePresses() {
  const session = await page.context().browser().newBrowserCDPSession();
  const events = [];
  session.on("Tracing.dataCollected", ({ value }) => events.push(...value));
  await session.send("Tracing.start", { transferMode: "ReportEvents", traceConfig: { includedCategories: ["input"] } });
  return async () => {
    const complete = new Promise((done) => session.once("Tracing.tracingComplete", done));
    await session.send("Tracing.end");
    await complete;
    await session.detach();
    const isPress = ({ name, args }) => name === "InputRouterImpl::FilterAndSendWebInputEvent" && /^(TouchStart|MouseDown)$/.test(args.type);
    // The browser and this program have the same clock, from another beginning.
    const ahead_ms = Number(process.hrtime.bigint()) / 1e6 - performance.now();
    return events.filter(isPress).map(({ ts }) => ts / 1000 - ahead_ms).sort((a, b) => a - b);
  };
}

/** Makes a gesture on STOP, and tells when the driver began the press and when the arm had its packet; nothing where it got none. */
async function stopBy(it) {
  // A stopped arm is told to stop by each press all the same, but no button moves it.
  if (it.rests?.includes("data-axis")) await clearStop();
  await settle();
  const resting = it.rests ? await fingers.rest(it.rests) : [];
  if (it.rests?.includes("data-axis")) await traffic.next(traffic.packets.length, isJog);
  const from = traffic.packets.length;
  const stopped = () => traffic.next(from, isStop);
  const pressed = await fingers.press("#stop", it, resting, stopped);
  const packet = await stopped();
  if (!packet) return undefined;
  await page.waitForSelector("#stopped");
  return { pressed, stopped: packet.at };
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
    const { pressed, stopped } = await stopBy({ ...TAP, ...other });
    const took_ms = stopped - pressed;
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
  const random = numbers(Number(SEED)), gestures = [], times = await notePresses();
  for (let n = 0; n < Number(GESTURES); n += 1) {
    // To and fro, so that the arm comes to no limit.
    const it = gesture(random, [`[data-axis=${(await pose(page, "y_mm")) > 0 ? "y_minus" : "y_plus"}]`, "#stage"]);
    gestures.push({ it, ...(await stopBy(it)) });
  }
  const presses = await times();
  const all = gestures.map(({ it, pressed }, n) => {
    const press = presses.find((at) => at >= pressed);
    const packet = traffic.packets.find((it) => it.at >= press && isStop(it));
    return { text: `${n}: ${words(it)}`, ms: packet?.at - press };
  });
  const took = all.map(({ ms }) => ms).sort((a, b) => a - b);
  const at = (share) => took[Math.floor((took.length - 1) * share)]?.toFixed(0);
  t.diagnostic(`from press to packet: median ${at(0.5)} ms, p99 ${at(0.99)} ms, at most ${at(1)} ms; ${took.filter((ms) => ms <= 30).length} of ${all.length} within 30 ms; load ${loadavg()[0].toFixed(0)}`);
  assert.deepEqual(all.filter(({ ms }) => !(ms <= Number(STOP_WITHIN_MS))).map(({ text, ms }) => `${text}: ${ms.toFixed(0)} ms`), []);
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
