// Jogging: the arm moves only while a button, a key or a stick is held. One input holds at a time; a new one releases the
// previous one.

/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {import("../state/jog.js").Axis} Axis */
/** @typedef {import("../state/jog.js").Frame} Frame */
/** @typedef {import("../state/types.js").Schemas} Schemas */
/** @typedef {ReturnType<typeof createJog>} JogInput */

import { blockedReason } from "../state/selectors.js";
import { BUSY_MS, REPEAT_MS } from "../station/keep_alive.js";

/** The longest time in which the arm comes to rest, by the station's clock. */
const RUN_DOWN_S = 0.5;

/** @type {import("../state/types.js").Problem} */
const LOST_PRESS = { type: "lost-press", title: "nothing moved", detail: "the button was released before the arm was at rest" };

/**
 * @param {Store} store
 * @param {import("../station/socket.js").Socket} socket
 */
export function createJog(store, socket) {
  /** The axis of the last press. */
  let pressed = "", holds = 0;
  /** @type {{ by: unknown, axis: Axis, timer: number, speed_percent: () => number } | undefined} */ let held;

  /** @param {unknown} by the input that holds @param {Axis} axis @param {() => number} speed_percent of each press */
  function hold(by, axis, speed_percent = () => store.page.jog.speed_percent) {
    if (held && held.by === by && held.axis === axis) return;
    release();
    if (blockedReason(store.page)) return;
    socket.takeControlIfFree();
    const { frame } = store.page.jog;
    const number = holds += 1;
    const mine = { by, axis, speed_percent, timer: setInterval(press, REPEAT_MS) };
    held = mine;
    pressed = axis;
    const { arm, at_s } = /** @type {import("../state/types.js").Station} */ (store.page.station);
    store.send({ type: "jog_held", axis, waits_until_s: arm?.moving ? at_s + RUN_DOWN_S : null });
    void press();

    async function press() {
      const jog = /** @type {Schemas["Jog"]} */ ({ frame, axis, speed_percent: mine.speed_percent() });
      const { problem } = await socket.ask({ type: "jog", jog }, { number, busy_ms: Math.max(BUSY_MS, 1000 * (store.page.policy?.jog.dead_man_s ?? 0)) });
      // A refusal ends the press: it is shown next to the button, and a new press is needed.
      if (!problem || held !== mine) return;
      release();
      store.send({ type: "jog_refused", axis, problem });
    }
  }

  /** Releases the jog only if this input still holds it. @param {unknown} by */
  function releaseBy(by) {
    if (held?.by === by) release();
  }

  function release() {
    if (!held) return;
    clearInterval(held.timer);
    held = undefined;
    store.send({ type: "jog_held", axis: null });
    if (socket.isOpen()) void socket.ask({ type: "release" });
  }

  /** Moves by one step, starting where the previous step ends. @param {Axis} axis @param {number} by millimetres or degrees */
  async function stepBy(axis, by) {
    const { page } = store;
    if (!page.station?.arm || blockedReason(page)) return;
    const button = /** @type {Schemas["Button"]} */ ({ frame: page.jog.frame, axis });
    store.send({ type: "jog_held", axis });
    store.send({ type: "jog_held", axis: null });
    const { problem } = await socket.ask({ type: "step", button, by });
    if (problem) store.send({ type: "jog_refused", axis, problem });
  }

  /** A press that ended before the arm had come to rest: nothing has moved. @param {import("../state/types.js").Notice} notice */
  const isLostPress = (notice) => notice.type === "refused" && notice.client === store.page.me && notice.kind === "let-go";

  store.subscribe((page, message) => {
    if (message.type === "notice" && isLostPress(message.notice) && !page.jog.refused) store.send({ type: "jog_refused", axis: pressed, problem: LOST_PRESS });
    if (message.type === "closed" || message.type === "stop_pressed" || (held && blockedReason(page) !== null)) release();
    if (message.type === "jog_set" && message.set.frame) release();
  });

  return {
    hold,
    releaseBy,
    release,
    /** Handles a press of a button: holds it, or moves by a step. @param {unknown} by @param {Axis} axis */
    press(by, axis) {
      const { step: distance } = store.page.jog;
      if (distance === null) hold(by, axis);
      else void stepBy(axis, distance);
    },
  };
}
