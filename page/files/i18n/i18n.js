// The texts of the page in each language. Texts from the station (refusals, notices) are in English.

import { blocks, en } from "./en.js";

/** @typedef {keyof typeof en} TextKey */
/** @typedef {keyof typeof LANGUAGES} Language */
/** Returns the text of a key, with each `{name}` replaced by its value. @typedef {(key: TextKey, values?: Record<string, string | number>) => string} Translate */

/** The languages. Another one is a file like `en.js`, and its name and import here. */
export const LANGUAGES = { en: "English", de: "Deutsch", zh: "中文" };

/** @type {Record<Language, () => Promise<Record<string, any>>>} */
const FILES = { en: () => import("./en.js"), de: () => import("./de.js"), zh: () => import("./zh.js") };

/** The texts of the languages loaded so far. @type {{ en: typeof en } & Partial<Record<Language, Record<TextKey, string>>>} */
export const TEXTS = { en };

/** The words on blocks of the languages loaded so far. @type {Partial<Record<Language, Record<string, string>>>} */
export const BLOCK_WORDS = { en: blocks };

/** Loads the texts of a language, which are English until then. @param {Language} language */
export async function loadLanguage(language) {
  if (TEXTS[language]) return;
  const loaded = await FILES[language]();
  TEXTS[language] = loaded[language];
  BLOCK_WORDS[language] = loaded.blocks;
}

/** The key of a control's label in the text of a lesson: [tab.move]. */
export const LABEL = /\[([a-z_.]+)\]/;

/** @param {Language} language @returns {Translate} */
export const translator = (language) => (key, values = {}) => (TEXTS[language] ?? en)[key].replace(/\{(\w+)\}/g, (all, name) => String(values[name] ?? all));

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
