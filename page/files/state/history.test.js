import assert from "node:assert/strict";
import { test } from "node:test";

import { NO_HISTORY, reduceHistory } from "./history.js";

const state = (at_s) => ({ type: "state", now_ms: 0, station: { at_s, link: { statuses_per_s: 12.5, latency_ms: null }, queue: { waiting: 1, under_way: 2 }, arm: null } });

test("a sample is kept every half second, for three minutes", () => {
  let history = NO_HISTORY;
  for (let n = 0; n < 4000; n += 1) history = reduceHistory(history, state(n * 0.08));
  assert.equal(history.at_s.length, 360);
  assert.ok(history.at_s.at(-1) - history.at_s[0] >= 179);
  assert.deepEqual([history.rate.at(-1), history.latency_ms.at(-1), history.queue.at(-1), history.base_deg.at(-1)], [12.5, null, 3, null]);
});

test("another connection starts a new history", () => {
  const history = reduceHistory(NO_HISTORY, state(1));
  assert.equal(reduceHistory(history, { type: "hello" }), NO_HISTORY);
});
