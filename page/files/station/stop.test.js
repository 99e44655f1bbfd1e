import assert from "node:assert/strict";
import { test } from "node:test";

import { createStop } from "./stop.js";

/** A STOP button, with what was asked and log since its press; the ways answer as a test wants. */
function button(t, { first = () => false, again = () => false } = {}) {
  t.mock.timers.enable({ apis: ["setTimeout", "Date"] });
  const log = [];
  const way = (name, answers) => async () => {
    log.push(`${name} ${Date.now()}`);
    return answers();
  };
  const press = createStop({ first: way("first", first), again: way("again", again), late: () => log.push(`late ${Date.now()}`), answered: (after_ms) => log.push(`answered ${after_ms}`) });
  const pass = async (ms) => {
    await new Promise(setImmediate);
    for (let passed = 0; passed < ms; passed += 100) {
      t.mock.timers.tick(100);
      await new Promise(setImmediate);
    }
  };
  return { log, press, pass };
}

test("a stop is sent at the moment of the press", (t) => {
  const { log, press } = button(t);
  press();
  assert.deepEqual(log, ["first 0"]);
});

test("an answered stop is not sent again", async (t) => {
  const { log, press, pass } = button(t, { first: () => true });
  press();
  await pass(5000);
  assert.deepEqual(log, ["first 0", "answered 0"]);
});

test("an unanswered stop is sent again after 0.3 s and each second, and is shown to the person after 1 s", async (t) => {
  const { log, press, pass } = button(t);
  press();
  await pass(3500);
  assert.deepEqual(log, ["first 0", "again 300", "late 1000", "again 1300", "again 2300", "again 3300"]);
});

test("an answer over any connection ends it, however late, and its delay is shown", async (t) => {
  let isThere = false;
  const { log, press, pass } = button(t, { first: () => new Promise(() => {}), again: () => isThere });
  press();
  await pass(1500);
  isThere = true;
  await pass(5000);
  assert.deepEqual(log, ["first 0", "again 300", "late 1000", "again 1300", "again 2300", "answered 2300"]);
});

test("each press is sent at once, and repeated presses delay neither the next attempt nor the warning", async (t) => {
  const { log, press, pass } = button(t);
  for (let times = 0; times < 6; times += 1) {
    press();
    await pass(200);
  }
  assert.deepEqual(log, ["first 0", "first 200", "again 300", "first 400", "first 600", "first 800", "late 1000", "first 1000"]);
});

test("the late answer to an earlier stop does not answer this one", async (t) => {
  const answers = [];
  const { log, press, pass } = button(t, { first: () => new Promise((answer) => answers.push(answer)), again: () => answers.length === 1 });
  press();
  await pass(300);
  press();
  answers[0](true);
  await pass(100);
  assert.deepEqual(log, ["first 0", "again 300", "answered 300", "first 300"]);
});
