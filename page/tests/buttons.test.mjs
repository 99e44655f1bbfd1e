// Buttons that people add to the page, and a path recorded while the arm is jogged, judged by the packets to the arm.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { isStop, moved, open, passed, press, rest, takeControl, waitForAnswer } from "./bench.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
let bench, page, traffic;

before(async () => {
  bench = await open({ viewport: { width: 1280, height: 720 } });
  ({ page, traffic } = bench);
  await takeControl(page);
  await page.click("#first-close").catch(() => {});
});
after(() => bench.end());
afterEach(() => assert.deepEqual(bench.errors, []));

const still = async () => {
  await waitForAnswer(page, "api/v1/state", ({ arm, queue, job }) => !arm.moving && !job && queue.waiting + queue.under_way === 0);
  await passed(page, 0.4);
};
async function jog(axis, name, by) {
  await press(page, axis);
  await moved(page, name, by);
  await page.mouse.up();
  await rest(page);
  await still();
}
async function add(name, effect, color) {
  await page.waitForSelector("#buttons-edit");
  if ((await page.getAttribute("#buttons-edit", "aria-expanded")) === "false") await page.click("#buttons-edit");
  await page.fill("#button-new [name=name]", name);
  await page.selectOption("#button-new [name=effect]", effect);
  await page.selectOption("#button-new [name=color]", color);
  await page.click("#button-new button");
}

test("a position is reached from another page with one click, which takes control", async () => {
  const there = (await bench.ask("api/v1/state")).arm;
  await add("Ready", "position", "green");
  await page.waitForSelector("[data-button=Ready]");
  await jog("y_plus", "y_mm", 20);
  await page.click("#release");
  await page.waitForSelector("#take");
  const phone = await bench.visit(PHONE);
  const button = phone.locator("[data-button=Ready]");
  await button.waitFor();
  assert.equal(await button.getAttribute("data-color"), "green");
  const box = await button.boundingBox();
  assert.ok(box.height >= 44 && box.width >= 44, `${box.width}x${box.height}`);
  const from = traffic.packets.length;
  await button.tap();
  await traffic.next(from, ({ floats: [state] }) => state === 3);
  const [[x, y, z]] = traffic.targets(from);
  for (const [found, wanted] of [[x, there.x_mm], [y, there.y_mm], [z, there.z_mm]]) assert.ok(Math.abs(found - wanted) < 0.01, `${found} ${wanted}`);
  await still();
  const { lease, arm } = await bench.ask("api/v1/state");
  assert.equal(lease.device, "phone");
  assert.ok(Math.abs(arm.y_mm - there.y_mm) < 0.2, `${arm.y_mm}`);
  await phone.tap("#release");
  await phone.context().close();
});

test("a button moves nothing while the arm is stopped, and says why", async () => {
  await page.click("#take");
  await page.waitForSelector("#release");
  let from = traffic.packets.length;
  await page.click("#stop");
  assert.ok(await traffic.next(from, isStop));
  await page.waitForSelector("#stopped");
  assert.equal(await page.isDisabled("[data-button=Ready]"), true);
  assert.ok(await page.isVisible("#panel [data-remedy=stopped]"), "with the button that solves it");
  from = traffic.packets.length;
  const { x, y, width, height } = await page.locator("[data-button=Ready]").boundingBox();
  await page.mouse.click(x + width / 2, y + height / 2);
  await passed(page, 0.4);
  assert.deepEqual(traffic.targets(from), []);
  await waitForAnswer(page, "api/v1/state", ({ stop }) => stop?.at_rest);
  await page.click("#reset");
  await page.click("#confirm-yes");
  await page.waitForSelector("[data-button=Ready]:enabled");
});

test("a jogged path becomes steps of the program, which draw it again", async () => {
  await page.click("#tab-teach");
  await page.click("#teach-record");
  await page.waitForSelector("#teach-recording");
  const from = (await bench.ask("api/v1/state")).arm;
  await jog("y_plus", "y_mm", 25);
  await jog("x_minus", "x_mm", 15);
  const to = (await bench.ask("api/v1/state")).arm;
  await page.click("#teach-record");
  await page.waitForSelector("#teach-recording", { state: "detached" });
  await page.waitForSelector("#teach-once:enabled");
  const rows = await page.locator("#steps [data-row]").count();
  assert.ok(rows >= 3 && rows < 20, `${rows} steps for a corner`);
  const start = traffic.packets.length;
  await page.click("#teach-once");
  await waitForAnswer(page, "api/v1/state", ({ job }) => job?.phase === "running");
  await still();
  const path = traffic.targets(start);
  const isNear = ([x, y], arm) => Math.hypot(x - arm.x_mm, y - arm.y_mm) < 0.6;
  assert.ok(isNear(path[0], from) && isNear(path.at(-1), to), JSON.stringify([path[0], from, path.at(-1), to]));
  const corner = path.find(([x, y]) => Math.hypot(x - from.x_mm, y - to.y_mm) < 3);
  assert.ok(corner, `the corner is one of ${JSON.stringify(path)}`);
});

test("a button runs the program that was taught, as a job of its name", async () => {
  await page.click("#tab-move");
  await add("Corner", "program", "purple");
  await page.click("#buttons-edit");
  const from = traffic.packets.length;
  await page.click("[data-button=Corner]");
  const { job } = await waitForAnswer(page, "api/v1/state", ({ job }) => job?.phase === "running");
  assert.equal(job.kind, "program");
  assert.ok(await page.isDisabled("[data-button=Ready]"), "one thing at a time");
  await still();
  assert.ok(traffic.targets(from).length >= 3);
});

test("a name exists once, and a removed button is gone from all pages", async () => {
  const other = await bench.visit(PHONE);
  await other.locator("[data-button=Corner]").waitFor();
  await add("Corner", "suction_on", "grey");
  await page.waitForSelector("#button-refused");
  assert.match(await page.textContent("#button-refused"), /^Another button has this name/);
  await page.click("[data-remove=Corner]");
  await other.locator("[data-button=Corner]").waitFor({ state: "detached" });
  await other.context().close();
});
