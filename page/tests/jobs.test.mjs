// Jobs: what others queued is put in order, done, done again and forgotten by hand, judged on where the arm was sent; recordings:
// where the arm was, on the stage; and packets, as they pass.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { contents, moved, open, passed, pose, rest, takeControl } from "./bench.mjs";

let bench, page, traffic;

before(async () => {
  bench = await open();
  ({ page, traffic } = bench);
  await takeControl(page);
  await rest(page);
  await page.click("#tab-jobs");
});
after(() => bench.end());
afterEach(() => assert.deepEqual(bench.errors, []));

/** A job of another program: targets at these places, on a line above the paper. */
async function queue(title, ...ys_mm) {
  const commands = ys_mm.map((y_mm) => ({ type: "move_to", x_mm: 200, y_mm, z_mm: 50, rotation_deg: 0, suction: false, mode: "movj", gripper_deg: 0, pause_s: 0 }));
  const answer = await fetch(`${bench.url}api/v1/jobs`, { method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify({ title, kind: "program", commands }) });
  return (await answer.json()).job.job;
}

const entry = (job) => `[data-job="${job}"]`;
const act = (job, name) => page.click(`${entry(job)} [data-act=${name}]`);
const waitForText = (job, part) => page.waitForFunction(([entry, part]) => document.querySelector(entry)?.textContent.includes(part), [entry(job), part]);
const listed = async () => (await bench.ask("api/v1/jobs")).map(({ job }) => job);
/** Where the arm was sent in Y, from a packet on. */
const ys = (from) => traffic.targets(from).map((it) => Math.round(it[1]));

test("jobs queued by others are shown in their order, and can be reordered", async () => {
  const [one, two] = [await queue("the first", 10, -10), await queue("the second", 30)];
  await waitForText(two, "queued");
  assert.ok(await page.isDisabled(`${entry(one)} [data-act=up]`), "the first one cannot come earlier");
  await act(two, "up");
  await page.waitForFunction(([two]) => document.querySelector(".entry").matches(two), [entry(two)]);
  assert.deepEqual(await listed(), [two, one]);
});

test("a job is started, the arm goes to its target, and it is run again", async () => {
  const [, job] = await listed();
  const from = traffic.packets.length;
  await act(job, "start");
  await waitForText(job, "done");
  assert.deepEqual(ys(from), [10, -10]);
  const again = traffic.packets.length;
  await act(job, "again");
  await page.waitForFunction(() => document.querySelectorAll("[aria-labelledby=jobs-finished] .entry").length === 2);
  assert.deepEqual(ys(again), [10, -10]);
  const all = await bench.ask("api/v1/jobs");
  assert.deepEqual(all.map(({ title, phase }) => [title, phase]), [["the second", "queued"], ["the first", "done"], ["the first", "done"]]);
});

test("a running job is paused, resumed and cancelled, and its progress is visible meanwhile", async () => {
  const job = await queue("to and fro", ...Array.from({ length: 40 }, (_, n) => (n % 2 ? 40 : -40)));
  await waitForText(job, "queued");
  await act(job, "start");
  await page.waitForFunction((entry) => document.querySelector(`${entry} progress`)?.value > 0, entry(job));
  await act(job, "pause");
  await waitForText(job, "paused");
  await rest(page);
  await passed(page, 0.4);
  await act(job, "start");
  await waitForText(job, "running");
  await act(job, "end");
  await waitForText(job, "stopped");
  assert.ok(ys(0).length < 40, "most of it was not sent");
});

test("finished jobs are deleted, and a refusal is shown at its job", async () => {
  const [waiting, done] = await listed();
  await rest(page);
  await passed(page, 0.4);
  await act(done, "forget");
  await page.waitForSelector(entry(done), { state: "detached" });
  assert.ok(!(await listed()).includes(done));
  await fetch(`${bench.url}api/v1/stop`, { method: "POST" });
  await act(waiting, "start");
  await waitForText(waiting, "stop");
  await page.waitForSelector(`${entry(waiting)} .status[data-tone=bad]`);
});

