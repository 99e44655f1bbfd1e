// Notifications of the browser: asked for when a person wants them, and sent for the end of a job, a pen change and a lost arm.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { open, rest, takeControl, waitForAnswer } from "./bench.mjs";
import { CHROMIUM } from "./browser.mjs";

let bench, page;

/** Keeps each notification; it is sent to the browser all the same. */
function record() {
  window.notified = [];
  const Real = window.Notification;
  window.Notification = class extends Real {
    constructor(title, options) {
      super(title, options);
      window.notified.push(`${title}: ${options.body}`);
      this.addEventListener("error", () => window.notified.push("refused by the browser"));
    }
  };
}

before(async () => {
  bench = await open({ speed: 4, scripts: record, executablePath: CHROMIUM });
  ({ page } = bench);
  await takeControl(page);
  await rest(page);
});
after(() => bench.end());
afterEach(() => assert.deepEqual(bench.errors, []));

/** Runs a program of these steps. */
async function run(title, steps) {
  await page.click("#tab-teach");
  await page.setInputFiles("#teach-file", { name: `${title}.toml`, mimeType: "text/plain", buffer: Buffer.from(`title = "${title}"\n${steps}`) });
  await page.waitForFunction((title) => localStorage.getItem("dobot.program")?.includes(`"${title}"`), title);
  await page.waitForSelector("#teach-once:enabled");
  await page.click("#teach-once");
}
const notified = () => page.evaluate(() => window.notified.splice(0));
const waitForNotification = () => page.waitForFunction(() => window.notified.length > 0);
const STEP = "[[steps]]\ngo = { x = 210, y = 40, z = 40 }\n";

test("without permission the page asks nothing and notifies nobody", async () => {
  await run("silent", STEP);
  await waitForAnswer(page, "api/v1/jobs", (jobs) => jobs.some(({ title, phase }) => title === "silent" && phase === "done"));
  await page.click("#tab-set_up");
  assert.equal(await page.isChecked("#alerts-notify"), false);
  assert.deepEqual(await notified(), []);
});

test("a person who wants notifications gets one when a job is done", async () => {
  await page.context().grantPermissions(["notifications"], { origin: new URL(bench.url).origin });
  await page.reload();
  await page.waitForSelector("#link-chip[data-tone=good]");
  await page.click("#take");
  await page.click("#tab-set_up");
  await page.check("#alerts-notify");
  await run("square", STEP);
  await waitForNotification();
  assert.deepEqual(await notified(), ["Dobot: square is done."]);
});

test("a job that waits for a person sends one notification", async () => {
  await run("asks", `${STEP}[[steps]]\nchoose = "Which side?"\n[[steps.when]]\nanswer = "left"\n[[steps.when.steps]]\ngo = { x = 200, y = 40, z = 40 }\n[[steps.when]]\nanswer = "right"\n[[steps.when.steps]]\ngo = { x = 200, y = -40, z = 40 }\n`);
  await waitForNotification();
  await page.waitForSelector("#job-question button");
  assert.deepEqual(await notified(), ["Dobot: asks waits for you: Which side?"]);
  await page.click("#job-question >> text=left");
  await waitForNotification();
  assert.deepEqual(await notified(), ["Dobot: asks is done."]);
});

test("a lost arm is announced, and the choice is kept for the next visit", async () => {
  await page.reload();
  await page.waitForSelector("#link-chip[data-tone=good]");
  await bench.unplug();
  await waitForNotification();
  assert.deepEqual(await notified(), ["Dobot: The connection to the arm is lost."]);
});
