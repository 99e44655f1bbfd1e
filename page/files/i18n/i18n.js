// The texts of the page in each language. Texts from the station (refusals, notices) are in English.

import { en } from "./en.js";
import { zh } from "./zh.js";

/** @typedef {keyof typeof en} TextKey */
/** @typedef {keyof typeof LANGUAGES} Language */
/** Returns the text of a key, with each `{name}` replaced by its value. @typedef {(key: TextKey, values?: Record<string, string | number>) => string} Translate */

/** The languages, each by its own name. */
export const LANGUAGES = { en: "English", zh: "中文" };

/** @type {Record<Language, Record<TextKey, string>>} */
export const TEXTS = { en, zh };

/** @param {Language} language @returns {Translate} */
export const translator = (language) => (key, values = {}) => TEXTS[language][key].replace(/\{(\w+)\}/g, (all, name) => String(values[name] ?? all));

/** Returns the first supported language of a browser's list. @param {readonly string[]} wanted @returns {Language} */
export function languageOf(wanted) {
  for (const tag of wanted) {
    const known = /** @type {Language} */ (tag.slice(0, 2).toLowerCase());
    if (known in LANGUAGES) return known;
  }
  return "en";
}

/** Formats a duration with units. @param {Translate} t @param {number} seconds */
export function formatDuration(t, seconds) {
  const whole = Math.max(0, Math.round(seconds));
  const [minutes, rest] = [Math.floor(whole / 60), whole % 60];
  if (whole < 60) return t("time.s", { s: whole });
  return minutes < 60 ? t("time.min", { min: minutes, s: String(rest).padStart(2, "0") }) : t("time.h", { h: Math.floor(minutes / 60), min: String(minutes % 60).padStart(2, "0") });
}

/** Formats a duration as minutes and seconds: 9:41. @param {number} seconds */
export const formatClock = (seconds) => `${Math.floor(Math.max(0, seconds) / 60)}:${String(Math.floor(Math.max(0, seconds) % 60)).padStart(2, "0")}`;

/** Formats the size of a file. @param {number} bytes */
export const formatSize = (bytes) => (bytes < 1e6 ? `${Math.ceil(bytes / 1e3)} kB` : `${(bytes / 1e6).toFixed(1)} MB`);
