// A person touches paper that is not level, and what is drawn then follows it: judged on the packets.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { open, passed, rest, takeControl, typeTarget } from "./bench.mjs";

/** The paper of this test: it rises by 1 mm in 20 ahead, and falls by 1 in 40 to the left. */
const height = ([x, y]) => -30 + (x - 200) / 20 - y / 40;
/** None straight ahead: an arm whose base tells just 0 after a silence may have been reset, and a busy machine is silent at times. */
const PLACES = [[180, -60], [180, 60], [250, 10]];

let bench, page, traffic;

before(async () => {
  bench = await open({ speed: 8 });
  ({ page, traffic } = bench);
  await takeControl(page);
});
after(() => bench.end());
afterEach(() => assert.deepEqual(bench.errors, []));

const waitForText = (id, part) => page.waitForFunction(([id, part]) => document.getElementById(id)?.textContent.includes(part), [id, part]);

/** Goes to a place by the fields, as a person does. */
async function stand(place) {
  await page.click("#tab-move");
  await typeTarget(page, { x_mm: place[0].toFixed(2), y_mm: place[1].toFixed(2), z_mm: height(place).toFixed(2) });
  await passed(page, 0.3);
  await page.waitForSelector("#target-go:enabled");
  await page.click("#target-go");
  await page.waitForFunction(() => document.querySelector("#target-x_mm").value === "");
  await rest(page);
  await passed(page, 0.4);
  await page.click("#tab-set_up");
}

test("three touches give the plane of the paper, and it is saved after a confirmation", async () => {
  await page.click("#tab-set_up");
  await waitForText("paper-known", "Not measured");
  await page.click("#paper-begin");
  for (const [n, place] of PLACES.entries()) {
    await stand(place);
    await page.click("#paper-touch:enabled");
    await page.waitForFunction((n) => document.querySelectorAll("#paper-touches dt").length === n, n + 1);
  }
  await waitForText("paper-found", "3.2");
  assert.equal((await bench.ask("api/v1/calibration")).calibration, null);
  await page.click("#paper-keep");
  await waitForText("paper-known", "slope 3.2");
  const { paper } = (await bench.ask("api/v1/calibration")).calibration;
  assert.ok(Math.abs(paper.slope_x - 1 / 20) < 0.002 && Math.abs(paper.slope_y + 1 / 40) < 0.002, JSON.stringify(paper));
});

test("later drawings follow the paper", async () => {
  await page.click("#tab-draw");
  await page.check("#draw-title ~ .segments input[value=text]", { force: true });
  await page.fill("#draw-text", "I");
  await page.waitForSelector("#draw-start:enabled");
  assert.equal(await page.getAttribute("#draw-down", "placeholder"), "as measured");
  // The plan of the old height holds no longer from the moment on in which the new one is typed.
  const asked = page.waitForResponse((it) => it.request().method() === "POST" && it.url().endsWith("api/v1/drawings"));
  await page.fill("#draw-height", "40");
  await asked;
  await page.waitForSelector("#draw-start:enabled");
  const from = traffic.packets.length;
  await page.click("#draw-start");
  while (!traffic.packets.slice(from).some(({ floats: [state] }) => state === 4)) await passed(page, 0.1);
  while (await bench.ask("api/v1/state").then(({ job }) => job)) await passed(page, 0.2);
  // A vector says how far it goes: back on such an arm (note N4), to the left, up.
  const vectors = traffic.packets.slice(from).filter(({ floats: [state] }) => state === 4).map(({ floats: [, , back, y, z] }) => [-back, y, z]);
  const drawn = vectors.filter(([x, y]) => Math.hypot(x, y) > 1);
  assert.ok(drawn.length > 0);
  for (const [x, y, z] of drawn) assert.ok(Math.abs(z - (x / 20 - y / 40)) < 0.05, `${x} ${y} ${z}`);
});

test("paper that is assumed to be level is drawn on as before", async () => {
  await page.click("#tab-set_up");
  await page.click("#paper-forget");
  await waitForText("paper-known", "Not measured");
  await page.click("#tab-draw");
  await page.waitForFunction(() => document.querySelector("#draw-down") && document.querySelector("#draw-down").placeholder !== "as measured");
});
