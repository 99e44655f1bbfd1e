import assert from "node:assert/strict";
import { test } from "node:test";

import { watchSilence } from "./silence.js";

/** How often a station was found silent, and what makes that more. */
function watch(t) {
  t.mock.timers.enable({ apis: ["setInterval"] });
  const found = { silent: 0, isExpected: true };
  const heard = watchSilence({ isExpected: () => found.isExpected, silent: () => (found.silent += 1) });
  return { found, heard, pass: (ms) => t.mock.timers.tick(ms) };
}

test("a station is silent 2 s after its last message, and again as long after that", (t) => {
  const { found, heard, pass } = watch(t);
  pass(1900);
  heard();
  pass(2000);
  assert.equal(found.silent, 0);
  pass(600);
  assert.equal(found.silent, 1);
  pass(2600);
  assert.equal(found.silent, 2);
});

test("a station without news is not silent", (t) => {
  const { found, pass } = watch(t);
  found.isExpected = false;
  pass(10_000);
  found.isExpected = true;
  pass(2000);
  assert.equal(found.silent, 0);
});
