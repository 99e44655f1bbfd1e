import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { createHand, measure } from "./hand.js";

const ASPECT = 4 / 3;
/** Landmarks that MediaPipe found in pictures of hands. */
const recorded = JSON.parse(readFileSync(new URL("hand.test.json", import.meta.url), "utf8"));

/** An open hand, upright, its palm a fifth of the picture high: points in palms from its wrist, y up. */
const OPEN = [
  [0, 0], [0.35, 0.2], [0.6, 0.45], [0.8, 0.65], [0.95, 0.8],
  [0.3, 0.95], [0.38, 1.35], [0.42, 1.6], [0.45, 1.8],
  [0, 1], [0, 1.45], [0, 1.75], [0, 1.95],
  [-0.25, 0.95], [-0.3, 1.35], [-0.33, 1.6], [-0.35, 1.8],
  [-0.45, 0.85], [-0.58, 1.15], [-0.65, 1.35], [-0.7, 1.5],
];
const tips = (points, change) => points.map((point, n) => change[n] ?? point);
const PINCH = tips(OPEN, { 3: [0.5, 0.9], 4: [0.45, 1.15], 7: [0.55, 1.35], 8: [0.5, 1.2] });
const FIST = tips(OPEN, { 4: [0.1, 0.7], 8: [0.3, 0.6], 12: [0, 0.6], 16: [-0.2, 0.6], 20: [-0.4, 0.6] });

const hand = (points = OPEN, { at = [0.5, 0.7], size = 0.2, score = 0.95 } = {}) => ({ score, points: points.map(([x, y]) => [at[0] + x * size, at[1] - y * size * ASPECT, 0]) });

/** Shows pictures 50 ms apart; returns what they mean. */
function show(look, from_ms, hands) {
  return hands.map((of, n) => look({ at_ms: from_ms + 50 * n, hands: [of].flat().filter(Boolean), aspect: ASPECT }));
}
const times = (count, of) => Array.from({ length: count }, () => of);

/** A hand that has taken control, at 550 ms. */
function controlling() {
  const look = createHand();
  assert.equal(show(look, 0, times(11, hand())).at(-1).state, "controls");
  return look;
}

test("an open hand takes control after half a second, not before", () => {
  const meanings = show(createHand(), 0, times(11, hand()));
  assert.ok(meanings.slice(0, 10).every(({ state, movement }) => state === "opening" && movement === null));
  assert.deepEqual(meanings[10], { state: "controls", share: 1, movement: { left_mm: 0, up_mm: 0, closed: false } });
});

test("a fist, a pinch and every recorded hand that is not open take no control", () => {
  const others = [FIST, PINCH].map((points) => hand(points)).concat(recorded.map(({ score, points }) => ({ score: Math.max(score, 0.9), points })));
  assert.ok(others.length > 3);
  for (const other of others) for (const { state, movement } of show(createHand(), 0, times(30, other))) assert.deepEqual([state, movement], ["other", null]);
});

test("a hand that closes for a moment starts its half second again", () => {
  const states = show(createHand(), 0, [...times(8, hand()), hand(FIST), ...times(10, hand())]).map(({ state }) => state);
  assert.ok(!states.includes("controls"));
});

test("the movement since it took control is the arm's: right of the picture is the person's left, up is up", () => {
  const look = controlling();
  const [{ movement }] = show(look, 550, [hand(OPEN, { at: [0.6, 0.6] })]);
  assert.ok(Math.abs(movement.left_mm - 30) < 0.01, String(movement.left_mm));
  assert.ok(Math.abs(movement.up_mm - 0.1 / ASPECT * 300) < 0.01, String(movement.up_mm));
});

test("a pinch closes until thumb and finger are well apart", () => {
  const look = controlling();
  const half = tips(OPEN, { 4: [0.6, 1.3], 8: [0.5, 1.7] });
  const closed = show(look, 550, [hand(), hand(PINCH), hand(half), hand()]).map(({ movement }) => movement.closed);
  assert.deepEqual(closed, [false, true, true, false]);
});

for (const [why, hands, state] of [["two hands", [[hand(), hand(OPEN, { at: [0.2, 0.7] })]], "several"], ["no hand", [[]], "none"], ["an uncertain hand", [hand(OPEN, { score: 0.69 })], "unsure"], ["a hand with a point that is no number", [{ ...hand(), points: hand().points.map(() => [NaN, 0]) }], "unsure"]]) {
  test(`${why} sends nothing, and an open hand has to be held again`, () => {
    const look = controlling();
    const lost = show(look, 550, times(8, hands[0]));
    assert.ok(lost.every((it) => it.state === state && it.movement === null));
    assert.deepEqual(show(look, 950, [hand()])[0], { state: "opening", share: 0, movement: null });
  });
}

test("a hand that was lost for two pictures keeps control", () => {
  const look = controlling();
  assert.deepEqual(show(look, 550, [[], [], hand()]).map(({ state }) => state), ["none", "none", "controls"]);
});

test("a hand that appears elsewhere is another one", () => {
  const look = controlling();
  assert.equal(show(look, 550, [hand(OPEN, { at: [0.05, 0.7] })])[0].state, "opening");
});

test("a flat hand pushed forward stops, before and after it took control", () => {
  for (const look of [createHand(), controlling()]) {
    const growing = Array.from({ length: 8 }, (_, n) => hand(OPEN, { size: 0.2 + 0.015 * n }));
    const states = show(look, 550, growing).map(({ state }) => state);
    assert.equal(states.filter((state) => state === "stop").length, 1);
  }
});

test("a hand that comes slowly nearer does not stop", () => {
  const look = controlling();
  const growing = Array.from({ length: 60 }, (_, n) => hand(OPEN, { size: 0.2 + 0.002 * n }));
  assert.ok(show(look, 550, growing).every(({ state }) => state === "controls"));
});

test("measures do not depend on the shape of the picture", () => {
  const wide = { ...hand(), points: hand().points.map(([x, y]) => [x * 0.75, y]) };
  assert.ok(Math.abs(measure(wide, 16 / 9).palm / measure(hand(), ASPECT).palm - 0.75) < 0.001);
});
