// The form for an access token.

import { html } from "../vendor/lit-html/lit-html.js";

/** @param {import("../i18n/i18n.js").Translate} t @param {unknown} why @param {(secret: string) => void} use */
export function tokenForm(t, why, use) {
  const submit = (/** @type {SubmitEvent} */ event) => {
    event.preventDefault();
    const field = /** @type {HTMLInputElement} */ (/** @type {HTMLFormElement} */ (event.target).elements.namedItem("token"));
    use(field.value.trim());
  };
  return html`
    <form id="token" class="banner" data-tone="warn" @submit=${submit}>
      <label for="token-field">${why}</label>
      <input id="token-field" name="token" type="password" autocomplete="current-password" required>
      <button type="submit">${t("token.use")}</button>
    </form>`;
}
