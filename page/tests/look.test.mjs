// The view Look with a camera that plays rendered photos, judged by the packets to the arm.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, afterEach, before, test } from "node:test";
import { open, rest, takeControl } from "./bench.mjs";
import { readPhoto, renderPhotos, viewIn, writeVideo } from "./photos.mjs";
import { inPicture } from "../files/vision/geometry.js";

/** The height of the wrist with the cup on the paper. */
const PAPER_MM = -60;
/** The height of the cube. */
const CUBE_MM = 25;
let bench, page, traffic, folder, truth, view;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), "look-"));
  const video = join(folder, "camera.y4m");
  const still = renderPhotos(folder, "still", 3);
  writeVideo(video, still);
  ({ truth } = readPhoto(still[0]));
  view = viewIn(still[0]);
  bench = await open({
    browserArgs: ["--use-fake-ui-for-media-stream", "--use-fake-device-for-media-stream", `--use-file-for-fake-video-capture=${video}`],
    scripts: ["window.asked = 0; const { mediaDevices } = navigator; const ask = mediaDevices.getUserMedia.bind(mediaDevices); mediaDevices.getUserMedia = (wish) => { window.asked += 1; return ask(wish); };"],
  });
  ({ page, traffic } = bench);
  await takeControl(page);
  await calibrate();
});
after(async () => {
  await bench?.end();
  rmSync(folder, { recursive: true });
});
afterEach(() => assert.deepEqual(bench.errors, []));

/** Lets the station know where the paper is, as the nine touches do. */
async function calibrate() {
  const calibration = { zeros: { base: 0, rear: 0, fore: 0 }, paper: { z_mm: PAPER_MM, slope_x: 0, slope_y: 0 } };
  const answer = await fetch(new URL("api/v1/calibration", bench.url), { method: "PUT", headers: { "content-type": "application/json" }, body: JSON.stringify({ calibration }) });
  assert.ok(answer.ok, await answer.text());
}

const waitForStatus = (part) => page.waitForFunction((part) => document.querySelector("#look-status")?.textContent.includes(part), part);

/** Clicks the picture where it shows a place of the sheet. */
async function clickPlace(place) {
  await page.locator("#look-picture").scrollIntoViewIfNeeded();
  const box = await page.locator("#look-picture").boundingBox();
  const [x, y] = inPicture(view, place);
  await page.mouse.click(box.x + (x / 640) * box.width, box.y + (y / 480) * box.height);
}

test("the camera is asked for when the view opens, not before", async () => {
  assert.equal(await page.evaluate(() => window.asked), 0);
  await page.click("#tab-look");
  await waitForStatus("Accurate to about");
  assert.equal(await page.evaluate(() => window.asked), 1);
  assert.deepEqual(traffic.targets(), []);
});

test("a click in the picture moves the tool above that place, and down only after a second click", async () => {
  const from = traffic.packets.length, wanted = [230, -40];
  await clickPlace(wanted);
  const first = await traffic.next(from, ({ floats: [state] }) => state === 3);
  const [, , x, y, z] = first.floats;
  assert.ok(Math.hypot(x - wanted[0], y - wanted[1]) < 1.5, `${x}, ${y}`);
  assert.ok(Math.abs(z - (PAPER_MM + 25)) < 0.01, String(z));
  await page.waitForFunction(() => !document.querySelector("#look-down").disabled);
  assert.equal(traffic.targets(from).length, 1);
  await rest(page);
  await page.click("#look-down");
  const second = await traffic.next(from, ({ floats: [state, , , , z] }) => state === 3 && z < PAPER_MM + 1);
  assert.ok(Math.abs(second.floats[4] - PAPER_MM) < 0.01);
  await page.waitForFunction((z) => Math.abs(Number(document.querySelector("[data-pose=z_mm]").textContent) - z) < 0.15, PAPER_MM);
  await rest(page);
});

