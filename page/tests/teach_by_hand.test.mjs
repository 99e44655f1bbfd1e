// Steps of a program that a person moves by hand: rows with pointer, finger and keys, places on the stage.
import assert from "node:assert/strict";
import { after, afterEach, before, beforeEach, test } from "node:test";
import { open, passed, rest, takeControl } from "./bench.mjs";
import { drawn } from "./browser.mjs";
import { onScreen } from "./stage_bench.mjs";

let bench, page, traffic;

before(async () => {
  bench = await open({ webgl: true, viewport: { width: 1100, height: 800 }, speed: 8, options: { hasTouch: true, reducedMotion: "reduce" } });
  ({ page, traffic } = bench);
  // Compiling the shaders without a GPU blocks the page for seconds, in which it would lose control.
  await page.waitForSelector("#stage[data-shown='3d']");
  await takeControl(page);
  await rest(page);
  await page.click("[data-look=top]");
  await drawn(page);
  await page.click("#tab-teach");
});
after(() => bench.end());
afterEach(() => assert.deepEqual(bench.errors, []));

const PLACES = [[200, -60], [220, 0], [200, 60], [180, 30]];
const program = () => `title = "four"\n\n${PLACES.map(([x, y]) => `[[steps]] # kept\ngo = { x = ${x}, y = ${y}, z = 20 }\npath = "movl"\n`).join("\n")}`;
const give = async (text) => {
  await page.setInputFiles("#teach-file", { name: "four.toml", mimeType: "text/plain", buffer: Buffer.from(text) });
  await page.waitForSelector("#step-3");
  await page.waitForFunction(() => !document.querySelector("#teach-once").disabled);
};
beforeEach(() => give(program()));

/** The X and Y of the steps, as the table says them. */
const order = () => page.evaluate(() => [...document.querySelectorAll(".says")].map(({ title }) => /x = ([-\d.]+), y = ([-\d.]+)/.exec(title)?.slice(1).map(Number)));
async function ordered(...rows) {
  const wanted = JSON.stringify(rows.map((row) => PLACES[row]));
  await page.waitForFunction((wanted) => JSON.stringify([...document.querySelectorAll(".says")].map(({ title }) => /x = ([-\d.]+), y = ([-\d.]+)/.exec(title)?.slice(1).map(Number))) === wanted, wanted);
}
const middle = async (selector) => {
  const { x, y, width, height } = await page.locator(selector).boundingBox();
  return [x + width / 2, y + height / 2];
};
async function choose(row) {
  await page.click(`#step-${row}`);
  await page.waitForSelector(`#step-${row}[aria-selected=true]`);
}
/** Where the wrist of a step is on the screen, seen from above. */
async function onStage([x_mm, y_mm]) {
  const box = await page.locator("#stage").boundingBox();
  const { x, y } = onScreen("top", { x_mm, y_mm, z_mm: 20 }, box);
  return [box.x + x, box.y + y];
}

test("a step is dragged to another place by its grip, and the arm runs the program in the new order", async () => {
  await page.mouse.move(...(await middle("#step-0 .grip")));
  await page.mouse.down();
  await page.mouse.move(...(await middle("#step-2 .grip")), { steps: 5 });
  await page.waitForSelector("#step-2.takes-below");
  await page.mouse.up();
  await ordered(1, 2, 0, 3);
  await page.waitForFunction(() => document.querySelector("#teach-moved").textContent.includes("step 3 of 4"));
  await page.waitForFunction(() => !document.querySelector("#teach-once").disabled);
  const from = traffic.packets.length;
  await page.click("#teach-once");
  while (traffic.targets(from).length < 4) await passed(page, 0.1);
  const gone = [...new Set(traffic.targets(from).map(([x, y]) => `${Math.round(x)} ${Math.round(y)}`))];
  assert.deepEqual(gone, [1, 2, 0, 3].map((row) => PLACES[row].join(" ")));
  while ((await bench.ask("api/v1/state")).job) await passed(page, 0.1);
});

