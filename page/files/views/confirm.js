// What a person is asked before something is done. STOP stays within reach: the dialog is not modal.

import { html, render } from "../vendor/lit-html/lit-html.js";

/** @typedef {import("../i18n/i18n.js").Word} Word */
/** A question has a title, a text and a yes among the words. @typedef {Extract<Word, `question.${string}.yes`> extends `question.${infer About}.yes` ? About : never} About */

/**
 * @param {import("../i18n/i18n.js").Say} say
 * @param {{ about: About, values?: Record<string, string | number> }} question
 * @param {(yes: boolean) => void} answer
 */
export const sure = (say, { about, values }, answer) => html`
  <h2 id="sure-title">${say(`question.${about}`, values)}</h2>
  <p id="sure-text">${say(`question.${about}.text`, values)}</p>
  <div class="row">
    <button id="sure-no" type="button" @click=${() => answer(false)}>${say("no")}</button>
    <button id="sure-yes" type="button" class="strong" @click=${() => answer(true)}>${say(`question.${about}.yes`)}</button>
  </div>`;

/** Opens the dialog where there is a question, and closes it where there is none. @param {HTMLDialogElement} dialog @param {unknown} content @param {boolean} open */
export function showQuestion(dialog, content, open) {
  render(content, dialog);
  if (open === dialog.open) return;
  if (!open) return dialog.close();
  // Not a modal one: STOP has to stay within reach.
  dialog.show();
  dialog.querySelector("button")?.focus();
}
