import { open, takeControl, press, rest } from "./bench.mjs";
const THROTTLE = Number(process.env.THROTTLE ?? 1), HOLDS = Number(process.env.HOLDS ?? 8), WEBGL = process.env.WEBGL !== "0";
const bench = await open({ webgl: WEBGL, patient: false, scripts: [() => {
  window.long = []; new PerformanceObserver((l) => { for (const e of l.getEntries()) window.long.push([Math.round(e.startTime), Math.round(e.duration)]); }).observe({ type: "longtask", buffered: true });
}] });
const { page } = bench;
const c = await page.context().newCDPSession(page);
await page.waitForTimeout(6000);
console.log("load longtasks", JSON.stringify(await page.evaluate(() => window.long)), await page.evaluate(() => document.getElementById("stage").dataset.shown));
await takeControl(page);
if (THROTTLE > 1) await c.send("Emulation.setCPUThrottlingRate", { rate: THROTTLE });
let cut = 0;
await page.evaluate(() => { window.long.length = 0; });
for (let n = 0; n < HOLDS; n++) {
  await rest(page);
  const box = await page.locator(`[data-axis=${n % 2 ? "y_minus" : "y_plus"}]`).boundingBox();
  await page.mouse.move(box.x + 20, box.y + 20);
  await page.mouse.down();
  await new Promise((r) => setTimeout(r, 1500));
  const why = await page.evaluate(() => [document.querySelector("#jog-why").dataset.tone, document.querySelector(".is-held")?.dataset.axis]);
  if (!why[1]) cut++;
  await page.mouse.up();
  await new Promise((r) => setTimeout(r, 300));
}
const long = await page.evaluate(() => window.long);
console.log(`throttle ${THROTTLE} webgl ${WEBGL}: cut ${cut} of ${HOLDS}; long tasks ${long.length}, max ${Math.max(0, ...long.map((l) => l[1]))}`, await page.evaluate(() => document.getElementById("stage").dataset.shown), long.map((l) => l[1]).sort((a, b) => b - a).slice(0, 20).join(" "));
await bench.end();
