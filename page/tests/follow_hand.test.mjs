// The arm follows a hand: MediaPipe's files from the npm package in HANDS, a camera that plays pictures of hands (from the package
// `fingerpose`, MIT). None of them is open, so that the arm must not move; what an open hand does is tested with points
// (files/vision/hand.test.js).
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
