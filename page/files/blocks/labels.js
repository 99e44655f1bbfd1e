// The words on the blocks. What has no word here is shown as its key, with the description of the schema: a new key needs none.

import { BLOCK_WORDS } from "../i18n/i18n.js";

/** @typedef {import("../i18n/i18n.js").Language} Language */
/** @typedef {keyof typeof GROUPS} Group */

/** The groups of the toolbox, with the verbs and entries in each; the rest is in the last one. */
export const GROUPS = {
  moves: ["step go", "step arc", "step circle", "step drawing"],
  grips: ["step pick", "step place", "step here"],
  repeats: ["step repeat", "step each", "step while", "step call"],
  asks: ["step choose", "item When", "step wait", "step barrier"],
  sets: ["step speed", "step tool", "step laser", "step set", "step add"],
  names: ["entry Point", "entry Grid", "entry Frame", "entry MountedTool", "entry integer"],
  more: /** @type {string[]} */ ([]),
};

/** The word for a type or a key. @param {Language} language @param {string} key */
export const wordOf = (language, key) => BLOCK_WORDS[language]?.[key] ?? key.replace(/^\w+ /, "").replaceAll("_", " ");

/** The group of a type of blocks. @param {string} type @returns {Group} */
export const groupOf = (type) => /** @type {Group} */ (Object.keys(GROUPS).find((group) => GROUPS[/** @type {Group} */ (group)].includes(type)) ?? "more");
