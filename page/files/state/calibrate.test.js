import assert from "node:assert/strict";
import { test } from "node:test";

import { NO_CALIBRATE, nextPoint, numbersOf, pointBlockedReason, questionOf, reduceCalibrate, rawDegrees, touchBlockedReason, touchesOf } from "./calibrate.js";

const SHEET = { points_mm: [[215, 0], [155, 100], [275, 100]] };
const PRINT = { sheet: 417, bar_mm: 189.5 };
const FILE = { zeros: { base: 3, rear: -4, fore: 2 }, tool: { out_mm: 1, left_mm: 0 }, axis: { x_mm: 0, y_mm: 0 }, paper: null, backlash: { base: 0.2, rear: 0, fore: 0 }, touched: null };
const FIT = { calibration: FILE, away_mm: [0.1], wrong: [], left_out: null, tool_mm: [56, 0], expected_mm: 0.2, unsure: [], advice: null, trust: "good" };
const ARM = { base_deg: 1, rear_deg: 45, fore_deg: 45, moving: false, raw: null };
const STATION = { link: { phase: "up" }, arm: ARM, trust: { trusted: true }, queue: { waiting: 0, under_way: 0 } };

const after = (messages, calibrate = NO_CALIBRATE) => messages.reduce(reduceCalibrate, calibrate);
const touched = (base_deg) => ({ type: "calibrate_visited", raw_deg: [base_deg, 45, 45] });
const SKIPPED = { type: "calibrate_visited", raw_deg: null };
const BEGUN = after([{ type: "calibrate_begun", sheet: SHEET }, { type: "calibrate_bar", print: PRINT, problem: null }]);

/** The state after what is told of the touches as they are. */
const fitted = (calibrate) => after([{ type: "calibrate_fitted", revision: calibrate.revision, fit: FIT, problem: null }], calibrate);

test("each touch and each skipped point advances to the next one, and both can be undone", () => {
  const all = after([touched(1), SKIPPED, touched(2)], BEGUN);
  assert.equal(nextPoint(all), 0);
  assert.deepEqual(touchesOf(all).map(({ point }) => point), [0, 2]);
  const back = after([{ type: "calibrate_back" }, { type: "calibrate_back" }], all);
  assert.equal(nextPoint(back), 1);
  assert.equal(after([{ type: "calibrate_back" }], BEGUN), BEGUN);
});

test("the station is asked about the touches with their places, the bar, and the known backlash", () => {
  const known = after([{ type: "calibrations", known: { calibration: FILE, before: null } }, SKIPPED, touched(2)], BEGUN);
  assert.deepEqual(questionOf(known), { touches: [{ place_mm: [155, 100], raw_deg: [2, 45, 45], height_mm: 0 }], ...PRINT, tool_measured: false, backlash: FILE.backlash });
});

test("a block on a point applies to one touch, and an impossible height of a block prevents it", () => {
  const typed = (text) => ({ type: "calibrate_block_typed", text });
  const all = after([typed("40"), touched(1), touched(2)], BEGUN);
  assert.deepEqual(questionOf(all).touches.map(({ height_mm }) => height_mm), [40, 0]);
  const page = (text) => ({ connection: "open", station: STATION, received_ms: 0, now_ms: 0, calibrate: after([typed(text)], BEGUN) });
  for (const text of ["", "0", "40", "100"]) assert.equal(pointBlockedReason(page(text)), null, text);
  for (const text of ["-1", "101"]) assert.equal(pointBlockedReason(page(text)), "no_block", text);
});

test("a refused bar does not advance, and another one is checked again", () => {
  const problem = { title: "", detail: "it is 194 mm long" };
  const refused = after([{ type: "calibrate_bar", print: { ...PRINT, bar_mm: 184 }, problem }], BEGUN);
  assert.deepEqual([refused.print, refused.bar_refused], [null, problem]);
  assert.equal(after([{ type: "calibrate_bar_typed", text: "200" }], refused).bar_refused, null);
});

