// Language and theme of the page.

import { html, nothing } from "../../vendor/lit-html/lit-html.js";
import { live } from "../../vendor/lit-html/directives/live.js";
import { nameForm } from "../../views/name.js";
import { LANGUAGES, loadLanguage } from "../../i18n/i18n.js";

/** @typedef {import("../../i18n/i18n.js").Language} Language */

/** @type {readonly import("../../state/state.js").Theme[]} */
const THEMES = ["auto", "light", "dark"];

/** Shows the page in a language, in English until its texts are loaded. @param {Language} language @param {import("../../views/context.js").Context["act"]} act */
function speak(language, act) {
  const choose = () => act.send({ type: "language", language });
  choose();
  loadLanguage(language).then(choose, () => {});
}

/** @param {import("../../views/context.js").Context} context */
export function looks(context) {
  const { page, t, act } = context;
  return html`
    <section class="card" aria-labelledby="looks-title">
      <h2 id="looks-title">${t("set.looks")}</h2>
      <fieldset class="segments">
        <legend>${t("set.language")}</legend>
        ${Object.entries(LANGUAGES).map(([tag, name]) => html`<label lang=${tag}><input type="radio" name="language" value=${tag} .checked=${live(tag === page.language)} @change=${() => speak(/** @type {Language} */ (tag), act)}><span>${name}</span></label>`)}
      </fieldset>
      <fieldset class="segments">
        <legend>${t("set.theme")}</legend>
        ${THEMES.map((choice) => html`<label><input type="radio" name="theme" value=${choice} .checked=${live(choice === page.theme)} @change=${() => act.send({ type: "theme", theme: choice })}><span>${t(`set.${choice}`)}</span></label>`)}
      </fieldset>
      ${page.says_name ? html`<p class="quiet">${t("name.why")}</p>${nameForm(context, "looks-name")}` : nothing}
      <p class="row"><button id="lessons-open" type="button" class="small" @click=${() => act.send({ type: "lesson_choose", open: true })}>${t("learn.open")}</button></p>
      <p class="quiet">${t("set.version", { version: page.version })}</p>
    </section>`;
}
