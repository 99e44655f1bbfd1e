// Asks the station where the way to the target leads, a moment after it was changed.

/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {import("../state/types.js").Command} Command */
/** @typedef {import("../state/state.js").Page} Page */

import { placeOf } from "../state/target.js";

const CHECK_MS = 80;

/** The command that goes to the target: the tool stays as it is. @param {Page} page @returns {Command | null} */
export function commandOf({ target, station }) {
  const place = placeOf(target);
  if (!place || !station?.arm) return null;
  const { suction, gripper_deg } = station.arm;
  return { type: "move_to", ...place, mode: target.path, suction, gripper_deg, pause_s: 0 };
}

/** @param {Store} store @param {import("./socket.js").Socket} socket */
export function followTarget(store, socket) {
  /** @type {number | undefined} */ let timer;
  let seen = store.page.target.asked;

  async function check() {
    const { target } = store.page;
    const command = commandOf(store.page);
    if (!command) return;
    const { problem, reply } = await socket.ask({ type: "check_command", command });
    if (problem) store.send({ type: "target_checked", asked: target.asked, check: { type: "refused", problem } });
    else if (reply?.type === "way") store.send({ type: "target_checked", asked: target.asked, check: { type: "free", takes_s: reply.way.takes_s ?? null } });
  }

  store.listen(({ target }) => {
    if (target.asked === seen) return;
    seen = target.asked;
    clearTimeout(timer);
    timer = setTimeout(() => void check(), CHECK_MS);
  });
}
