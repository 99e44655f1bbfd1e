// Measures how a program of 10,000 steps scrolls and edits, and how long it takes to undo 1,000 changes.
// `npm run long --prefix page`.
import { open } from "./bench.mjs";

const STEPS = 10_000, CHANGES = 1000;
const bench = await open({ webgl: true });
const { page } = bench;
const text = `title = "long"\n\n${Array.from({ length: STEPS }, (_, n) => `[[steps]]\ngo = { x = ${200 + (n % 40)}, y = ${(n % 120) - 60}, z = 20 }\npath = "movl"\n`).join("\n")}`;
await page.click("#tab-teach");
await page.setInputFiles("#teach-file", { name: "long.toml", mimeType: "text/plain", buffer: Buffer.from(text) });
await page.waitForFunction(() => document.querySelector("#teach-once") && document.querySelector("#step-0 .time")?.textContent, undefined, { timeout: 120_000 });

/** Does something in each picture, and tells from picture to picture how long it took. */
const measure = (what, count) => page.evaluate(async ([what, count]) => {
  const list = document.querySelector("#steps"), frames = [];
  const does = {
    nothing() {},
    scroll: () => (list.scrollTop += 170),
    choose: (n) => document.querySelector(`#step-${Number(list.querySelector("[data-row]").dataset.row) + (n % 20)}`).click(),
    undo: () => document.querySelector("#teach-undo").click(),
    redo: () => document.querySelector("#teach-redo").click(),
  };
  let last = await new Promise(requestAnimationFrame);
  for (let n = 0; n < count; n += 1) {
    does[what](n);
    const now = await new Promise(requestAnimationFrame);
    frames.push(now - last);
    last = now;
  }
  frames.sort((a, b) => a - b);
  return { median: frames[count >> 1], most: frames[Math.floor(count * 0.99)], all_s: frames.reduce((sum, it) => sum + it, 0) / 1000 };
}, [what, count]);
const told = (name, { median, most, all_s }) => console.log(`${name}: picture to picture median ${median.toFixed(1)} ms, p99 ${most.toFixed(1)} ms; ${all_s.toFixed(1)} s in all`);

await page.waitForTimeout(2000);
told("nothing done", await measure("nothing", 200));
told("scrolled through", await measure("scroll", 300));
told("steps chosen", await measure("choose", 200));

// A change by the keyboard, until the table shows it: through the station, which writes the text.
const took = [];
await page.evaluate(() => (document.querySelector("#steps").scrollTop = 0));
await page.click("#step-3");
for (let n = 0; n < 20; n += 1) {
  const before = await page.textContent("#step-3 .says");
  const at = performance.now();
  await page.keyboard.press(n % 2 ? "Alt+ArrowUp" : "Alt+ArrowDown");
  await page.waitForFunction((before) => document.querySelector("#step-3 .says").textContent !== before, before);
  took.push(performance.now() - at);
  await page.waitForFunction((row) => document.activeElement?.id === `step-${row}`, n % 2 ? 3 : 4);
}
took.sort((a, b) => a - b);
console.log(`a step moved: seen after ${took[10].toFixed(0)} ms in the middle, ${took[19].toFixed(0)} ms at most`);

// As many changes as can be undone, typed into the text.
await page.check("[name=teach-mode][value=text]", { force: true });
await page.waitForSelector("#teach-text");
await page.evaluate(async (count) => {
  const area = document.querySelector("#teach-text");
  const { value } = area;
  for (let n = 0; n < count; n += 1) {
    area.value = value.replace('"long"', `"long ${n}"`);
    area.dispatchEvent(new Event("input"));
    if (n % 50 === 0) await new Promise(requestAnimationFrame);
  }
}, CHANGES);
await page.check("[name=teach-mode][value=table]", { force: true });
await page.waitForSelector("#step-0");
told(`${CHANGES} changes undone`, await measure("undo", CHANGES));
told(`${CHANGES} changes done again`, await measure("redo", CHANGES));
const memory_mb = await page.evaluate(() => performance.memory.usedJSHeapSize / 1e6);
console.log(`heap of the page: ${memory_mb.toFixed(0)} MB`);
await bench.end();
