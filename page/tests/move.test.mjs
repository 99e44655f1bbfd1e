// The other controls of Move, besides held buttons and targets, judged by the packets to the arm.
import assert from "node:assert/strict";
import { after, afterEach, before, beforeEach, test } from "node:test";
import { waitForAnswer, open, passed, pose, rest, takeControl } from "./bench.mjs";

let bench, page, traffic, from;

before(async () => {
  bench = await open();
  ({ page, traffic } = bench);
  await takeControl(page);
});
after(() => bench.end());
beforeEach(async () => {
  await rest(page);
  // The station counts on it to run down for a little longer than it is seen to.
  await passed(page, 0.4);
  from = traffic.packets.length;
});
afterEach(async () => {
  await page.check("[name=step][value=hold]", { force: true });
  await page.check("[name=frame][value=linear]", { force: true });
  assert.deepEqual(bench.errors, []);
});

const choose = (name, value) => page.check(`[name=${name}][value='${value}']`, { force: true });
const at = (name, value, within = 0.15) => page.waitForFunction(([name, value, within]) => Math.abs(Number(document.querySelector(`[data-pose=${name}]`).textContent) - value) < within, [name, value, within]);
const waitForText = (id, text) => page.waitForFunction(([id, text]) => document.getElementById(id).textContent.includes(text), [id, text]);
const unfold = async (id) => (await page.isVisible(`#${id}[open]`)) || page.click(`#${id} > summary`);
/** The buttons that moved the arm since the test began. */
const pressed = () => new Set(traffic.jogs(from).map((it) => it.text).filter((it) => !it.endsWith(" 0")));
/** The states of the packets since the test began. */
const states = () => new Set(traffic.packets.slice(from).map(({ floats: [state] }) => state));

test("a press moves the tip by 10 mm, and two quick ones by 20 mm", async () => {
  const y_mm = await pose(page, "y_mm");
  await choose("step", 10);
  await page.click("[data-axis=y_plus]");
  await at("y_mm", y_mm + 10);
  await rest(page);
  await page.click("[data-axis=y_minus]");
  await page.click("[data-axis=y_minus]");
  await at("y_mm", y_mm - 10);
  assert.equal(traffic.targets(from).length, 3);
  assert.deepEqual(pressed(), new Set());
});

test("a joint moves by one degree with Enter on its button", async () => {
  await choose("step", 1);
  await choose("frame", "joint");
  const base_deg = await pose(page, "base_deg");
  await page.focus("[data-axis=base_plus]");
  await page.keyboard.press("Enter");
  await at("base_deg", base_deg + 1);
});

test("a refused step moves nothing, and the reason is shown beside the buttons", async () => {
  await choose("step", 10);
  const before = await pose(page, "z_mm");
  const why = page.locator("#jog-why");
  for (let steps = 0; steps < 15; steps += 1) {
    const z_mm = await pose(page, "z_mm");
    await page.click("[data-axis=z_minus]");
    // Each press ends in a move, or in a reason.
    await page.waitForFunction((z_mm) => document.querySelector("#jog-why").dataset.tone === "bad" || Number(document.querySelector("[data-pose=z_mm]").textContent) < z_mm - 9.8, z_mm);
    if ((await why.getAttribute("data-tone")) === "bad") break;
    await rest(page);
  }
  assert.match(await why.textContent(), /^Z−: .*table/);
  assert.ok((await pose(page, "z_mm")) < before);
  assert.equal(await page.isVisible("#problem"), false);
  await page.click("[data-axis=z_plus]");
});

test("arrow keys on the stage jog for as long as they are held, and leaving the stage releases them", async () => {
  const y_mm = await pose(page, "y_mm");
  await page.focus("#stage");
  await page.keyboard.down("ArrowLeft");
  await page.waitForFunction((y_mm) => Number(document.querySelector("[data-pose=y_mm]").textContent) > y_mm + 5, y_mm);
  await page.keyboard.up("ArrowLeft");
  await rest(page);
  assert.deepEqual(pressed(), new Set(["linear 3"]));
  await page.keyboard.down("PageUp");
  await page.waitForFunction(() => document.querySelector("#moving").dataset.moving === "true");
  await page.focus("#tab-move");
  await rest(page);
  assert.equal(traffic.jogs(from).at(-1).text, "linear 0");
  await page.keyboard.up("PageUp");
});

test("Space stops after a click on a button, and presses the button that has the keyboard focus", async () => {
  await choose("step", 1);
  await page.click("[data-axis=x_minus]");
  await rest(page);
  await page.keyboard.press(" ");
  await page.waitForSelector("#stopped");
  await page.click("#reset");
  await page.waitForFunction(() => document.activeElement?.id === "confirm-no");
  await page.keyboard.press("Tab");
  await page.keyboard.press(" ");
  await page.waitForSelector("#stopped", { state: "detached" });
  await page.waitForFunction(() => !document.querySelector("[data-axis=x_plus]").disabled);
});

test("the pump is switched on and off by its buttons", async () => {
  await page.click("#suction-on");
  await waitForText("suction", "on");
  await page.click("#suction-off");
  await waitForText("suction", "off");
});

