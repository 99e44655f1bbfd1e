// The text of a problem in the language of the page.

import { TEXTS } from "./i18n.js";

/** @typedef {import("../state/types.js").Problem} Problem */

/** @param {string} text */
export const sentence = (text) => text.charAt(0).toUpperCase() + text.slice(1);

/** The problem type, such as `still-moving`. @param {Pick<Problem, "type">} problem */
export const kindOf = ({ type = "" }) => type.slice(type.lastIndexOf("/") + 1);

/** Two decimals at most, as a person reads a length; smaller amounts stay. @param {string} text */
const rounded = (text) => text.replace(/(?<![\d.])\d+\.\d{3,}(?![\d.])/g, (number) => (Number(number) < 0.01 ? number : String(Math.round(100 * Number(number)) / 100)));

/** The text of a problem. Hints with commands for a terminal are left out. @param {import("./i18n.js").Translate} t @param {Problem} problem */
export function problemText(t, problem) {
  const { title, hint } = problem, detail = rounded(problem.detail);
  const key = `problem.${kindOf(problem)}`;
  const isKnown = key in TEXTS.en;
  const text = isKnown ? t(/** @type {import("./i18n.js").TextKey} */ (key), { detail }) : `${sentence(title ? `${title}: ${detail}` : detail)}.`;
  return hint && text.includes(detail) && !hint.includes("`") ? `${text} ${sentence(hint)}.` : text;
}
