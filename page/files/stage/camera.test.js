import assert from "node:assert/strict";
import { test } from "node:test";
import { orbit, pan, place, preset, towards, zoom } from "./camera.js";

const TIP = [200, 10, -40];
const distance = (a, b) => Math.hypot(...a.map((it, n) => it - b[n]));
const near = (found, expected) => assert.ok(distance(found, expected) < 1e-6, `${found}, expected ${expected}`);

test("the top view looks straight down, with the base at the bottom of the picture", () => {
  const camera = preset("top", 1.5, TIP);
  const [x, y, z] = place(camera);
  assert.ok(Math.abs(x - camera.at_mm[0]) < 3 && Math.abs(y) < 3 && z > 800);
  assert.ok(x < camera.at_mm[0], "a little behind, so that ahead is up");
});

test("the tool view looks at the tool from near", () => {
  assert.ok(distance(preset("tool", 1.5, TIP).at_mm, TIP) < 20);
  assert.ok(preset("tool", 1.5, TIP).away_mm < preset("iso", 1.5, TIP).away_mm * 0.6);
});

test("in a narrow window the camera is farther away", () => {
  assert.ok(preset("iso", 0.6, TIP).away_mm > 1.5 * preset("iso", 1.6, TIP).away_mm);
});

test("orbiting keeps the distance, and stops over the top and below the table", () => {
  const camera = preset("iso", 1.5, TIP);
  for (const [around, up] of [[40, 10], [-300, 200], [20, -400]]) {
    const turned = orbit(camera, around, up);
    assert.ok(Math.abs(distance(place(turned), turned.at_mm) - camera.away_mm) < 1e-6);
    assert.ok(turned.up_deg < 90 && turned.up_deg >= -8);
  }
});

test("zooming is limited in both directions", () => {
  const camera = preset("iso", 1.5, TIP);
  assert.equal(zoom(camera, 2).away_mm, camera.away_mm / 2);
  assert.equal(zoom(camera, 1e6).away_mm, 160);
  assert.equal(zoom(camera, 1e-6).away_mm, 3200);
});

test("from the side, panning to the right shows things farther to the right", () => {
  const camera = { at_mm: [100, 0, 0], around_deg: -90, up_deg: 0, away_mm: 500 };
  near(pan(camera, 20, 5).at_mm, [120, 0, 5]);
});

test("the transition between two presets begins and ends at them, and turns the shorter way", () => {
  const from = { at_mm: [0, 0, 0], around_deg: 170, up_deg: 0, away_mm: 100 };
  const to = { at_mm: [10, 0, 0], around_deg: -170, up_deg: 40, away_mm: 300 };
  near(place(towards(from, to, 0)), place(from));
  near(place(towards(from, to, 1)), place(to));
  assert.equal(towards(from, to, 0.5).around_deg, 180);
});
