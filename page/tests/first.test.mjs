// What a person does first: opens the page, sees the pose, moves the arm a little, stops it.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { moved, open, passed, pose, press, rest, takeControl } from "./bench.mjs";

const FIELDS = ["x_mm", "y_mm", "z_mm", "base_deg", "rear_deg", "fore_deg"];

let bench, page, traffic;

before(async () => {
  bench = await open();
  ({ page, traffic } = bench);
});
after(() => bench.end());

/** What the station knows now. */
function state() {
  return page.evaluate(async () => (await fetch("api/v1/state")).json());
}

/** What the arm told last. */
async function armNow() {
  return (await state()).arm;
}

test("a person opens the page, jogs the arm and stops it", async () => {
  await rest(page);
  const began = await armNow();
  for (const name of FIELDS) assert.equal(await pose(page, name), Number(began[name].toFixed(1)), name);

  await takeControl(page);
  const from = traffic.packets.length;
  await press(page, "y_plus");
  await moved(page, "y_mm", 8);
  // Still held: only STOP ends it.
  assert.deepEqual(new Set(traffic.jogs(from).map((it) => it.text).filter((it) => it !== "linear 0")), new Set(["linear 3"]));
  const stopped = traffic.packets.length;
  await page.keyboard.press("Escape");
  await page.waitForSelector("#stopped:visible");
  await rest(page);
  const jogs = traffic.jogs(stopped).map((it) => it.text);
  assert.equal(jogs.at(-1), "linear 0");
  assert.ok(traffic.jogs(from).every((it) => it.text === "linear 3" || it.text === "linear 0"));

  const ended = await armNow();
  assert.ok(ended.y_mm - began.y_mm >= 8, `y went from ${began.y_mm} to ${ended.y_mm} mm`);
  assert.ok(Math.abs(ended.z_mm - began.z_mm) < 1, `z went from ${began.z_mm} to ${ended.z_mm} mm`);
  assert.equal(await pose(page, "y_mm"), Number(ended.y_mm.toFixed(1)));
  assert.equal(await page.isDisabled("[data-axis=y_plus]:visible"), true);

  // The button that is still held moves nothing, and the arm stays where it stopped.
  const quiet = traffic.packets.length;
  await page.mouse.up();
  await page.mouse.down();
  await page.mouse.up();
  await passed(page, 0.5);
  assert.deepEqual(traffic.jogs(quiet).filter((it) => it.text !== "linear 0"), []);
  assert.equal((await armNow()).y_mm, ended.y_mm);
  assert.deepEqual(bench.errors, []);
});
