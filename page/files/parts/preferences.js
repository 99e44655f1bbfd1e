// What a person wishes of every page of this station, kept in this browser.

import { LANGUAGES } from "../i18n/i18n.js";

/** @typedef {import("../i18n/i18n.js").Language} Language */
/** @typedef {import("../state/state.js").Theme} Theme */
/** @typedef {{ language: Language, theme: Theme, greeted: boolean }} Wishes */

const KEY = "dobot";

/** What was kept, where it can be read and still means something. @returns {Partial<Wishes>} */
export function readWishes() {
  try {
    const { language, theme, greeted } = JSON.parse(localStorage.getItem(KEY) ?? "{}");
    return { ...(language in LANGUAGES && { language }), ...(["auto", "light", "dark"].includes(theme) && { theme }), greeted: greeted === true };
  } catch {
    return {};
  }
}

/** @param {Wishes} wishes */
export const keepWishes = (wishes) => localStorage.setItem(KEY, JSON.stringify(wishes));

/** @param {Theme} theme @param {boolean} isSystemDark */
export const isDarkTheme = (theme, isSystemDark) => theme === "dark" || (theme === "auto" && isSystemDark);
