// Checks the path to the target shortly after it changed, and requests the limits near the ghost.

/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {import("../state/types.js").Command} Command */
/** @typedef {import("../state/state.js").Page} Page */

import { ghostPlace } from "../state/selectors.js";
import { lineOf, placeOf } from "../state/target.js";

/** Delay after the last input before the path is checked. */
const CHECK_MS = 80;

/** The command that goes to the target: the tool stays as it is. @param {Page} page @returns {Command | null} */
export function commandOf({ target, station }) {
  const place = placeOf(target);
  if (!place || !station?.arm) return null;
  const { suction, gripper_deg } = station.arm;
  if (target.path === "vector") {
    const line = lineOf(target, station.arm);
    return line && { type: "write_vector", mode: target.burns ? "laser" : "writing", laser: target.burns, start_speed_mm_s: 0, end_speed_mm_s: 0, stop: false, ...line };
  }
  return { type: "move_to", ...place, mode: target.path, suction, gripper_deg, pause_s: 0 };
}

/** @param {Store} store @param {import("./socket.js").Socket} socket */
export function followTarget(store, socket) {
  /** @type {number | undefined} */ let timer;
  let seen = store.page.target.revision;

  async function check() {
    const { target } = store.page;
    const command = commandOf(store.page);
    if (!command) return;
    const { problem, reply } = await socket.ask({ type: "check_command", command });
    if (problem) store.send({ type: "target_checked", revision: target.revision, check: { type: "refused", problem } });
    else if (reply?.type === "way") store.send({ type: "target_checked", revision: target.revision, check: { type: "free", takes_s: reply.way.takes_s ?? null } });
  }

  let asking = false;
  /** For which place, by which policy and over which connection it was asked last. @type {readonly unknown[]} */ let last = ["null"];

  /** Requests the limits near the ghost: one request at a time, then the next for its current position. */
  async function followGhost() {
    const { page } = store, place = ghostPlace(page), now = [JSON.stringify(place), page.policy, page.connection];
    if (asking || now.every((it, n) => it === last[n])) return;
    last = now;
    if (!place) return void (page.ghost_near && store.send({ type: "ghost_near", near: null }));
    asking = true;
    const { x_mm, y_mm, z_mm, rotation_deg } = place;
    const { reply } = await socket.ask({ type: "near", x_mm, y_mm, z_mm, rotation_deg });
    asking = false;
    store.send({ type: "ghost_near", near: reply?.type === "near" ? reply.near : null });
  }

  store.subscribe(({ target }) => {
    void followGhost();
    if (target.revision === seen) return;
    seen = target.revision;
    clearTimeout(timer);
    timer = setTimeout(() => void check(), CHECK_MS);
  });
}