test("a finger drags a step, too", async () => {
  const [x, y] = await middle("#step-3 .grip"), [, to] = await middle("#step-1 .grip");
  const cdp = await page.context().newCDPSession(page);
  const touch = (type, ...points) => cdp.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
  await touch("touchStart", [x, y]);
  for (const share of [0.3, 0.6, 1]) await touch("touchMove", [x, y + (to - y) * share]);
  await page.waitForSelector("#step-1.takes-above");
  await touch("touchEnd");
  await ordered(0, 3, 1, 2);
});

test("Alt with the arrow keys moves the step, announces its place, and stays on it", async () => {
  await page.click("#step-0");
  await page.keyboard.press("Alt+ArrowDown");
  await ordered(1, 0, 2, 3);
  await page.waitForFunction(() => document.activeElement?.id === "step-1");
  await page.keyboard.press("Alt+ArrowDown");
  await ordered(1, 2, 0, 3);
  await page.waitForFunction(() => document.querySelector("#teach-moved").textContent === "The step is now step 3 of 4.");
});

test("Escape stops the arm and leaves the dragged step where it was", async () => {
  await page.mouse.move(...(await middle("#step-0 .grip")));
  await page.mouse.down();
  await page.mouse.move(...(await middle("#step-2 .grip")), { steps: 4 });
  await page.keyboard.press("Escape");
  await page.mouse.up();
  await page.waitForSelector("#stopped:visible");
  assert.equal(await page.locator(".is-carried, .takes-below").count(), 0);
  assert.deepEqual(await order(), PLACES);
  await page.click("#reset");
  await page.click("#confirm-yes");
  await page.waitForSelector("#stopped", { state: "detached" });
});

test("the place of the selected step is dragged on the stage; table and text follow, the rest of the text is unchanged, and it is one change", async () => {
  const from = traffic.packets.length;
  await choose(1);
  await page.mouse.move(...(await onStage(PLACES[1])));
  await page.mouse.down();
  await page.mouse.move(...(await onStage([200, 30])), { steps: 6 });
  // While it is dragged the table says where.
  await page.waitForFunction(() => !document.querySelector("#step-1 .says").title.includes("x = 220"));
  await page.mouse.up();
  await page.waitForFunction(() => document.querySelector("#step-1 .says").title.match(/x = (199|20[01])/));
  const [, [x, y]] = await order();
  assert.ok(Math.abs(x - 200) < 3 && Math.abs(y - 30) < 3, `${x} ${y}`);
  await page.check("[name=teach-mode][value=text]", { force: true });
  const text = await page.inputValue("#teach-text");
  await page.check("[name=teach-mode][value=table]", { force: true });
  assert.equal(text.replace(`x = ${x}, y = ${y}`, "x = 220, y = 0"), program());
  await page.click("#teach-undo");
  await ordered(0, 1, 2, 3);
  await page.click("#teach-redo");
  await page.waitForFunction(() => !document.querySelector("#teach-once").disabled);
  assert.deepEqual(traffic.targets(from), []);
  await page.click("#teach-once");
  const isThere = ([tx, ty]) => Math.abs(tx - x) < 0.1 && Math.abs(ty - y) < 0.1;
  while (!traffic.targets(from).some(isThere)) await passed(page, 0.1);
  while ((await bench.ask("api/v1/state")).job) await passed(page, 0.1);
});

test("Escape stops the arm and puts the dragged place back", async () => {
  await choose(2);
  await page.mouse.move(...(await onStage(PLACES[2])));
  await page.mouse.down();
  await page.mouse.move(...(await onStage([210, 20])), { steps: 6 });
  await page.waitForFunction(() => !document.querySelector("#step-2 .says").title.includes("y = 60"));
  await page.keyboard.press("Escape");
  await page.waitForFunction(() => document.querySelector("#step-2 .says").title.includes("x = 200, y = 60"));
  await page.mouse.move(...(await onStage([230, 10])), { steps: 3 });
  await page.mouse.up();
  assert.match(await page.getAttribute("#step-2 .says", "title"), /x = 200, y = 60/);
  await page.click("#reset");
  await page.click("#confirm-yes");
});
