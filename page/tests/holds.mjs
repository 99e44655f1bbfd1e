// Counts held buttons that end before they are released, on a slow computer without a graphics card, and measures how long a page
// that hangs keeps a button pressed. `npm run holds --prefix page`; HOLDS is how many of each kind, RATES how many times as slow as
// this computer the page's thread is made.
import { loadavg } from "node:os";
import { isJog, open, passed, press, rest, takeControl } from "./bench.mjs";

const HOLDS = Number(process.env.HOLDS ?? 100), HANGS = Math.min(HOLDS, 20);
const RATES = (process.env.RATES ?? "1,6").split(",").map(Number);
const HOLD_MS = 1500, HANG_MS = 1000;

const isRelease = ({ floats: [state, axis] }) => (state === 2 || state === 7) && axis === 0;
const load = () => loadavg()[0].toFixed(0);

/** Keeps how long the page's thread was silent at most in each hold: what ends a hold in spite of less is the machine, not the page. */
function listen() {
  window.silences = {};
  let last = null;
  const { postMessage } = Worker.prototype;
  Worker.prototype.postMessage = function (message) {
    const number = message.hold?.number ?? message.beat, now = performance.now();
    if (number !== undefined) window.silences[number] = Math.max(window.silences[number] ?? 0, last?.number === number ? now - last.at : 0);
    last = number === undefined ? null : { number, at: now };
    return postMessage.call(this, message);
  };
}

/** Presses a jog button, to and fro; returns the index of its packet. */
async function begin({ page, traffic }, n) {
  await rest(page);
  await passed(page, 0.4);
  const from = traffic.packets.length;
  await press(page, n % 2 ? "y_minus" : "y_plus");
  return traffic.packets.indexOf(await traffic.next(from, isJog));
}

/** Holds a button as often as wished; returns how many holds ended too early, by what they reported. */
async function interrupted(bench) {
  const { page, traffic } = bench;
  const reasons = {};
  for (let n = 0; n < HOLDS; n += 1) {
    const from = await begin(bench, n);
    await page.waitForTimeout(HOLD_MS);
    const ended = traffic.packets.slice(from).some(isRelease);
    await page.mouse.up();
    if (!ended) continue;
    const why = (await page.textContent("#jog-why")).replace(/^Y.: /, "") || "no reason";
    reasons[why] = (reasons[why] ?? 0) + 1;
  }
  return reasons;
}

/** How long the arm keeps its button after the page hangs, in ms. */
async function hang(bench) {
  const { page, traffic } = bench;
  const took = [];
  for (let n = 0; n < HANGS; n += 1) {
    const from = await begin(bench, n);
    await passed(page, 0.3);
    const hung = performance.now();
    await page.evaluate((ms) => { const until = performance.now() + ms; while (performance.now() < until); }, HANG_MS);
    took.push((await traffic.next(from, isRelease)).at - hung);
    await page.mouse.up();
  }
  return took.sort((a, b) => a - b).map(Math.round);
}

for (const webgl of [true, false]) {
  for (const rate of RATES) {
    const bench = await open({ webgl, scripts: listen });
    const { page } = bench;
    await takeControl(page);
    if (webgl) await page.waitForSelector("#stage[data-shown='3d']");
    const session = await page.context().newCDPSession(page);
    await session.send("Emulation.setCPUThrottlingRate", { rate });
    await bench.setDeadMan();
    const before = load();
    const reasons = await interrupted(bench);
    const count = Object.values(reasons).reduce((sum, n) => sum + n, 0);
    const silences = Object.values(await page.evaluate(() => window.silences)).sort((a, b) => a - b);
    const shown = await page.getAttribute("#stage", "data-shown");
    console.log(`${webgl ? "3-D" : "flat"}, ${rate} times as slow: ${count} of ${HOLDS} holds of ${HOLD_MS / 1000} s interrupted ${JSON.stringify(reasons)}; ${webgl && shown === "2d" ? "became flat; " : ""}page's thread silent for at most ${silences[Math.floor(silences.length / 2)].toFixed(0)} ms (median), ${silences.at(-1).toFixed(0)} ms (worst); load ${before} to ${load()}`);
    if (rate === 1 && !webgl) {
      const took = await hang(bench);
      console.log(`a page that hangs releases its button after ${took[Math.floor(took.length / 2)]} ms (median), ${took.at(-1)} ms (most of ${took.length})`);
    }
    await bench.end();
  }
}
