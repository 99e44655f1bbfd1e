import assert from "node:assert/strict";
import { test } from "node:test";

import { NO_TALK, reduceTalk } from "./talk.js";

const ME = 4;
const page = (station = {}) => ({ me: ME, station: { at_s: 100, stop: null, ...station } });
const notice = (heard, client = ME) => ({ type: "notice", notice: { type: "heard", number: 1, at_s: 100, text: "", client, heard } });
const left = notice({ what: "order", words: "left ten" });

test("an order waits until it is confirmed, forgotten, replaced, or too old", () => {
  const waits = reduceTalk(NO_TALK, left, page());
  assert.equal(waits.order.words, "left ten");
  assert.equal(reduceTalk(waits, notice({ what: "order", words: "up five" }), page()).order.words, "up five");
  assert.equal(reduceTalk(waits, notice({ what: "no" }), page()).order, null);
  assert.equal(reduceTalk(waits, notice({ what: "nothing" }), page()).order.words, "left ten");
  assert.equal(reduceTalk(waits, { type: "state" }, page({ at_s: 114 })).order.words, "left ten");
  assert.equal(reduceTalk(waits, { type: "state" }, page({ at_s: 116 })).order, null);
});

test("a stop, by whomever, forgets the order", () => {
  const waits = reduceTalk({ ...NO_TALK, holds: true }, left, page());
  assert.equal(reduceTalk(waits, { type: "state" }, page({ stop: { by: "Ben" } })).order, null);
  assert.equal(reduceTalk(waits, notice({ what: "stop" }), page()).order, null);
  const { order, holds } = reduceTalk(waits, { type: "stop_pressed" }, page());
  assert.deepEqual([order, holds], [null, false]);
});

test("what others say is not this page's order", () => {
  for (const client of [5, null]) assert.equal(reduceTalk(NO_TALK, notice({ what: "order", words: "left ten" }, client), page()), NO_TALK);
});
