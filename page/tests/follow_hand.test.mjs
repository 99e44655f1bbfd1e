// The arm follows a hand: with a worker that sees an open hand; and with MediaPipe's files from the npm package in HANDS and a camera
// that plays pictures of hands (HAND_VIDEO, see tests/hands). None of those is open, so that the arm must not move.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";
import { open, takeControl } from "./bench.mjs";

const { HANDS, HAND_VIDEO, DOBOT } = process.env;

test("without the optional part the page says how to install it, and asks for no camera", async () => {
  const bench = await open({ scripts: ["window.asked = 0; const { mediaDevices } = navigator; mediaDevices.getUserMedia = () => { window.asked += 1; return Promise.reject(new Error()); };"] });
  try {
    await takeControl(bench.page);
    await bench.page.click("#hands summary");
    await bench.page.waitForFunction(() => document.querySelector("#hands-status")?.textContent.includes("dobot extras"));
    assert.equal(await bench.page.evaluate(() => window.asked), 0);
    assert.deepEqual(bench.errors, []);
  } finally {
    await bench.end();
  }
});

/** A worker that sees an open hand, which moves to the right after a while and is then taken away. */
const SEES = `
const OPEN = [[0, 0], [0.35, 0.2], [0.6, 0.45], [0.8, 0.65], [0.95, 0.8], [0.3, 0.95], [0.38, 1.35], [0.42, 1.6], [0.45, 1.8], [0, 1], [0, 1.45], [0, 1.75], [0, 1.95], [-0.25, 0.95], [-0.3, 1.35], [-0.33, 1.6], [-0.35, 1.8], [-0.45, 0.85], [-0.58, 1.15], [-0.65, 1.35], [-0.7, 1.5]];
let first = null, x = 0.5;
addEventListener("message", ({ data }) => {
  if (data.files) return postMessage({ ready: true });
  first ??= data.at_ms;
  data.picture.close();
  const seen_ms = data.at_ms - first;
  if (seen_ms > 1500) x = Math.min(0.6, x + 0.005);
  const points = OPEN.map(([a, b]) => [x + a * 0.15, 0.8 - b * 0.15 * (4 / 3), 0]);
  postMessage({ at_ms: data.at_ms, hands: seen_ms > 6000 ? [] : [{ score: 0.95, points }] });
});`;

test("an open hand moves the arm to the left with it, marked as a hand's, and without it nothing more is sent", async () => {
  const bench = await open({ browserArgs: ["--use-fake-ui-for-media-stream", "--use-fake-device-for-media-stream"] });
  try {
    const { page, traffic } = bench;
    await page.context().route("**/api/v1/extras", (route) => route.fulfill({ json: ["hands"] }));
    await page.context().route("**/vision/hands_worker.js", (route) => route.fulfill({ body: SEES, contentType: "text/javascript" }));
    await takeControl(page);
    const from = traffic.packets.length;
    await page.click("#hands summary");
    const isHand = ({ floats: [state] }) => state === 8;
    assert.ok(await traffic.next(from, isHand, 30_000));
    await page.waitForFunction(() => document.querySelector("#hands-picture")?.dataset.state === "none", undefined, { timeout: 60_000 });
    const packets = traffic.packets.slice(from).filter(isHand);
    assert.ok(packets.length > 3, String(packets.length));
    // A person's left is on the right of the picture.
    const ys = packets.map(({ floats }) => floats[3]);
    assert.ok(Math.abs(ys.at(-1) - ys[0]) > 1, String(ys));
    await page.waitForFunction(() => Number(document.querySelector("[data-pose=y_mm]").textContent.replace("−", "-")) > 1);
    const { notices } = await bench.ask("api/v1/notices").then((all) => ({ notices: all.notices ?? all }));
    assert.ok(notices.some(({ type, text }) => type === "sensed" && text.includes("hand: x ")), JSON.stringify(notices.slice(-3)));
    assert.ok(packets.at(-1).at - packets[0].at > 80 * (packets.length - 1), "at most ten a second");
    const last = traffic.packets.length;
    await page.click("#hands summary");
    assert.equal(traffic.packets.slice(last).filter(isHand).length, 0);
    assert.deepEqual(bench.errors, []);
  } finally {
    await bench.end();
  }
});

test("hands that are not open are found, and move nothing", { skip: !HANDS || !HAND_VIDEO ? "set HANDS and HAND_VIDEO" : false }, async () => {
  const bench = await open({ browserArgs: ["--use-fake-ui-for-media-stream", "--use-fake-device-for-media-stream", `--use-file-for-fake-video-capture=${HAND_VIDEO}`, "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"] });
  try {
    execFileSync(DOBOT, ["extras", "install", "hands", HANDS, "--data", bench.folder]);
    const { page, traffic } = bench;
    await takeControl(page);
    const from = traffic.packets.length;
    await page.click("#hands summary");
    await page.waitForFunction(() => document.querySelector("#hands-picture")?.dataset.state === "other", undefined, { timeout: 120_000 });
    assert.match(await page.textContent("#hands-status"), /Open your hand/);
    const moved = traffic.packets.slice(from).filter(({ floats: [state] }) => state === 8 || state === 3);
    assert.deepEqual(moved, []);
    assert.deepEqual(bench.errors, []);
  } finally {
    await bench.end();
  }
});
