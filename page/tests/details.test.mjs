// Details of texts and layout, at a virtual arm and a station without a fleet.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { open, waitForAnswer } from "./bench.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
let bench, page;

before(async () => {
  bench = await open({ viewport: { width: 1280, height: 720 } });
  ({ page } = bench);
});
after(() => bench.end());
afterEach(() => assert.deepEqual(bench.errors, []));

test("a phone without a keyboard names no keys under STOP, a computer does", async () => {
  assert.ok(await page.isVisible("#stop-keys"));
  const phone = await bench.visit(PHONE);
  assert.ok(await phone.isVisible("#stop"));
  assert.equal(await phone.isVisible("#stop-keys"), false);
  await phone.context().close();
});

test("a visit of a station without a fleet leaves no error in the console", async () => {
  const context = await page.context().browser().newContext({ serviceWorkers: "block" });
  const visitor = await context.newPage(), errors = [];
  visitor.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  await bench.enter(visitor);
  await visitor.click("#tab-watch");
  await visitor.waitForSelector("#panel canvas");
  assert.deepEqual(errors, []);
  await context.close();
});

test("the reason why the pose is not confirmed is a sentence of its own", async () => {
  assert.match(await page.textContent("#untrusted-why"), /^[A-Z].*\.$/);
  await page.click("#confirm-pose");
  await page.click("#confirm-yes");
  await page.waitForSelector("#confirm-pose", { state: "detached" });
});

test("while a job runs, the plan still shows what it takes, and beside it why it cannot start", async () => {
  await page.click("#tab-draw");
  await page.check("#draw-title ~ .segments input[value=text]", { force: true });
  await page.fill("#draw-text", "Hello, arm");
  await page.waitForSelector("#draw-start:enabled");
  const takes = await page.textContent("#draw-status");
  assert.match(takes, /^Takes /);
  await page.click("#draw-start");
  await waitForAnswer(page, "api/v1/state", ({ job }) => job?.phase === "running");
  await page.waitForFunction(() => document.querySelector("#draw-missing")?.textContent.includes("A job is running"));
  assert.equal(await page.textContent("#draw-status"), takes);
  assert.ok(await page.isDisabled("#draw-start"));
  await page.click("#job-end");
});

test("the first card offers to draw something, and its plan is ready to start", async () => {
  const other = await open({ virtual: true, viewport: { width: 1280, height: 720 } });
  await other.page.click("#first-draw");
  await other.page.waitForFunction(() => document.querySelector("#draw-status")?.textContent.startsWith("Takes "));
  assert.equal(await other.page.inputValue("#draw-text"), "Dobot");
  await other.end();
});
