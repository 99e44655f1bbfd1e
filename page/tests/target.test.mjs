// Go to a typed or dragged target, judged by the packets to the arm.
import assert from "node:assert/strict";
import { after, afterEach, before, beforeEach, test } from "node:test";
import { open, pose, rest, takeControl, typeTarget } from "./bench.mjs";
import { drawn } from "./browser.mjs";
import { onScreen } from "./stage_bench.mjs";

let bench, page, traffic, from;

before(async () => {
  bench = await open({ webgl: true, viewport: { width: 900, height: 600 }, options: { reducedMotion: "reduce" } });
  ({ page, traffic } = bench);
  await takeControl(page);
});
after(() => bench.end());
beforeEach(async () => {
  await rest(page);
  from = traffic.packets.length;
});
afterEach(() => assert.deepEqual(bench.errors, []));

const waitForText = (part) => page.waitForFunction((part) => document.querySelector("#target-status").textContent.includes(part), part);
const at = (name, value) => page.waitForFunction(([name, value]) => Math.abs(Number(document.querySelector(`[data-pose=${name}]`).textContent) - value) < 0.15, [name, value]);
const field = async (name) => Number(await page.inputValue(`#target-${name}`));

test("a typed place is checked, and only Go moves the arm there", async () => {
  await typeTarget(page, { x_mm: 210, y_mm: -60, z_mm: 20 });
  await waitForText("The path is free");
  assert.deepEqual(traffic.targets(from), []);
  await page.click("#target-go");
  await at("y_mm", -60);
  assert.deepEqual(traffic.targets(from), [[210, -60, 20]]);
  await page.waitForFunction(() => document.querySelector("#target-x_mm").value === "");
});

test("one line is written to the typed place at its speed", async () => {
  const [x_mm, y_mm, z_mm] = [await pose(page, "x_mm"), await pose(page, "y_mm"), await pose(page, "z_mm")];
  await page.click("label:has([name=path][value=vector])");
  await page.fill("#target-speed", "0");
  await typeTarget(page, { x_mm: x_mm + 10, y_mm: y_mm - 20, z_mm });
  await waitForText("needs a number above 0");
  assert.equal(await page.isDisabled("#target-go"), true);
  await page.fill("#target-speed", "30");
  await waitForText("The path is free");
  assert.equal(await page.isDisabled("#target-rotation_deg"), true);
  await page.click("#target-go");
  await at("y_mm", y_mm - 20);
  await at("x_mm", x_mm + 10);
  const lines = traffic.packets.slice(from).filter(({ floats: [state] }) => state === 4);
  assert.equal(lines.length, 1);
  await page.click("label:has([name=path][value=movj])");
});

test("a place beyond reach is refused with the allowed range, and the nearest place is one click away", async () => {
  await typeTarget(page, { x_mm: 600, y_mm: 0, z_mm: 20 });
  await waitForText("too far");
  assert.equal(await page.isDisabled("#target-go"), true);
  await page.click("#target-nearest");
  await waitForText("The path is free");
  assert.ok((await field("x_mm")) < 330 && (await field("x_mm")) > 220);
  assert.deepEqual(traffic.targets(from), []);
  await page.click("#target-clear");
});

test("a field without a number asks for one, and nothing is sent", async () => {
  await typeTarget(page, { x_mm: 200 });
  await waitForText("The path is free");
  await page.fill("#target-x_mm", "");
  await waitForText("Each field needs a number");
  assert.equal(await page.isDisabled("#target-go"), true);
  assert.deepEqual(traffic.targets(from), []);
  await page.click("#target-clear");
});

test("the tip dragged on the stage sets the target, and Go moves the arm there", async () => {
  await page.waitForSelector("#stage[data-shown='3d']");
  await page.click("[data-look=top]");
  await drawn(page);
  const box = await page.locator("#stage").boundingBox();
  const tip = onScreen("top", { x_mm: await pose(page, "x_mm"), y_mm: await pose(page, "y_mm"), z_mm: await pose(page, "z_mm") }, box);
  await page.mouse.move(box.x + tip.x, box.y + tip.y);
  await page.mouse.down();
  await page.mouse.move(box.x + tip.x - 12, box.y + tip.y + 6, { steps: 6 });
  await page.mouse.up();
  await page.waitForFunction(() => document.querySelector("#target-y_mm").value !== "");
  await waitForText("The path is free");
  const wanted = [await field("x_mm"), await field("y_mm")];
  assert.deepEqual(traffic.targets(from), []);
  await page.click("#target-go");
  await at("y_mm", wanted[1]);
  const [[x_mm, y_mm]] = traffic.targets(from);
  assert.ok(Math.abs(x_mm - wanted[0]) < 0.06 && Math.abs(y_mm - wanted[1]) < 0.06);
});

test("Escape stops an arm on its way to a target", async () => {
  await typeTarget(page, { x_mm: 200, y_mm: 90, z_mm: 20 });
  await waitForText("The path is free");
  await page.click("#target-go");
  await page.keyboard.press("Escape");
  await page.waitForSelector("#stopped:visible");
  await page.waitForFunction(() => document.querySelector("#stopped-by").textContent.includes("The arm is at rest"));
  await page.click("#reset");
  await page.click("#confirm-yes");
});
