// Places are touched with the arm on the page: a tray in layers, a frame, named points, a step; judged on where the arm is sent.
import assert from "node:assert/strict";
import { after, afterEach, test } from "node:test";
import { open, pose, rest, takeControl, typeTarget, waitForAnswer } from "./bench.mjs";

const bench = await open({ speed: 8, viewport: { width: 1280, height: 900 } });
const { page, traffic } = bench;
after(() => bench.end());
afterEach(() => assert.deepEqual(bench.errors, []));

/** The arm goes to a place, as a person sends it there. */
async function goTo(place) {
  await page.click("#tab-move");
  await typeTarget(page, place);
  await page.waitForSelector("#target-go:enabled");
  await page.click("#target-go");
  await page.waitForFunction((place) => Object.entries(place).every(([name, mm]) => Math.abs(Number(document.querySelector(`[data-pose=${name}]`).textContent) - mm) < 0.3), place);
  await rest(page);
  await page.waitForFunction(() => document.querySelector("#target-x_mm").value === "");
  await page.click("#tab-teach");
}

/** Touches places with the arm, as the wizard asks for them. */
async function touch(...places) {
  for (const [n, [x_mm, y_mm, z_mm]] of places.entries()) {
    await goTo({ x_mm, y_mm, z_mm, rotation_deg: 0 });
    if (!(await page.locator("#wizard").evaluate((it) => it.open))) await page.click("#wizard summary");
    await page.click(`[data-touch="${n}"]`);
  }
}

/** Chooses what is touched, and its name. */
async function choose(kind, name) {
  await page.check(`[name=wizard-kind][value=${kind}]`, { force: true });
  await page.fill("#wizard-name", name);
}

/** Begins a program, which needs a step. */
async function begin() {
  await page.click("#teach-new");
  await page.click("#capture");
  await page.waitForSelector("#step-0");
}

/** Puts what was touched into the program. */
async function add() {
  await page.click("#wizard-add");
  await page.waitForSelector("#wizard-add:disabled");
}

/** Types a program, whose points are those that were touched. */
async function type(steps) {
  await page.check("[name=teach-mode][value=text]", { force: true });
  await page.fill("#teach-text", steps((await page.inputValue("#teach-text")).replace(/\[\[steps\]\][^]*/, "")));
  await page.check("[name=teach-mode][value=table]", { force: true });
}

/** Presses a button that runs the program; returns where the arm is sent, in whole millimetres. */
async function run(button) {
  await page.waitForSelector(`#${button}:enabled`);
  const from = traffic.packets.length;
  await page.click(`#${button}`);
  await traffic.next(from, ({ floats: [state] }) => state === 3);
  await waitForAnswer(page, "api/v1/state", ({ job, arm }) => !arm.moving && job?.phase !== "running");
  return [...new Set(traffic.targets(from).map((it) => it.map(Math.round).join()))];
}

test("a tray from three touched corners and 2 x 2 x 2 is visited cell by cell", async () => {
  await takeControl(page);
  await rest(page);
  await page.click("#tab-teach");
  await page.click("#wizard summary");
  await touch([200, 40, 20], [230, 40, 20], [200, 80, 20]);
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
});

test("in an empty program the wizard asks for a step before a point", async () => {
  await page.click("#teach-new");
  await choose("point", "home");
  await touch([210, 30, 30]);
  assert.ok(await page.isDisabled("#wizard-add"));
  assert.match(await page.textContent("#wizard"), /The program is empty/);
  await page.click("#capture");
  await page.waitForSelector("#wizard-add:enabled");
});

test("a named point is touched, its step goes there, and touched again it is another place", async () => {
  await begin();
  for (const place of [[210, 30, 30], [205, -20, 30]]) {
    await choose("point", "home");
    await touch(place);
    await add();
    await type((points) => `${points}[[steps]]\ngo = "home"\n`);
    assert.deepEqual(await run("teach-once"), [place.join()]);
  }
});

test("a frame from three touched places turns its points", async () => {
  await begin();
  await choose("frame", "table");
  // Its x axis points to the left, so its y axis points back to the base.
  await touch([200, 0, 20], [200, 40, 20], [180, 10, 20]);
  await add();
  await type((frames) => `${frames}[points]\nin_it = { x = 20, y = 10, z = 5, frame = "table" }\n[[steps]]\ngo = "in_it"\n`);
  assert.deepEqual(await run("teach-once"), ["190,20,25"]);
});

test("a step gets the place of the arm, and runs alone", async () => {
  await type(() => "[[steps]]\ngo = { x = 200, y = 0, z = 40 }\n\n[[steps]]\ngo = { x = 220, y = 0, z = 40 }\n");
  await goTo({ x_mm: 215, y_mm: -35, z_mm: 25, rotation_deg: 0 });
  await page.click("#step-0");
  await page.click("#teach-retake");
  await page.waitForFunction(() => document.querySelector("#step-0 .says").title.includes("y = -35"));
  assert.deepEqual(await run("teach-step"), ["215,-35,25"]);
  // The next step is marked. A changed program runs from its chosen step, not where the last job has stopped.
  await page.waitForSelector("#step-1.is-running");
  await goTo({ x_mm: 210, y_mm: -20, z_mm: 30, rotation_deg: 0 });
  await page.click("#teach-retake");
  await page.waitForFunction(() => document.querySelector("#step-0 .says").title.includes("y = -20"));
  assert.deepEqual(await run("teach-step"), ["210,-20,30"]);
  assert.deepEqual(await run("teach-step"), ["220,0,40"]);
  await page.click("#step-1");
  assert.deepEqual(await run("teach-step"), ["220,0,40"]);
  await waitForAnswer(page, "api/v1/state", ({ job }) => !job);
});
