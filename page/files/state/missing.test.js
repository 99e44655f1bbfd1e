import assert from "node:assert/strict";
import { test } from "node:test";
import { isBlocking, missingFor } from "./missing.js";
import { begin } from "./state.js";

const STATION = { link: { phase: "up", address: "/dev/ttyUSB0" }, trust: { trusted: true }, lease: null, stop: null, lock: null, job: null, laser: { armed_for_s: 0 }, settings: [] };

/** A page with a planned drawing, at a real arm. */
function planned({ burns = false, down = "", paper = null, station = {} } = {}) {
  const page = begin({ language: "en", theme: "auto", greeted: true, program: "" });
  const plan = { burns };
  return { ...page, connection: "open", me: 1, role: "admin", station: { ...STATION, ...station }, draw: { ...page.draw, paper, set: { ...page.draw.set, down }, planned: { plan } } };
}

test("a pen needs a height, and a drawing can start without it", () => {
  assert.deepEqual(missingFor(planned()), ["no-height"]);
  assert.deepEqual(missingFor(planned({ down: "-40" })), []);
  assert.deepEqual(missingFor(planned({ paper: { z_mm: -40 } })), []);
  assert.equal(isBlocking("no-height"), false);
});

test("a laser needs to be mounted and armed, and a drawing cannot start before it is armed", () => {
  assert.deepEqual(missingFor(planned({ burns: true })), ["not-laser", "laser-disarmed"]);
  const mounted = [{ type: "configuration", mode: "end_effector", tool: "laser" }];
  assert.deepEqual(missingFor(planned({ burns: true, station: { settings: mounted } })), ["laser-disarmed"]);
  assert.deepEqual(missingFor(planned({ burns: true, station: { settings: mounted, laser: { armed_for_s: 90 } } })), []);
  assert.equal(isBlocking("laser-disarmed"), true);
});

test("what blocks every motion comes first", () => {
  assert.deepEqual(missingFor(planned({ station: { stop: { at_rest: true } } })), ["stopped", "no-height"]);
  assert.deepEqual(missingFor(planned({ down: "-40", station: { lease: { client: 2 } } })), ["others_control"]);
  assert.equal(isBlocking("stopped"), true);
});
