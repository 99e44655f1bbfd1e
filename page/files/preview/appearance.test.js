import assert from "node:assert/strict";
import { test } from "node:test";
import { EDGE, boundsOf, clock, errorNames, heightFor, inkOfColumns, lookOfErrors, lookOfPasses, passName, roundLength, viewOf } from "./appearance.js";
import { translator } from "../i18n/i18n.js";
import { readTimeline } from "./timeline.js";
import { sample } from "./sample.test.js";

const timeline = readTimeline(JSON.stringify(sample()));

test("bounds include every row, even of travel moves", () => {
  assert.deepEqual(boundsOf(timeline), { x: [200, 210], y: [-20, 20] });
});

test("the view is that of a person behind the arm: X up, Y to the left", () => {
  const view = viewOf(boundsOf(timeline), { width: 400, height: 300, ratio: 2 });
  assert.ok(view.x(20) < view.x(-20));
  assert.ok(view.y(210) < view.y(200));
});

test("a drawing fills the width or the height, whichever is scarcer, and stays within the edges", () => {
  const bounds = boundsOf(timeline);
  const wide = viewOf(bounds, { width: 400, height: 300, ratio: 1 });
  // 40 mm lie between the edges.
  assert.equal(wide.scale, (400 - 2 * EDGE) / 40);
  assert.equal(wide.x(20), EDGE);
  assert.equal(wide.x(-20), 400 - EDGE);
  const low = viewOf(bounds, { width: 4000, height: 300, ratio: 1 });
  assert.ok(Math.abs(low.y(210) - EDGE) < 1e-9, `${low.y(210)} is not ${EDGE}`);
});

test("a single point has a view, too", () => {
  const view = viewOf({ x: [200, 200], y: [0, 0] }, { width: 300, height: 300, ratio: 1 });
  assert.equal(view.x(0), 150);
  assert.ok(Number.isFinite(view.y(200)));
});

test("the height of a canvas follows the drawing, from 220 pixels to the maximum", () => {
  assert.equal(heightFor({ x: [0, 1], y: [0, 100] }, 800, 500), 220);
  assert.equal(heightFor({ x: [0, 100], y: [0, 1] }, 800, 500), 500);
  const square_px = heightFor({ x: [0, 100], y: [0, 100] }, 400, 1000);
  assert.equal(viewOf({ x: [0, 100], y: [0, 100] }, { width: 400, height: square_px, ratio: 1 }).scale, (400 - 2 * EDGE) / 100);
});

test("lengths of the scale are one, two or five times a power of ten, the longest that fits", () => {
  for (const [most, expected] of [[1, 1], [1.9, 1], [2, 2], [4.9, 2], [7, 5], [10, 10], [99, 50], [0.3, 0.2]]) {
    assert.ok(Math.abs(roundLength(most) - expected) < 1e-12, `${roundLength(most)} for ${most}, expected ${expected}`);
  }
});

test("ink has the colour of its pass, and light colours are darkened", () => {
  const { styles, classes } = lookOfPasses(timeline);
  assert.equal(styles[0].color, "rgb(10, 20, 30)");
  const light = lookOfPasses({ ...timeline, passes: [{ name: "", tool: "pen", color: [255, 255, 255] }] }).styles[0].color;
  assert.equal(light, "rgb(130, 130, 130)");
  assert.equal(classes, timeline.path.pass);
});

test("a pass without a colour has one that its neighbours do not have", () => {
  const passes = Array.from({ length: 8 }, () => ({ name: "", tool: "pen", color: null }));
  const colors = lookOfPasses({ ...timeline, passes }).styles.map((it) => it.color);
  assert.equal(new Set(colors).size, 8);
});

test("errors have three classes: half of the tolerance, all of it, more", () => {
  const path = { ...timeline.path, error_mm: Float32Array.of(0, 0.025, 0.026, 0.05, 0.051, 3) };
  assert.deepEqual([...lookOfErrors({ ...timeline, path }, 0.05).classes], [0, 0, 1, 1, 2, 2]);
  assert.deepEqual(errorNames(translator("en"), 0.05), ["error 0 to 0.025 mm", "up to 0.05 mm (tolerance)", "larger"]);
});

test("times are minutes and seconds, and hours where there are any", () => {
  for (const [seconds, text] of [[0, "0:00"], [59.4, "0:59"], [59.5, "1:00"], [65, "1:05"], [3600, "1:00:00"], [7384, "2:03:04"]]) {
    assert.equal(clock(seconds), text);
  }
});

test("a pass has its name, truncated if long, or else its number", () => {
  assert.equal(passName(translator("en"), { name: "sky", tool: "pen" }, 0), "sky");
  assert.equal(passName(translator("en"), { name: "", tool: "laser" }, 1), "pass 2 (laser)");
  assert.equal(passName(translator("en"), { name: "x".repeat(61), tool: "pen" }, 0), `${"x".repeat(60)}…`);
});

test("the strip marks the times with ink and not those of travel moves", () => {
  // Rows at 0, 1, 3 and 4 s; the line is drawn from 1 s to 3 s.
  assert.deepEqual([...inkOfColumns(timeline, lookOfPasses(timeline), 5)], [-1, 0, 0, 0, -1]);
});

test("a drawing without duration has no ink in its strip", () => {
  assert.deepEqual([...inkOfColumns({ ...timeline, duration_s: 0 }, lookOfPasses(timeline), 3)], [-1, -1, -1]);
});
