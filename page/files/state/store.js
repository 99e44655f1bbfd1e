// The store: holds the state and notifies its subscribers.

import { createStoreCore } from "./store_core.js";
import { reduce } from "./reduce.js";

/** @typedef {import("./state.js").Page} Page */
/** @typedef {ReturnType<typeof createStore>} Store */

/** @param {Page} page */
export const createStore = (page) => createStoreCore(reduce, page);
