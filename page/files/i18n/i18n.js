// Every text of the page, in each language. What the station says (why something is refused, what happened) comes from it,
// in English.

import { en } from "./en.js";
import { zh } from "./zh.js";

/** @typedef {keyof typeof en} TextKey */
/** @typedef {keyof typeof LANGUAGES} Language */
/** Says a text; `{name}` in it is replaced by the value of that name. @typedef {(word: TextKey, values?: Record<string, string | number>) => string} Translate */

/** The languages, as they call themselves. */
export const LANGUAGES = { en: "English", zh: "中文" };

/** @type {Record<Language, Record<TextKey, string>>} */
export const TEXTS = { en, zh };

/** @param {Language} language @returns {Translate} */
export const translator = (language) => (word, values = {}) => TEXTS[language][word].replace(/\{(\w+)\}/g, (all, name) => String(values[name] ?? all));

/** Returns the first supported language of a browser's list. @param {readonly string[]} wanted @returns {Language} */
export function languageOf(wanted) {
  for (const tag of wanted) {
    const known = /** @type {Language} */ (tag.slice(0, 2).toLowerCase());
    if (known in LANGUAGES) return known;
  }
  return "en";
}

/** A time in words. @param {Translate} t @param {number} seconds */
export function formatDuration(t, seconds) {
  const whole = Math.max(0, Math.round(seconds));
  const [minutes, rest] = [Math.floor(whole / 60), whole % 60];
  if (whole < 60) return t("time.s", { s: whole });
  return minutes < 60 ? t("time.min", { min: minutes, s: String(rest).padStart(2, "0") }) : t("time.h", { h: Math.floor(minutes / 60), min: String(minutes % 60).padStart(2, "0") });
}

/** A time as on a clock: 9:41. @param {number} seconds */
export const formatClock = (seconds) => `${Math.floor(Math.max(0, seconds) / 60)}:${String(Math.floor(Math.max(0, seconds) % 60)).padStart(2, "0")}`;
