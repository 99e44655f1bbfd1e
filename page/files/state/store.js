// Holds the state, and tells who listens that it is another one.

import { reduce } from "./reduce.js";

/** @typedef {import("./state.js").Page} Page */
/** @typedef {import("./message.js").Message} Message */
/** @typedef {ReturnType<typeof createStore>} Store */

/** @param {Page} page */
export function createStore(page) {
  /** @type {((page: Page, message: Message) => void)[]} */
  const listeners = [];
  return {
    get page() {
      return page;
    },
    /** @param {Message} message */
    send(message) {
      const next = reduce(page, message);
      page = next;
      for (const listener of listeners) listener(page, message);
    },
    /** @param {(page: Page, message: Message) => void} listener */
    listen(listener) {
      listeners.push(listener);
    },
  };
}