test("only a shown result can be saved: another touch removes it, and so does undoing one", () => {
  const shown = after([{ type: "calibrate_shown" }], fitted(after([touched(1)], BEGUN)));
  assert.equal(shown.shown, FILE);
  for (const message of [touched(2), { type: "calibrate_back" }, SKIPPED]) assert.deepEqual([after([message], shown).shown, after([message], shown).fit], [null, null]);
  assert.equal(after([{ type: "calibrate_shown" }], BEGUN).shown, null);
});

test("a measured tool is accepted for these touches alone", () => {
  const measured = after([{ type: "calibrate_tool_measured" }], fitted(after([touched(1)], BEGUN)));
  assert.equal(questionOf(measured).tool_measured, true);
  assert.equal(questionOf(after([touched(2)], measured)).tool_measured, false);
});

test("a joint that came from the wrong side prevents a touch", () => {
  const page = (touch_refused) => ({ connection: "open", station: { ...STATION, arm: { ...ARM, touch_refused } }, received_ms: 0, now_ms: 0, calibrate: BEGUN });
  assert.equal(pointBlockedReason(page("the base came from the other side")), "other_side");
  assert.equal(pointBlockedReason(page(undefined)), null);
});

test("an answer about earlier touches is ignored", () => {
  const late = { type: "calibrate_fitted", revision: BEGUN.revision, fit: FIT, problem: null };
  assert.equal(after([touched(1), late], BEGUN).fit, null);
  assert.equal(after([{ type: "calibrate_ended" }, late], BEGUN).fit, null);
});

test("a pose that is no longer trusted makes the touches void, which is shown until the next one", () => {
  const state = (trusted) => ({ type: "state", station: { ...STATION, trust: { trusted } } });
  const all = fitted(after([touched(1), touched(2)], BEGUN));
  assert.equal(after([state(true)], all), all);
  const reset = after([state(false), state(false)], all);
  assert.deepEqual([reset.visits, reset.fit, reset.lost, nextPoint(reset)], [[], null, 2, 0]);
  assert.equal(after([touched(1)], reset).lost, 0);
  assert.equal(after([state(false)], BEGUN), BEGUN);
});

test("leaving forgets everything except known values", () => {
  const known = { calibration: FILE, before: null };
  const left = after([{ type: "calibrations", known }, touched(1), { type: "calibrate_ended" }], BEGUN);
  assert.deepEqual({ ...left, revision: 0 }, { ...NO_CALIBRATE, known });
});

test("numbers are shown with their changes, and those that a calibration does not have are omitted", () => {
  const before = { ...FILE, zeros: { base: 2, rear: -4, fore: 2 } };
  const [base] = numbersOf(FILE, before);
  assert.deepEqual(base, { name: "base", unit: "°", value: 3, by: 1 });
  assert.deepEqual(numbersOf(FILE).map(({ by }) => by), Array(10).fill(null));
  const paper = numbersOf({ ...FILE, paper: { z_mm: -40, slope_x: 0.01, slope_y: 0 } }, FILE).find(({ name }) => name === "slope_x");
  assert.deepEqual(paper, { name: "slope_x", unit: " %", value: 1, by: null });
});

test("a touch is the raw pose of the arm, even if a calibration is known", () => {
  assert.deepEqual(rawDegrees(ARM), [1, 45, 45]);
  assert.deepEqual(rawDegrees({ ...ARM, raw: { base_deg: -2, rear_deg: 49, fore_deg: 43 } }), [-2, 49, 43]);
});

test("a touch is accepted while the arm is at rest and its pose is trusted", () => {
  const why = (change, page = {}) => touchBlockedReason({ connection: "open", received_ms: 0, now_ms: 0, station: { ...STATION, ...change }, ...page });
  assert.equal(why({}), null);
  assert.equal(why({ arm: { ...ARM, moving: true } }), "moving");
  assert.equal(why({ trust: { trusted: false } }), "not_confirmed");
  assert.equal(why({ arm: null }), "no_arm");
  assert.equal(why({}, { connection: "closed" }), "no_connection");
  assert.equal(why({}, { now_ms: 900 }), "no_connection");
});