test("what the camera caused is marked as such in the log of the station", async () => {
  const { notices } = await bench.ask("api/v1/notices").then((all) => ({ notices: Array.isArray(all) ? all : all.notices }));
  assert.ok(notices.some(({ type, text }) => type === "sensed" && text.includes("camera: move to x 2")), JSON.stringify(notices.slice(-5)));
});

test("an object is picked up where it is seen, once its height is known", async () => {
  const pick = "[data-thing='marker 7'] [data-act=pick]";
  await page.waitForSelector(pick);
  assert.equal(await page.isDisabled(pick), true);
  await page.fill("[data-thing='marker 7'] input", String(CUBE_MM));
  await page.keyboard.press("Tab");
  await page.waitForFunction((pick) => !document.querySelector(pick).disabled, pick);
  const from = traffic.packets.length;
  await page.click(pick);
  const down = await traffic.next(from, ({ floats: [state, , , , z] }) => state === 3 && Math.abs(z - (PAPER_MM + CUBE_MM)) < 0.1);
  assert.ok(down, JSON.stringify(traffic.targets(from)));
  const [cube] = truth.objects;
  assert.ok(Math.hypot(down.floats[2] - cube.x_mm, down.floats[3] - cube.y_mm) < 1, String(down.floats));
  await page.waitForFunction(() => !document.querySelector("[data-thing='marker 7'] [data-act=pick]").disabled);
  await bench.ask("api/v1/jobs").then((jobs) => assert.ok((jobs.jobs ?? jobs).some(({ title }) => title === "camera: pick up marker 7")));
});

test("a program that asks where a marker is gets the answer only after a person allows it", async () => {
  await page.waitForFunction(() => !document.querySelector("[data-thing='marker 7'] [data-act=pick]").disabled);
  const text = 'title = "fetch"\n[[steps]]\ngo = { x = 200, y = 0, z = 0 }\npath = "movj"\n[[steps]]\ngo = { from = "seen", marker = 7 }\n';
  const made = await fetch(new URL("api/v1/programs/jobs", bench.url), { method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify({ program: { text, files: {} } }) });
  const answer = await made.json();
  assert.ok(answer.job, JSON.stringify(answer));
  const { job } = answer;
  const from = traffic.packets.length;
  await page.click("#tab-jobs");
  await page.click(`[data-job='${job.job}'] [data-act=start]`);
  await page.click("#tab-look");
  await page.waitForSelector("#job-question");
  await page.waitForSelector("[data-thing='marker 7']");
  await rest(page);
  assert.deepEqual(traffic.targets(from), [[200, 0, 0]]);
  await page.click("#look-answers");
  const [cube] = truth.objects;
  const packet = await traffic.next(from, ({ floats: [state, , , y] }) => state === 3 && y > 1);
  assert.ok(Math.abs(packet.floats[4] - (PAPER_MM + CUBE_MM)) < 0.1);
  assert.ok(Math.hypot(packet.floats[2] - cube.x_mm, packet.floats[3] - cube.y_mm) < 1);
  const notices = await bench.ask("api/v1/notices").then((all) => all.notices ?? all);
  assert.ok(notices.some(({ type, text }) => type === "job_answered" && /camera: x \d+\.\d y \d+\.\d z -\d+\.\d$/.test(text)), JSON.stringify(notices.slice(-5)));
  await page.waitForFunction(() => document.querySelector("#look-status")?.dataset.tone === "good");
  await page.click("#look-answers");
});

test("the camera is off after the view closes", async () => {
  await page.evaluate(() => (window.seen = document.querySelector("#look-video").srcObject.getTracks()));
  await page.click("#tab-move");
  await page.waitForSelector("#look-video", { state: "detached" });
  assert.deepEqual(await page.evaluate(() => window.seen.map(({ readyState }) => readyState)), ["ended"]);
  await page.click("#tab-look");
  await waitForStatus("Accurate to about");
});
