// The confirmation dialog. It is not modal, so STOP stays within reach.

import { html, render } from "../vendor/lit-html/lit-html.js";

/** @typedef {import("../i18n/i18n.js").TextKey} TextKey */
/** The questions with a title, a text and a yes button among the texts. @typedef {Extract<TextKey, `question.${string}.yes`> extends `question.${infer About}.yes` ? About : never} About */

/**
 * @param {import("../i18n/i18n.js").Translate} t
 * @param {{ about: About, values?: Record<string, string | number> }} question
 * @param {(yes: boolean) => void} answer
 */
export const confirmation = (t, { about, values }, answer) => html`
  <h2 id="confirm-title">${t(`question.${about}`, values)}</h2>
  <p id="confirm-text">${t(`question.${about}.text`, values)}</p>
  <div class="row">
    <button id="confirm-no" type="button" @click=${() => answer(false)}>${t("no")}</button>
    <button id="confirm-yes" type="button" class="strong" @click=${() => answer(true)}>${t(`question.${about}.yes`)}</button>
  </div>`;

/** Opens or closes the dialog. @param {HTMLDialogElement} dialog @param {unknown} content @param {boolean} open */
export function showDialog(dialog, content, open) {
  render(content, dialog);
  if (open === dialog.open) return;
  if (!open) return dialog.close();
  // Not modal: STOP has to stay within reach.
  dialog.show();
  dialog.querySelector("button")?.focus();
}
