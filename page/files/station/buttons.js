// Reads the buttons of the station, changes them, and does what a press of one means.

import { titled } from "../state/teach.js";

/** @typedef {import("../state/types.js").Command} Command */
/** @typedef {import("../state/buttons.js").CustomButton} CustomButton */
/** @typedef {ReturnType<typeof createButtons>} ButtonRequests */

const PATH = "api/v1/buttons";

/**
 * @param {import("../state/store.js").Store} store @param {import("./http.js").Http} http @param {import("./jobs.js").JobRequests} jobs
 */
export function createButtons(store, http, jobs) {
  const { send } = store;

  async function read() {
    const all = await http.json(PATH);
    if (all) send({ type: "buttons", all });
  }

  /** @param {"POST" | "DELETE"} method @param {string} path @param {CustomButton} [button] @returns {Promise<boolean>} whether it is done */
  async function change(method, path, button) {
    const { value, problem } = await http.ask(method, path, button);
    if (problem) send({ type: "button_refused", problem });
    else send({ type: "buttons", all: /** @type {CustomButton[]} */ (value) });
    return !problem;
  }

  store.subscribe((_, message) => {
    if (message.type === "hello" || (message.type === "notice" && message.notice.type === "buttons_changed")) void read();
  });

  return {
    /** @param {CustomButton} button */
    add: (button) => change("POST", PATH, button),
    /** @param {string} name */
    remove: (name) => void change("DELETE", `${PATH}/${encodeURIComponent(name)}`),
    /** Does what a press means, by the same requests as every other button. @param {CustomButton} button @param {(command: Command) => Promise<boolean>} command */
    async press({ name, action }, command) {
      if (action.type === "command") return void command(action.command);
      if (action.type === "position") {
        const { suction = false, gripper_deg = 0 } = store.page.station?.arm ?? {};
        const { type: _, ...place } = action;
        return void command({ type: "move_to", ...place, suction, gripper_deg, pause_s: 0 });
      }
      const { problem } = await jobs.run("api/v1/programs/jobs", { program: { text: titled(action.text, name), files: {} }, from_step: 1, times: null });
      if (problem) send({ type: "problem", problem });
    },
  };
}
