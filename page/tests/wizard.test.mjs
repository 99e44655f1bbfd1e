// A tray is touched with the arm on the page, in layers, and judged on the cells that the arm visits.
import assert from "node:assert/strict";
import { after, test } from "node:test";
import { open, pose, rest, takeControl, typeTarget } from "./bench.mjs";

const bench = await open({ speed: 8, viewport: { width: 1280, height: 900 } });
const { page, traffic } = bench;
after(() => bench.end());

/** The arm goes to a place, as a person sends it there. */
async function goTo(place) {
  await page.click("#tab-move");
  await typeTarget(page, place);
  await page.waitForFunction(() => !document.querySelector("#target-go").disabled);
  await page.click("#target-go");
  await page.waitForFunction((place) => Object.entries(place).every(([name, mm]) => Math.abs(Number(document.querySelector(`[data-pose=${name}]`).textContent) - mm) < 0.3), place);
  await rest(page);
  await page.click("#tab-teach");
}

test("a tray from three touched corners and 2 x 2 x 2 is visited cell by cell", async () => {
  await takeControl(page);
  await rest(page);
  await page.click("#tab-teach");
  await page.click("#wizard summary");
  for (const [n, place] of [[200, 40], [230, 40], [200, 80]].map(([x_mm, y_mm]) => ({ x_mm, y_mm, z_mm: 20 })).entries()) {
    await goTo(place);
    if (!(await page.locator("#wizard").evaluate((it) => it.open))) await page.click("#wizard summary");
    await page.click(`[data-touch="${n}"]`);
  }
  for (const [name, count] of [["columns", 2], ["rows", 2], ["layers", 2]]) await page.fill(`#wizard-${name}`, String(count));
  await page.fill("#wizard-layer-mm", "15");
  await page.keyboard.press("Tab");
  await page.click("#wizard-add");
  await page.waitForFunction(() => document.querySelectorAll(".step").length === 1);
  await page.waitForFunction(() => !document.querySelector("#teach-once").disabled);
  const from = traffic.packets.length;
  await page.click("#teach-once");
  await page.waitForFunction(() => document.querySelector("#no-job"));
  while (new Set(traffic.targets(from).map(String)).size < 8) await traffic.next(traffic.packets.length, ({ floats: [state] }) => state === 3);
  await rest(page);
  const cells = [20, 35].flatMap((z) => [40, 80].flatMap((y) => [200, 230].map((x) => [x, y, z].join())));
  assert.deepEqual([...new Set(traffic.targets(from).map((it) => it.map(Math.round).join()))], cells);
  assert.ok(Math.abs((await pose(page, "z_mm")) - 35) < 0.5);
  assert.deepEqual(bench.errors, []);
});
