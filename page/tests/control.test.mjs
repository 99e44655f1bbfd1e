// Every button that starts or resumes something takes control if nobody has it, once, and keeps the keyboard focus.
import assert from "node:assert/strict";
import { after, afterEach, before, beforeEach, test } from "node:test";
import { open, passed, rest, takeControl, waitForAnswer } from "./bench.mjs";

let bench, page;

before(async () => {
  bench = await open();
  ({ page } = bench);
  await takeControl(page);
});
after(() => bench.end());
beforeEach(async () => {
  await rest(page);
  await passed(page, 0.4);
});
afterEach(async () => {
  const { job } = await bench.ask("api/v1/state");
  if (job) await page.click("#job-end");
  await waitForAnswer(page, "api/v1/state", ({ job, arm }) => !job && !arm.moving);
  assert.equal(await page.isVisible("#problem"), false, "nothing was refused");
  assert.deepEqual(bench.errors, []);
});

// Long enough that no test on a busy machine comes too late to end it.
const PROGRAM = `title = "sides"\n${Array(20).fill([40, -40]).flat().map((y) => `[[steps]]\ngo = { x = 200, y = ${y}, z = 50 }\n`).join("")}`;
const phase = (name) => waitForAnswer(page, "api/v1/state", ({ job }) => job?.phase === name);
const free = async () => {
  if (await page.isVisible("#release")) await page.click("#release");
  await page.waitForSelector("#take");
};

/** Queues a job that goes to and fro for a while. */
async function queue(title = "to and fro") {
  const commands = Array.from({ length: 40 }, (_, n) => ({ type: "move_to", x_mm: 200, y_mm: n % 2 ? 40 : -40, z_mm: 50, rotation_deg: 0, suction: false, mode: "movj", gripper_deg: 0, pause_s: 0 }));
  const answer = await fetch(`${bench.url}api/v1/jobs`, { method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify({ title, kind: "program", commands }) });
  return (await answer.json()).job.job;
}

async function running() {
  const job = await queue();
  await page.click("#tab-jobs");
  await page.click(`[data-job="${job}"] [data-act=start]`);
  await phase("running");
  return job;
}

test("Resume in the footer takes control after a reload", async () => {
  await running();
  await bench.enter(page);
  await page.waitForSelector("#take");
  await page.click("#pause");
  await phase("paused");
  await waitForAnswer(page, "api/v1/state", ({ arm }) => !arm.moving);
  await passed(page, 0.4);
  await page.click("#resume");
  await phase("running");
  await page.waitForFunction(() => document.querySelector("#holder").textContent === "You have control.");
});

test("the speed and the height of a job are set without control, and take it", async () => {
  await running();
  await bench.enter(page);
  await page.waitForSelector("#take");
  assert.equal(await page.isDisabled("#job-higher"), false);
  await page.click("#job-higher");
  await waitForAnswer(page, "api/v1/state", ({ lease }) => lease !== null);
  // A program has no height: the refusal says so, and says nothing of control.
  await page.waitForSelector("#problem");
  assert.doesNotMatch(await page.textContent("#problem"), /control/);
  await page.click("#problem-close");
});

test("a program runs, loops and steps without control", async () => {
  await page.click("#tab-teach");
  await page.check("[name=teach-mode][value=text]", { force: true });
  await page.fill("#teach-text", PROGRAM);
  for (const id of ["teach-once", "teach-loop", "teach-step"]) {
    await free();
    await page.waitForSelector(`#${id}:enabled`);
    await page.click(`#${id}`);
    await waitForAnswer(page, "api/v1/state", ({ job }) => job !== null && job !== undefined);
    await page.click("#job-end");
    await waitForAnswer(page, "api/v1/state", ({ job, arm }) => !job && !arm.moving);
    await passed(page, 0.4);
  }
});

test("a double click on a start button starts one job", async () => {
  await page.click("#tab-teach");
  await page.waitForSelector("#teach-once:enabled");
  const before = (await bench.ask("api/v1/jobs")).length;
  await page.dblclick("#teach-once");
  await phase("running");
  assert.equal((await bench.ask("api/v1/jobs")).length, before + 1);
  assert.equal(await page.isVisible("#problem"), false);
});

test("a job that cannot be started is removed", async () => {
  const before = await bench.ask("api/v1/jobs");
  await page.click("#tab-teach");
  await page.waitForSelector("#teach-once:enabled");
  // Stopped by another client, between what the page knows and what it asks for.
  await page.evaluate(() => {
    // The thread of the connection gets what the page sends.
    const { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (message) {
      if (!message.text?.includes("start_job")) return postMessage.call(this, message);
      Worker.prototype.postMessage = postMessage;
      void fetch("api/v1/stop", { method: "POST" }).then(() => postMessage.call(this, message));
    };
  });
  await page.click("#teach-once");
  await page.waitForSelector("#teach-problems .status");
  await waitForAnswer(page, "api/v1/jobs", (all) => all.length === before.length);
  await page.click("#reset");
  await page.click("#confirm-yes");
  await page.waitForSelector("#stopped", { state: "detached" });
});

test("with the keyboard alone, Space pauses and resumes, and does not stop the arm", async () => {
  await running();
  await page.focus("#tab-jobs");
  await page.keyboard.press("Tab");
  await page.focus("#pause");
  for (const next of ["paused", "running", "paused"]) {
    await page.keyboard.press(" ");
    await phase(next);
    await waitForAnswer(page, "api/v1/state", ({ arm, job }) => job.phase === "running" || !arm.moving);
    await passed(page, 0.4);
    assert.match(await page.evaluate(() => document.activeElement.id), /pause|resume/);
  }
  assert.equal(await page.isVisible("#stopped"), false);
});

test("with the keyboard alone, the button of a job in the list keeps the focus as its meaning changes", async () => {
  const job = await queue("by keys");
  await page.click("#tab-jobs");
  await page.waitForSelector(`[data-job="${job}"]`);
  await page.keyboard.press("Tab");
  await page.focus(`[data-job="${job}"] [data-act=start]`);
  for (const [key, next] of [[" ", "running"], [" ", "paused"]]) {
    await page.keyboard.press(key);
    await phase(next);
    await page.waitForFunction(([job, act]) => document.activeElement?.dataset.act === act && document.activeElement.closest(`[data-job="${job}"]`), [job, next === "running" ? "pause" : "start"]);
  }
  await rest(page);
  assert.equal(await page.isVisible("#stopped"), false);
});
