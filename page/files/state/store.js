// Holds the state, and tells who listens that it is another one.

import { createStoreCore } from "./store_core.js";
import { reduce } from "./reduce.js";

/** @typedef {import("./state.js").Page} Page */
/** @typedef {ReturnType<typeof createStore>} Store */

/** @param {Page} page */
export const createStore = (page) => createStoreCore(reduce, page);
