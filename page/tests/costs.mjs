// Prints what the page costs and how many clicks the main tasks take, as Markdown tables. `npm run costs --prefix page`.
import { execFile } from "node:child_process";
import { promisify } from "node:util";
import { moved, open, press, rest, takeControl } from "./bench.mjs";

const IDLE_MS = 5000;

/** Share of a core that the page's thread uses while something happens. */
async function share(session, action) {
  const busy = async () => (await session.send("Performance.getMetrics")).metrics.find(({ name }) => name === "TaskDuration").value;
  const [began, from] = [performance.now(), await busy()];
  await action();
  return (100 * (await busy() - from)) / ((performance.now() - began) / 1000);
}

async function measure(webgl) {
  const bench = await open({ webgl, scripts: () => {
    window.longest_ms = 0;
    new PerformanceObserver((list) => list.getEntries().forEach(({ duration }) => (window.longest_ms = Math.max(window.longest_ms, duration)))).observe({ type: "longtask", buffered: true });
  } });
  const { page } = bench;
  const loaded = await page.evaluate(() => {
    const files = performance.getEntriesByType("resource").filter(({ name }) => !name.includes("/api/"));
    return { ms: performance.now(), longest_ms: window.longest_ms, files: files.length, bytes: files.reduce((sum, { transferSize }) => sum + transferSize, 0) };
  });
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable");
  await takeControl(page);
  await rest(page);
  const idle = await share(session, () => page.waitForTimeout(IDLE_MS));
  const jogging = await share(session, async () => {
    await press(page, "y_plus");
    await moved(page, "y_mm", 30);
    await page.mouse.up();
  });
  await bench.end();
  return [`${(loaded.ms / 1000).toFixed(1)} s, longest task ${loaded.longest_ms.toFixed(0)} ms`, `${loaded.files}, ${(loaded.bytes / 1e6).toFixed(2)} MB`, `${idle.toFixed(0)} %`, `${jogging.toFixed(0)} %`];
}

const ROWS = ["first load", "files of a first load", "idle, of a core", "jogging, of a core"];
const [solid, flat] = [await measure(true), await measure(false)];
console.log("| | 3-D on the CPU | two flat views |\n|---|---|---|");
for (const [n, row] of ROWS.entries()) console.log(`| ${row} | ${solid[n]} | ${flat[n]} |`);

console.log("\n| task | clicks |\n|---|---|");
for (const file of ["clicks", "calibrate"]) {
  const path = new URL(`${file}.test.mjs`, import.meta.url).pathname;
  const { stdout } = await promisify(execFile)(process.execPath, ["--test", "--test-reporter=tap", path]).catch((failed) => failed);
  for (const [, task, clicks] of stdout.matchAll(/# clicks: (.+): (\d+)$/gm)) console.log(`| ${task} | ${clicks} |`);
}
