// What a person sets up on the page, judged on what the station then does.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { waitForAnswer, open, serveFromDisk, takeControl, typeTarget } from "./bench.mjs";

let real, virtual;

before(async () => {
  real = await open({ patient: false });
  virtual = await open({ virtual: true });
  await takeControl(real.page);
});
after(async () => {
  await real.end();
  await virtual.end();
});
afterEach(() => assert.deepEqual([...real.errors, ...virtual.errors], []));

const waitForText = (page, id, part) => page.waitForFunction(([id, part]) => document.getElementById(id)?.textContent.includes(part), [id, part])
  .catch(async (error) => assert.fail(`${error.message} ${id} says: ${await page.textContent(`#${id}`)}; ${await page.locator(".refusal").allTextContents()}`));
const THERE = { x_mm: 220, y_mm: 100, z_mm: 0 };

test("a keep-out in force refuses a target that was free, and is gone when it is removed", async () => {
  const { page, traffic } = real;
  await typeTarget(page, THERE);
  await waitForText(page, "target-status", "The path is free");
  await page.click("#tab-set_up");
  await page.click("[data-new-zone=box]");
  await page.fill("[data-zone=zone_1] label:nth-of-type(6) input", "60");
  // What is being typed stays, whatever the page is told meanwhile.
  await page.waitForFunction(() => !document.querySelector("#policy-keep").disabled);
  await page.keyboard.press("Tab");
  await page.waitForFunction(() => document.querySelector("#policy-text").value.includes("z_mm = [-103, 60]"));
  // Nothing holds before it is put in force.
  assert.deepEqual((await real.ask("api/v1/policy")).keep_out, {});
  await page.click("#policy-keep");
  await waitForText(page, "policy-status", "This policy is in force");
  const policy = await real.ask("api/v1/policy");
  assert.deepEqual(policy.keep_out.zone_1, { box: { x_mm: [200, 260], y_mm: [80, 140], z_mm: [-103, 60] } });
  await page.click("#tab-move");
  const from = traffic.packets.length;
  await typeTarget(page, { z_mm: 1 });
  await waitForText(page, "target-status", "keep_out.zone_1");
  assert.equal(await page.isDisabled("#target-go"), true);
  assert.deepEqual(traffic.targets(from), []);
  await page.click("#tab-set_up");
  await page.click("[data-zone=zone_1] button");
  await page.click("#policy-keep");
  await waitForAnswer(page, "api/v1/policy", ({ keep_out }) => Object.keys(keep_out).length === 0);
  await page.click("#tab-move");
  await typeTarget(page, THERE);
  await waitForText(page, "target-status", "The path is free");
  await page.click("#target-clear");
});

test("the numbers of a keep-out are typed one after another by keyboard, and show those in force when the draft is discarded", async () => {
  const { page } = real;
  const field = (n) => page.locator(`[data-zone=zone_1] label:nth-of-type(${n}) input`);
  const written = (part) => page.waitForFunction((part) => document.querySelector("#policy-text").value.includes(part), part);
  const isChecked = () => page.waitForFunction(() => !document.querySelector("#policy-keep").disabled);
  await page.click("#tab-set_up");
  await page.click("[data-new-zone=box]");
  await field(5).focus();
  for (const key of ["Control+A", "-", "5", "0", "Tab", "Control+A", "6"]) await page.keyboard.press(key);
  await written("z_mm = [-50, 0]");
  await isChecked();
  // The answer to the first number came while the second one was typed.
  for (const key of ["0", "Tab"]) await page.keyboard.press(key);
  await written("z_mm = [-50, 60]");
  await isChecked();
  await page.click("#policy-keep");
  await waitForText(page, "policy-status", "This policy is in force");
  await field(6).focus();
  for (const key of ["Control+A", "7", "0", "Tab"]) await page.keyboard.press(key);
  await written("z_mm = [-50, 70]");
  await page.click("#policy-forget");
  await page.waitForFunction(() => document.querySelector("[data-zone=zone_1] label:nth-of-type(6) input").value === "60");
  await page.click("[data-zone=zone_1] button");
  await page.click("#policy-keep");
  await waitForAnswer(page, "api/v1/policy", ({ keep_out }) => Object.keys(keep_out).length === 0);
});

test("an invalid policy is reported with its line, cannot be put in force, and the old one stays", async () => {
  const { page } = real;
  await page.click("#tab-set_up");
  await page.click("#policy-text-part summary");
  const text = await page.inputValue("#policy-text");
  const before = await real.ask("api/v1/policy");
  await page.fill("#policy-text", text.replace(/line_mm_s = 200/, "line_mm_s = fast"));
  await page.waitForFunction(() => document.querySelector("#policy-status").dataset.tone === "bad");
  assert.match(await page.textContent("#policy-status"), /line \d+/);
  assert.equal(await page.isDisabled("#policy-keep"), true);
  await page.click("#policy-forget");
  await waitForText(page, "policy-status", "This policy is in force");
  assert.equal(await page.inputValue("#policy-text"), text);
  assert.deepEqual(await real.ask("api/v1/policy"), before);
});

test("a new token grants its holder access, is shown as a code for a phone, and its removal revokes access", async () => {
  const { page, url } = real;
  await page.click("#tab-set_up");
  await page.fill("#token-new [name=name]", "phone");
  await page.click("#token-new button");
  await page.waitForSelector("#token-made .qr");
  const secret = await page.textContent("#token-secret");
  const status = async () => (await fetch(new URL("api/v1/state", url), { headers: { authorization: `Bearer ${secret}` } })).status;
  assert.equal(await status(), 200);
  await page.click("[aria-label='Remove phone']");
  await page.click("#confirm-yes");
  await page.waitForFunction(() => !document.querySelector(".tokens").textContent.includes("phone"));
  assert.equal(await status(), 401);
});

test("a token for several people is created and shown as such", async () => {
  const { page } = real;
  await page.fill("#token-new [name=name]", "class");
  await page.check("#token-new [name=shared]");
  await page.click("#token-new button");
  await page.waitForFunction(() => /class\s+move the arm\s+shared/.test(document.querySelector(".tokens").textContent));
  const kept = (await real.ask("api/v1/tokens")).find(({ name }) => name === "class");
  assert.deepEqual(kept, { name: "class", role: "control", shared: true });
  assert.equal(await page.isChecked("#token-new [name=shared]"), false, "the next one is one person's again");
});

test("the detection asks before it moves the arm, moves it a little, and shows what it saw and what that means", async () => {
  const { page, traffic } = real;
  await page.click("#tab-set_up");
  const from = traffic.packets.length;
  await page.click("#detect");
  await page.waitForSelector("#confirm-yes");
  assert.deepEqual(traffic.targets(from), []);
  await page.click("#confirm-yes");
  await waitForText(page, "finding", "firmware-1.1");
  assert.ok((await page.locator(".evidence li").count()) > 0);
  const far = (axis) => Math.max(...traffic.targets(from).map((it) => it[axis])) - Math.min(...traffic.targets(from).map((it) => it[axis]));
  assert.ok(Math.hypot(far(0), far(1), far(2)) < 20);
});

test("a fault that is set affects the arm, and an unknown one is reported", async () => {
  const { page } = virtual;
  await page.click("#tab-set_up");
  await page.click("#first-close");
  await page.fill("#faults-text", "explode");
  await page.click("#faults-set");
  await page.waitForSelector(".refusal");
  await page.fill("#faults-text", "");
  await page.click("[data-fault='drop=1%']");
  await page.fill("#faults-text", "withhold@0s..2s");
  await page.click("#faults-set");
  await page.waitForFunction(() => document.querySelector("#stage").classList.contains("is-old"));
  assert.deepEqual(await virtual.ask("api/v1/faults"), ["withhold@0s..2s"]);
  await page.click("#faults-none");
  await waitForText(page, "faults-now", "none active");
  assert.deepEqual(await virtual.ask("api/v1/faults"), []);
});

test("a selected world surrounds the arm", async () => {
  const { page } = virtual;
  await page.click("#tab-set_up");
  await page.click("[data-world='world.cubes']");
  await page.click("#world-set");
  await waitForAnswer(page, "api/v1/world", ({ objects }) => objects.length === 2);
  const { tool, objects } = await virtual.ask("api/v1/world");
  assert.equal(tool.kind.type, "suction_cup");
  assert.deepEqual(objects.map((it) => it.name), ["red cube", "blue cube"]);
  await page.click("[data-world='world.pen']");
  await page.click("#world-set");
  await waitForAnswer(page, "api/v1/world", ({ tool }) => tool.kind.type === "pen");
});

test("the language changes at once, and is kept for the next visit", async () => {
  const { page } = virtual;
  await page.click("#tab-set_up");
  await page.check("[name=language][value=zh]", { force: true });
  await page.waitForFunction(() => document.querySelector("#stop").textContent.includes("停止"));
  await page.reload();
  await page.waitForFunction(() => document.querySelector("#stop")?.textContent.includes("停止"));
  await page.click("#tab-set_up");
  await page.check("[name=language][value=en]", { force: true });
  await page.check("[name=theme][value=dark]", { force: true });
  await page.waitForFunction(() => document.documentElement.dataset.theme === "dark");
});

test("a token that the station does not know is reported as unknown, and the page asks for another one", async () => {
  const context = await virtual.page.context().browser().newContext();
  await serveFromDisk(context, virtual.url);
  const page = await context.newPage();
  await page.goto(`${virtual.url}#token=wrong`);
  await page.waitForSelector("#token");
  assert.match(await page.textContent("#token label"), /does not know this token/);
  await context.close();
});