test("the gripper goes to the typed angle, and the arm does not move", async () => {
  const x_mm = await pose(page, "x_mm");
  await page.fill("#grip-deg", "45");
  await page.click("#grip button");
  await waitForText("gripper", "45°");
  await rest(page);
  assert.ok(Math.abs((await pose(page, "x_mm")) - x_mm) < 0.2);
});

test("an angle beyond 90 degrees is not sent", async () => {
  await page.fill("#grip-deg", "91");
  await page.click("#grip button");
  assert.equal(await page.evaluate(() => document.querySelector("#grip-deg").validity.rangeOverflow), true);
  assert.equal(states().has(6), false);
});

test("the mounted tool is sent to the arm", async () => {
  await page.click("[data-mount=gripper]");
  await waitForAnswer(page, "api/v1/state", ({ queue }) => queue.under_way === 0);
  const configured = traffic.packets.slice(from).filter(({ floats: [state, mode] }) => state === 9 && mode === 4);
  assert.equal(configured.length, 1);
  await page.click("[data-mount=suction_cup]");
});

test("a typed word with a space and a clicked word move the arm as they say", async () => {
  const y_mm = await pose(page, "y_mm");
  await unfold("voice");
  await page.click("#say-text");
  await page.keyboard.type("left twenty");
  await page.keyboard.press("Enter");
  await at("y_mm", y_mm + 20, 0.3);
  await rest(page);
  await page.click("[data-say='right ten']");
  await at("y_mm", y_mm + 10, 0.3);
  assert.equal(await page.isVisible("#stopped"), false);
});

test("speeds are sent to the arm", async () => {
  await unfold("speeds");
  await page.fill("#speed-percent", "60");
  await page.fill("#acceleration-percent", "70");
  await page.click("#speeds-set");
  const adjusted = await traffic.next(from, ({ floats: [state] }) => state === 10);
  assert.deepEqual(adjusted.floats.slice(2, 4), [60, 70]);
});

test("home moves the joints to the power-up pose of a stock arm", async () => {
  await page.click("#home");
  await at("rear_deg", 45);
  await at("fore_deg", 45);
  await at("base_deg", 0);
});

test("dragging the pointer on the mouse pad moves the arm by mouse packets, and few follow the release", async () => {
  await unfold("pads");
  const x_mm = await pose(page, "x_mm");
  await page.locator("#mouse-pad").scrollIntoViewIfNeeded();
  const box = await page.locator("#mouse-pad").boundingBox();
  await page.mouse.move(box.x + 60, box.y + 90);
  await page.mouse.down();
  await page.mouse.move(box.x + 60, box.y + 30, { steps: 12 });
  await page.waitForFunction((x_mm) => Number(document.querySelector("[data-pose=x_mm]").textContent) > x_mm + 1, x_mm);
  const released = traffic.packets.filter(({ floats: [state] }) => state === 1).length;
  await page.mouse.up();
  await rest(page);
  assert.deepEqual([...states()].filter((it) => it !== 0), [1]);
  assert.ok(traffic.packets.filter(({ floats: [state] }) => state === 1).length - released <= 2);
});

test("holding the pointer on the hand pad guides the arm to its place by gestures", async () => {
  await unfold("pads");
  await page.locator("#hand-pad").scrollIntoViewIfNeeded();
  const box = await page.locator("#hand-pad").boundingBox();
  await page.mouse.move(box.x + box.width * 0.35, box.y + box.height * 0.5);
  await page.mouse.down();
  await page.waitForFunction(() => Number(document.querySelector("[data-pose=y_mm]").textContent) > 5);
  await page.mouse.up();
  await rest(page);
  assert.ok(states().has(8), await page.textContent("#pad-status"));
});

test("a stick of a gamepad jogs while the shoulder button is held, and a face button stops", async () => {
  await page.evaluate(() => {
    const pad = { connected: true, axes: [0, 0, 0, 0], buttons: Array.from({ length: 16 }, () => ({ pressed: false })) };
    window.pad = pad;
    navigator.getGamepads = () => [pad];
    window.dispatchEvent(new Event("gamepadconnected"));
    pad.axes[0] = -1;
  });
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  assert.deepEqual(pressed(), new Set());
  const y_mm = await pose(page, "y_mm");
  await page.evaluate(() => { window.pad.buttons[5].pressed = true; });
  await page.waitForFunction((y_mm) => Number(document.querySelector("[data-pose=y_mm]").textContent) > y_mm + 3, y_mm);
  await page.evaluate(() => { window.pad.buttons[1].pressed = true; });
  await page.waitForSelector("#stopped");
  await rest(page);
  assert.deepEqual(pressed(), new Set(["linear 3"]));
  await page.evaluate(() => { window.pad.connected = false; });
  await page.click("#reset");
  await page.click("#confirm-yes");
  await page.waitForSelector("#stopped", { state: "detached" });
});

test("the laser is armed after a question, its countdown is in the strip, and STOP disarms it", async () => {
  await page.click("#arm-laser");
  await page.click("#confirm-yes");
  await waitForText("laser-chip", "armed");
  await page.keyboard.press("Escape");
  await waitForText("laser-chip", "off");
  await waitForText("laser", "disarmed");
});
