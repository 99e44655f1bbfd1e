// Measures how long it takes from a pointer on a jog button to the packet at the arm, and from its release to the packet that
// stops it; what a first and a second visit cost, also over a slow line; and the longest task of a visit, also on a slow computer.
// `npm run latency --prefix page`.
import { loadavg } from "node:os";
import { moved, open, rest, takeControl } from "./bench.mjs";
import { launch, leave, visitor } from "./browser.mjs";

const PRESSES = 100;

/** The value below which this share of them is. */
const below = (values, share) => values.toSorted((a, b) => a - b)[Math.min(values.length - 1, Math.floor(values.length * share))];
const row = (name, values) => console.log(`${name}: median ${below(values, 0.5).toFixed(0)} ms, p99 ${below(values, 0.99).toFixed(0)} ms, at most ${Math.max(...values).toFixed(0)} ms (${values.length} times)`);

const bench = await open();
const { page, traffic } = bench;
const paint = await page.evaluate(async () => {
  await new Promise((done) => setTimeout(done, 1500));
  const [document] = performance.getEntriesByType("navigation");
  const files = performance.getEntriesByType("resource").filter((it) => !it.name.includes("/api/"));
  return { first_ms: performance.getEntriesByName("first-contentful-paint")[0]?.startTime, bytes: [document, ...files].reduce((sum, it) => sum + it.transferSize, 0), files: files.length + 1 };
});
console.log(`first contentful paint ${paint.first_ms?.toFixed(0)} ms; ${(paint.bytes / 1e6).toFixed(2)} MB in ${paint.files} files`);

/** 1.5 Mbit/s and 150 ms. */
const LINE = { offline: false, latency: 150, downloadThroughput: 1.5e6 / 8, uploadThroughput: 1.5e6 / 8 };
const browser = await launch();
const slow = await (await visitor(browser)).newPage();
const client = await slow.context().newCDPSession(slow);
await client.send("Network.enable");
await client.send("Network.emulateNetworkConditions", LINE);
for (const name of ["first", "second"]) {
  let bytes = 0;
  const count = ({ encodedDataLength }) => (bytes += encodedDataLength);
  client.on("Network.loadingFinished", count);
  await slow.goto(bench.url);
  await slow.waitForFunction(() => document.querySelector("[data-pose=x_mm]")?.textContent !== "–");
  const [stop_ms, page_ms] = await slow.evaluate(() => [performance.getEntriesByName("stop works")[0].startTime, performance.now()]);
  console.log(`${name} visit at 1.5 Mbit/s, 150 ms: STOP after ${(stop_ms / 1000).toFixed(1)} s, page after ${(page_ms / 1000).toFixed(1)} s, ${(bytes / 1000).toFixed(0)} kB`);
  client.off("Network.loadingFinished", count);
}

/** Keeps how long each task of the page takes, in ms. */
function keepTasks() {
  window.tasks = [];
  new PerformanceObserver((list) => window.tasks.push(...list.getEntries().map(({ duration }) => duration))).observe({ type: "longtask", buffered: true });
}

for (const webgl of [false, true]) {
  for (const rate of [1, 4]) {
    const context = await visitor(browser, { webgl });
    await context.addInitScript(keepTasks);
    const page = await context.newPage();
    await (await context.newCDPSession(page)).send("Emulation.setCPUThrottlingRate", { rate });
    await page.goto(bench.url);
    await page.waitForFunction(() => document.querySelector("[data-pose=x_mm]")?.textContent !== "–");
    if (webgl) await page.waitForSelector("#stage[data-shown='3d']");
    const tasks = await page.evaluate(() => window.tasks);
    console.log(`first visit, ${webgl ? "3-D" : "flat"}, ${rate} times as slow: longest task ${Math.max(0, ...tasks).toFixed(0)} ms, over 200 ms: ${tasks.filter((ms) => ms > 200).length}; load ${loadavg()[0].toFixed(0)}`);
    await context.close();
  }
}
await leave(browser);

await takeControl(page);
await rest(page);
const down = [], up = [];
for (let press = 0; press < PRESSES; press += 1) {
  // A press while the arm runs down waits until it rests: that is the arm's time, not the page's.
  await page.waitForTimeout(500);
  await page.hover(`[data-axis=${press % 2 ? "y_minus" : "y_plus"}]`);
  let from = traffic.packets.length;
  const pressed = performance.now();
  await page.mouse.down();
  await moved(page, "y_mm", 0.5);
  down.push(traffic.jogs(from).find((it) => it.text !== "linear 0").at - pressed);
  from = traffic.packets.length;
  const released = performance.now();
  await page.mouse.up();
  await rest(page);
  up.push(traffic.jogs(from).find((it) => it.text === "linear 0").at - released);
}
row("pointer down to jog packet", down);
row("release to stop packet", up);
await bench.end();
