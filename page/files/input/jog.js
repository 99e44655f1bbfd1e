// Jogging: the arm moves only while a button, a key or a stick is held. One input holds at a time; a new one releases the
// previous one.

/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {import("../state/jog.js").Axis} Axis */
/** @typedef {import("../state/jog.js").Frame} Frame */
/** @typedef {import("../state/types.js").Schemas} Schemas */
/** @typedef {ReturnType<typeof createJog>} JogInput */

import { blockedReason } from "../state/selectors.js";

const JOG_MS = 50;

/**
 * @param {Store} store
 * @param {import("../station/socket.js").Socket} socket
 */
export function createJog(store, socket) {
  /** @type {{ by: unknown, axis: Axis, timer: number, speed_percent: () => number } | undefined} */ let held;

  /** @param {unknown} by the input that holds @param {Axis} axis @param {() => number} speed_percent of each press */
  function hold(by, axis, speed_percent = () => store.page.jog.speed_percent) {
    if (held && held.by === by && held.axis === axis) return;
    release();
    if (blockedReason(store.page)) return;
    socket.takeControlIfFree();
    const { frame } = store.page.jog;
    const mine = { by, axis, speed_percent, timer: setInterval(press, JOG_MS) };
    held = mine;
    store.send({ type: "jog_held", axis });
    void press();

    async function press() {
      const jog = /** @type {Schemas["Jog"]} */ ({ frame, axis, speed_percent: mine.speed_percent() });
      const { problem } = await socket.ask({ type: "jog", jog });
      // A refusal ends the press: it is shown next to the button, and a new press is needed.
      if (!problem || held !== mine) return;
      release();
      store.send({ type: "jog_refused", axis, detail: problem.detail });
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
    if (problem) store.send({ type: "jog_refused", axis, detail: problem.detail });
  }

  store.subscribe((page, message) => {
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
