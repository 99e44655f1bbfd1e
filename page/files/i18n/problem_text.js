// The text of a problem in the language of the page.

import { TEXTS } from "./i18n.js";

/** @typedef {import("../state/types.js").Problem} Problem */

/** @param {string} text */
export const sentence = (text) => text.charAt(0).toUpperCase() + text.slice(1);

/** The problem type, such as `still-moving`. @param {Pick<Problem, "type">} problem */
export const kindOf = ({ type = "" }) => type.slice(type.lastIndexOf("/") + 1);

/** The text of a problem. Hints with commands for a terminal are left out. @param {import("./i18n.js").Translate} t @param {Problem} problem */
export function problemText(t, problem) {
  const { title, detail, hint } = problem;
  const key = `problem.${kindOf(problem)}`;
  const isKnown = key in TEXTS.en;
  const text = isKnown ? t(/** @type {import("./i18n.js").TextKey} */ (key), { detail }) : `${sentence(title ? `${title}: ${detail}` : detail)}.`;
  return hint && text.includes(detail) && !hint.includes("`") ? `${text} ${sentence(hint)}.` : text;
}
