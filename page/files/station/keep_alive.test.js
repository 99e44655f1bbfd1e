import assert from "node:assert/strict";
import { test } from "node:test";
import { BUSY_MS, REPEATED, REPEAT_MS, createKeepAlive } from "./keep_alive.js";

const press = (id) => JSON.stringify({ id, request: { type: "jog", jog: { axis: "y_plus" } } });

const hold = (number) => ({ number, busy_ms: BUSY_MS });

/** A keep-alive and what it has sent, as ids and types. */
function kept() {
  const sent = [];
  const keepAlive = createKeepAlive((text) => {
    const { id, request } = JSON.parse(text);
    sent.push(`${id} ${request.type}`);
  });
  return { keepAlive, sent };
}

test("the press of a page that is busy for a moment is repeated, and no press of a page that is not", () => {
  const { keepAlive, sent } = kept();
  keepAlive.press(hold(1), press(7), 0);
  keepAlive.tick(REPEAT_MS - 1);
  assert.deepEqual(sent, ["7 jog"]);
  keepAlive.tick(REPEAT_MS);
  keepAlive.tick(REPEAT_MS + 1);
  keepAlive.tick(2 * REPEAT_MS);
  assert.deepEqual(sent, ["7 jog", `${REPEATED} jog`, `${REPEATED} jog`]);
});

test("the button of a page that is busy for too long is released once, and its later presses of the same hold press nothing", () => {
  const { keepAlive, sent } = kept();
  keepAlive.press(hold(1), press(7), 0);
  keepAlive.tick(BUSY_MS + 1);
  keepAlive.tick(BUSY_MS + REPEAT_MS + 1);
  assert.deepEqual(sent, ["7 jog", `${REPEATED} release`]);
  assert.equal(keepAlive.press(hold(1), press(8), BUSY_MS + 60), false);
  assert.equal(sent.length, 2);
  assert.equal(keepAlive.press(hold(2), press(9), BUSY_MS + 70), true);
  assert.equal(sent.at(-1), "9 jog");
});

test("a page that responds keeps its button pressed before its next press, but no button of an earlier hold", () => {
  const { keepAlive, sent } = kept();
  const lastsAfter = (beaten) => {
    keepAlive.press(hold(beaten + 1), press(7), 0);
    keepAlive.beat(2, BUSY_MS - 10);
    sent.length = 0;
    keepAlive.tick(BUSY_MS + 1);
    return sent.at(-1) !== `${REPEATED} release`;
  };
  assert.ok(lastsAfter(1));
  assert.ok(!lastsAfter(2));
});

test("nothing is repeated after the end of a hold, even if a late press of it arrives", () => {
  const { keepAlive, sent } = kept();
  keepAlive.press(hold(1), press(7), 0);
  keepAlive.end();
  assert.equal(keepAlive.press(hold(1), press(8), 10), false);
  keepAlive.tick(BUSY_MS + 1);
  assert.deepEqual(sent, ["7 jog"]);
});
