// The user's preferences for all pages of this station, kept in this browser.

import { LANGUAGES } from "../i18n/i18n.js";

/** @typedef {import("../i18n/i18n.js").Language} Language */
/** @typedef {import("../state/state.js").Theme} Theme */
/** @typedef {{ language: Language, theme: Theme, greeted: boolean }} Preferences */

const KEY = "dobot";

/** Returns the stored preferences that are still valid. @returns {Partial<Preferences>} */
export function readPreferences() {
  try {
    const { language, theme, greeted } = JSON.parse(localStorage.getItem(KEY) ?? "{}");
    return { ...(language in LANGUAGES && { language }), ...(["auto", "light", "dark"].includes(theme) && { theme }), greeted: greeted === true };
  } catch {
    return {};
  }
}

/** @param {Preferences} preferences */
export const savePreferences = (preferences) => localStorage.setItem(KEY, JSON.stringify(preferences));

/** @param {Theme} theme @param {boolean} isSystemDark */
export const isDarkTheme = (theme, isSystemDark) => theme === "dark" || (theme === "auto" && isSystemDark);
