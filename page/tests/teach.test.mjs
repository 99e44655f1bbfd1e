// A program is shown to the arm on the page, and judged on where the arm goes.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, afterEach, before, beforeEach, test } from "node:test";
import { contents, open, passed, pose, rest, takeControl } from "./bench.mjs";

let bench, page, traffic, from;

before(async () => {
  bench = await open();
  ({ page, traffic } = bench);
  await takeControl(page);
});
after(() => bench.end());
beforeEach(async () => {
  await rest(page);
  await passed(page, 0.4);
  await page.click("#tab-teach");
  from = traffic.packets.length;
});
afterEach(() => assert.deepEqual(bench.errors, []));

const rows = () => page.locator(".step .says").allTextContents();
const count = (n) => page.waitForFunction((n) => document.querySelectorAll(".step").length === n, n);
const waitForText = (part) => page.waitForFunction((part) => document.querySelector("#panel").textContent.includes(part), part);
/** The Cartesian targets since the test began, in whole millimetres. */
const targets = () => traffic.targets(from).map((it) => it.map(Math.round));

const phase = async () => (await bench.ask("api/v1/state")).job?.phase;
/** Until the job is in one of these phases; none is `undefined`. */
async function until(...wanted) {
  while (!wanted.includes(await phase())) await passed(page, 0.1);
}

/** Moves the tip by ten millimetres, as a person does. */
async function step(axis, name, to) {
  await page.click("#tab-move");
  await page.check("[name=step][value='10']", { force: true });
  await page.click(`[data-axis=${axis}]`);
  await page.waitForFunction(([name, to]) => Math.abs(Number(document.querySelector(`[data-pose=${name}]`).textContent) - to) < 0.3, [name, to]);
  await rest(page);
  await passed(page, 0.4);
  await page.click("#tab-teach");
}

test("two points are captured and looped, and the arm goes back and forth until the program is ended", async () => {
  await page.click("#capture");
  await count(1);
  const y_mm = await pose(page, "y_mm");
  await step("y_plus", "y_mm", y_mm + 10);
  await page.click("#capture");
  await count(2);
  from = traffic.packets.length;
  await page.waitForFunction(() => !document.querySelector("#teach-loop").disabled);
  await page.click("#teach-loop");
  await waitForText("Cycle 2 done");
  const ys = new Set(targets().map((it) => it[1]));
  assert.deepEqual(ys, new Set([Math.round(y_mm), Math.round(y_mm + 10)]));
  await page.click("#teach-end");
  await until(undefined, "done");
});

test("steps are moved by keys, undone and redone", async () => {
  const before = await rows();
  assert.equal(before.length, 2);
  await page.click("#step-1");
  await page.keyboard.press("Alt+ArrowUp");
  await page.waitForFunction((first) => document.querySelector("#step-0 .says").textContent === first, before[1]);
  await page.click("#teach-undo");
  await page.waitForFunction((first) => document.querySelector("#step-0 .says").textContent === first, before[0]);
  await page.click("#teach-redo");
  await page.waitForFunction((first) => document.querySelector("#step-0 .says").textContent === first, before[1]);
  await page.click("#teach-undo");
  assert.deepEqual(targets(), []);
});

test("a single step moves the arm to one point, and a run from the selected step continues with the following ones", async () => {
  await step("z_plus", "z_mm", (await pose(page, "z_mm")) + 10);
  from = traffic.packets.length;
  await page.click("#step-0");
  await page.waitForFunction(() => !document.querySelector("#teach-step").disabled);
  await page.click("#teach-step");
  await until("paused");
  await rest(page);
  assert.equal(new Set(targets().map(String)).size, 1);
  await page.click("#teach-end");
  await until(undefined, "done");
  from = traffic.packets.length;
  await page.click("#step-1");
  await page.waitForFunction(() => !document.querySelector("#teach-from").disabled);
  await page.click("#teach-from");
  while (!targets().length) await passed(page, 0.1);
  await until(undefined, "done");
  assert.equal(new Set(targets().map(String)).size, 1);
});

test("a problem is shown with a link to its step, and the program cannot be run", async () => {
  await page.check("[name=teach-mode][value=text]", { force: true });
  const text = await page.inputValue("#teach-text");
  await page.fill("#teach-text", `${text}\n[[steps]]\ngo = { x = 900, y = 0, z = 0 }\n`);
  await waitForText("too far");
  await page.waitForFunction(() => document.querySelector("#teach-once").disabled);
  await page.check("[name=teach-mode][value=table]", { force: true });
  await page.click(".problem");
  await page.waitForSelector("#step-2[aria-selected=true]");
  await page.click("#teach-remove");
  await count(2);
  await page.waitForFunction(() => !document.querySelector("#teach-once").disabled);
});

test("a program survives a reload of the page, and is the same after it was saved and opened", async () => {
  await page.check("[name=teach-mode][value=text]", { force: true });
  const text = await page.inputValue("#teach-text");
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("#teach-save")]);
  const saved = await contents(download);
  await page.click("#teach-new");
  await page.waitForFunction(() => document.querySelector("#teach-text").value === "");
  await page.setInputFiles("#teach-file", { name: "again.toml", mimeType: "text/plain", buffer: saved });
  await page.waitForFunction((text) => document.querySelector("#teach-text").value === text, text);
  await page.waitForFunction((text) => localStorage.getItem("dobot.program") === text, text);
  await page.reload();
  await page.click("#tab-teach");
  await count(2);
});

test("a file of the vendor's program is opened as a program, and written again", async () => {
  const vendor = await readFile(new URL("../../crates/teach/tests/data/PlayBackPoints.xml", import.meta.url));
  await page.setInputFiles("#teach-file", { name: "PlayBackPoints.xml", mimeType: "text/xml", buffer: vendor });
  await page.waitForFunction(() => document.querySelector("#teach-title").textContent.includes("PlayBackPoints.toml"));
  await page.waitForSelector("#step-0");
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("#teach-xml")]);
  const again = String(await contents(download));
  const points = (text) => (String(text).match(/<point>/g) ?? []).length;
  assert.ok(points(vendor) > 2);
  assert.equal(points(again), points(vendor), again);
});

test("a program of ten thousand steps shows few rows at once, and any of them after scrolling", async () => {
  const text = Array.from({ length: 10_000 }, (_, n) => `[[steps]]\npause = ${n}\n`).join("");
  await page.setInputFiles("#teach-file", { name: "long.toml", mimeType: "text/plain", buffer: Buffer.from(text) });
  await page.check("[name=teach-mode][value=table]", { force: true });
  await page.waitForSelector("#step-39");
  assert.ok((await page.locator(".step").count()) <= 40);
  await page.hover("#step-5");
  await page.mouse.wheel(0, 5000 * 34);
  await page.waitForSelector("#step-5000");
  assert.ok((await page.locator(".step").count()) <= 40);
});