test("a recording is scrubbed on the stage, is marked as one, and the live arm returns after it", async () => {
  await page.click("#tab-move");
  if (await page.isVisible("#reset")) {
    await page.click("#reset");
    await page.click("#confirm-yes");
    await page.waitForSelector("#stopped", { state: "detached" });
  }
  await rest(page);
  await page.click("#tab-jobs");
  await page.click("[data-recording] [data-act=show]");
  await page.waitForSelector("#recorded");
  assert.equal(await page.textContent("#moving"), "recorded");
  // From where the arm was at first it has been to 40 and -40 mm.
  const seen = [];
  const [from_s, to_s] = await page.evaluate(() => [Number(document.querySelector("#player-time").min), Number(document.querySelector("#player-time").max)]);
  for (let n = 0; n <= 50; n += 1) {
    await page.fill("#player-time", (from_s + ((to_s - from_s) * n) / 50).toFixed(2));
    seen.push(await pose(page, "y_mm"));
  }
  assert.equal(seen[0], 0);
  assert.ok(Math.max(...seen) > 20 && Math.min(...seen) < -20, `${seen}`);
  assert.match(await page.getAttribute("#stage", "aria-label"), /^Recorded arm/);
  const now = (await bench.ask("api/v1/state")).arm.y_mm;
  await page.click("#recorded-end");
  await page.waitForSelector("#recorded", { state: "detached" });
  assert.equal(await pose(page, "y_mm"), Number(now.toFixed(1)));
});

test("a recording plays by itself, and is downloaded unchanged", async () => {
  await page.click("[data-recording] [data-act=show]");
  await page.waitForSelector("#player");
  await page.check("[name=player-speed][value='64']", { force: true });
  await page.click("#player-play");
  await page.waitForFunction(() => Number(document.querySelector("#player-time").value) === Number(document.querySelector("#player-time").max));
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("[data-recording] [data-act=save]")]);
  assert.match(download.suggestedFilename(), /^dobot-.*\.mcap$/);
  const bytes = await contents(download);
  assert.deepEqual([...bytes.subarray(0, 5)], [0x89, ...Buffer.from("MCAP")]);
  await page.click("#recorded-end");
});

test("a long recording is shown coarsely at first, and finely around the selected moment", async () => {
  const name = await page.getAttribute("[data-recording]", "data-recording");
  const { samples } = await bench.ask(`api/v1/recordings/${name}/states?most=5000`);
  const far = samples.reduce((far, it) => (it.y_mm > far.y_mm ? it : far));
  // As of many hours: nothing but where it began and ended.
  await page.route(/states\?most=/, async (route) => {
    const answer = await route.fetch();
    const states = await answer.json();
    await route.fulfill({ json: { ...states, spacing_s: 9, samples: [states.samples[0], states.samples.at(-1)] } });
  });
  await page.click("[data-recording] [data-act=show]");
  await page.waitForSelector("#player");
  await page.fill("#player-time", String(far.at_s));
  await page.waitForFunction((y_mm) => document.querySelector("[data-pose=y_mm]").textContent === y_mm, far.y_mm.toFixed(1));
  await page.click("#recorded-end");
});

/** Jogs by a key on the stage, until the tip has moved. */
async function jog(key) {
  await page.focus("#stage");
  await page.keyboard.down(key);
  await moved(page, "y_mm", 2);
  await page.keyboard.up(key);
  await rest(page);
  await passed(page, 0.4);
}

test("every packet to the arm is shown and exported as it was sent, and the list does not move while it is paused", async () => {
  let asked = 0;
  page.on("request", (request) => (asked += Number(request.url().endsWith("/packets"))));
  await page.click("#tab-watch");
  await page.waitForSelector("#packets");
  assert.equal(asked, 0, "nobody listens before somebody looks");
  await page.click("#packets > summary");
  await page.waitForSelector(".packets [data-way=from_arm]");
  assert.equal(asked, 1);
  await page.check("[name=packets-way][value=to_arm]", { force: true });
  await page.click("#packets-clear");
  const from = traffic.packets.length;
  await jog("ArrowLeft");
  const packetLines = () => page.locator(".packets .says").allTextContents();
  assert.match((await packetLines()).at(-1), /^linear_jog axis y_plus/);
  await page.click("#packets-pause");
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("#packets-save")]);
  const lines = String(await contents(download)).trimEnd().split("\n").map((it) => JSON.parse(it));
  const floats = lines.map(({ bytes }) => Array.from({ length: 10 }, (_, n) => Buffer.from(bytes, "hex").readFloatLE(1 + 4 * n)));
  assert.deepEqual(floats, traffic.packets.slice(from).map((it) => it.floats));

  const paused = await packetLines();
  await jog("ArrowRight");
  assert.deepEqual(await packetLines(), paused);
  await page.click("#packets-pause");
  await page.fill("#packets-filter", "y_minus");
  await page.waitForFunction(() => document.querySelector(".packets .says")?.textContent.includes("y_minus"));
  assert.ok((await packetLines()).every((it) => it.includes("y_minus")));
});
