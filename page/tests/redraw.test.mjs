// What the page draws, and when: frames of the stage are counted at the WebGL draw calls.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { waitForAnswer, open, passed } from "./bench.mjs";
import { drawn } from "./browser.mjs";

const SIZE = { width: 640, height: 400 };

let bench, page;

before(async () => {
  bench = await open({ virtual: true, webgl: true, viewport: SIZE, scripts: countDraws });
  ({ page } = bench);
});
after(async () => {
  assert.deepEqual(bench.errors, []);
  await bench.end();
});

/** Counts the frames in which WebGL draws. */
function countDraws() {
  window.draws = [];
  let frame = 0, last = -1;
  const request = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (action) => request((now_ms) => {
    frame += 1;
    action(now_ms);
  });
  for (const name of ["drawArrays", "drawElements", "drawArraysInstanced", "drawElementsInstanced"]) {
    const draw = WebGL2RenderingContext.prototype[name];
    WebGL2RenderingContext.prototype[name] = function (...all) {
      if (frame !== last) window.draws.push(performance.now());
      last = frame;
      return draw.apply(this, all);
    };
  }
}

/** Counts the shaders that each task of the page compiles. */
function countPrograms() {
  window.programs = [];
  let isSameTask = false;
  const { port1, port2 } = new MessageChannel();
  port1.onmessage = () => (isSameTask = false);
  const { linkProgram } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.linkProgram = function (...all) {
    if (!isSameTask) {
      window.programs.push(0);
      port2.postMessage(0);
    }
    isSameTask = true;
    window.programs[window.programs.length - 1] += 1;
    return linkProgram.apply(this, all);
  };
}

/** A screen that is four times as fast as most. */
function quicken() {
  let asked = 0;
  const due = new Map();
  window.requestAnimationFrame = (action) => {
    due.set(asked += 1, action);
    return asked;
  };
  window.cancelAnimationFrame = (frame) => due.delete(frame);
  const channel = new MessageChannel();
  let last = 0;
  channel.port1.onmessage = () => {
    const now_ms = performance.now();
    if (now_ms - last >= 1000 / 240) {
      last = now_ms;
      for (const [frame, action] of [...due]) if (due.delete(frame)) action(now_ms);
    }
    setTimeout(() => channel.port2.postMessage(0), 1);
  };
  channel.port2.postMessage(0);
}

const draws = (page) => page.evaluate(() => window.draws);

/** Sends the arm to a place, and waits until it is there. */
async function go(y_mm) {
  const command = { type: "move_to", x_mm: 200, y_mm, z_mm: 40, rotation_deg: 0, suction: false, mode: "movj", gripper_deg: 0, pause_s: 0 };
  const headers = { "content-type": "application/json" };
  const post = (path, body, more) => fetch(new URL(path, bench.url), { method: "POST", headers: { ...headers, ...more }, body: JSON.stringify(body) });
  const { token } = await (await post("api/v1/lease", { name: "redraw.test" })).json();
  const answer = await post("api/v1/commands", { command }, { "dobot-lease": token });
  assert.ok(answer.ok, await answer.text());
  await waitForAnswer(page, "api/v1/state", ({ arm, queue }) => Math.abs(arm.y_mm - y_mm) < 0.1 && !arm.moving && queue.waiting + queue.under_way === 0);
  await fetch(new URL("api/v1/lease", bench.url), { method: "DELETE", headers: { "dobot-lease": token } });
}

test("nothing is drawn while the arm is at rest, although its station keeps reporting", async () => {
  await page.waitForSelector("#stage[data-shown='3d']");
  await drawn(page);
  // On a busy computer the page is not complete at once.
  const counts = [(await draws(page)).length];
  assert.ok(counts[0] > 0, "it was drawn at first");
  do {
    await passed(page, 2);
    counts.unshift((await draws(page)).length);
  } while (counts[0] !== counts[1] && counts.length < 6);
  assert.equal(counts[0], counts[1], `frames, the last first: ${counts}`);
});

test("three dimensions are prepared in many small tasks, between which the page hears STOP", async () => {
  const fresh = await bench.visit({ viewport: SIZE, webgl: true }, countPrograms);
  await fresh.waitForSelector("#stage[data-shown='3d']");
  const programs = await fresh.evaluate(() => window.programs);
  const all = programs.reduce((sum, n) => sum + n, 0);
  assert.ok(Math.max(...programs) <= all / 2, `shaders compiled in each task: ${programs}`);
  await fresh.context().close();
});

test("a moving arm is drawn, at most 60 times per second on a faster screen", async () => {
  const fast = await bench.visit({ viewport: SIZE }, [quicken, countDraws]);
  await fast.waitForSelector("#stage[data-shown='3d']");
  await fast.evaluate(() => window.draws.splice(0));
  for (const y_mm of [60, -60, 60]) {
    await go(y_mm);
    await fast.waitForFunction((text) => document.querySelector("[data-pose=y_mm]").textContent === text, y_mm.toFixed(1), { polling: 20 });
  }
  const times = await draws(fast);
  assert.ok(times.length > 2, `${times.length} frames`);
  // Each second that begins with a frame.
  const most = Math.max(...times.map((from) => times.filter((it) => it >= from && it < from + 1000).length));
  assert.ok(most <= 61, `${most} frames in a second`);
  await fast.context().close();
});

test("a hidden page draws nothing, and shows the current pose when it is visible again", async () => {
  await drawn(page);
  // No page of a browser without a screen is ever hidden, so that it has to be told.
  const hide = (hidden) => page.evaluate((hidden) => {
    Object.defineProperty(document, "hidden", { configurable: true, get: () => hidden });
    document.dispatchEvent(new Event("visibilitychange"));
  }, hidden);
  await hide(true);
  const before = (await draws(page)).length;
  await go(-60);
  await page.waitForFunction(() => document.querySelector("[data-pose=y_mm]").textContent === "-60.0");
  assert.equal((await draws(page)).length, before);
  await hide(false);
  await page.waitForFunction((before) => window.draws.length > before, before);
});
