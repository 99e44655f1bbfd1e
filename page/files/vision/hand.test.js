import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { createHand, measure } from "./hand.js";

const ASPECT = 4 / 3;
/** Hands in pictures and what they mean, shared with the Python package: landmarks that MediaPipe found, poses in palms from the
 * wrist with y up, and cases. */
const { recorded, poses, cases } = JSON.parse(readFileSync(new URL("../../../tests/hands/cases.json", import.meta.url), "utf8"));

/** A hand of a case in its nth picture. */
function hand({ pose, recorded: number, at = [0.5, 0.7], size = 0.2, grows = 0, score = 0.95 }, n = 0) {
  if (pose === undefined) return { score, points: recorded[number].points };
  const palm = size + grows * n;
  return { score, points: poses[pose].map(([x, y]) => [at[0] + x * palm, at[1] - y * palm * ASPECT, 0]) };
}

/** Shows the pictures of a step, 50 ms apart; returns what they mean. */
function show(look, from_ms, { times, hands }) {
  return Array.from({ length: times }, (_, n) => look({ at_ms: from_ms + 50 * n, hands: hands.map((it) => hand(it, n)), aspect: ASPECT }));
}

function checkStep(meanings, { state, movement, closed }) {
  for (const meaning of meanings) {
    assert.equal(meaning.state, state);
    assert.equal(meaning.movement !== null, state === "controls");
  }
  const last = meanings.at(-1).movement;
  if (closed !== undefined) assert.equal(last.closed, closed);
  for (const [name, value] of Object.entries(movement ?? {})) {
    if (typeof value === "number") assert.ok(Math.abs(last[name] - value) < 0.01, `${name}: ${last[name]} instead of ${value}`);
    else assert.equal(last[name], value);
  }
}

for (const { title, steps } of cases) {
  test(title, () => {
    const look = createHand();
    let at_ms = 0;
    for (const step of steps) {
      checkStep(show(look, at_ms, step), step);
      at_ms += 50 * step.times;
    }
  });
}

test("a hand with a point that is no number sends nothing, and an open hand has to be held again", () => {
  const look = createHand(), open = { pose: "open" };
  assert.equal(show(look, 0, { times: 11, hands: [open] }).at(-1).state, "controls");
  const broken = { ...hand(open), points: hand(open).points.map(() => [NaN, 0]) };
  for (let n = 0; n < 8; n++) assert.deepEqual(look({ at_ms: 550 + 50 * n, hands: [broken], aspect: ASPECT }), { state: "unsure", share: 0, movement: null });
  assert.deepEqual(show(look, 950, { times: 1, hands: [open] })[0], { state: "opening", share: 0, movement: null });
});

test("measures do not depend on the shape of the picture", () => {
  const open = hand({ pose: "open" }), wide = { ...open, points: open.points.map(([x, y]) => [x * 0.75, y]) };
  assert.ok(Math.abs(measure(wide, 16 / 9).palm / measure(open, ASPECT).palm - 0.75) < 0.001);
});
