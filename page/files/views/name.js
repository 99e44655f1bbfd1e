// Asks for the name of the person at this page, once.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { NAME_LENGTH, NAME_PATTERN } from "../parts/name.js";

/** @typedef {import("./context.js").Context} Context */

/** A form for the name. @param {Context} context @param {string} id */
export function nameForm({ page, t, act }, id) {
  const save = (/** @type {SubmitEvent} */ event) => {
    event.preventDefault();
    const field = /** @type {HTMLInputElement} */ (/** @type {HTMLFormElement} */ (event.currentTarget).elements.namedItem("name"));
    act.setName(field.value.trim());
  };
  return html`
    <form id=${id} class="row" @submit=${save}>
      <input name="name" type="text" maxlength=${NAME_LENGTH} pattern=${NAME_PATTERN} title=${t("name.allowed")} required autocomplete="off" .value=${page.name ?? ""} aria-label=${t("name")} placeholder=${t("name")}>
      <button type="submit" class="small">${t("name.save")}</button>
      ${page.name === "" ? nothing : html`<button type="button" class="small" data-act="no-name" @click=${() => act.setName("")}>${t(page.name ? "name.not_me" : "name.none")}</button>`}
    </form>`;
}

/** Whether the person has to be asked: a personal token says who it is. @param {Context["page"]} page */
export const asksName = ({ connection, name, says_name, role }) => connection === "open" && name === null && says_name && role !== "watch";

/** The question, as soon as somebody else is connected. @param {Context} context */
export function name(context) {
  const { page, t } = context;
  if (!asksName(page) || (page.station?.clients ?? 0) < 2) return nothing;
  return html`
    <section id="who" class="first" aria-labelledby="who-title">
      <p id="who-title">${t("name.why")}</p>
      ${nameForm(context, "who-form")}
    </section>`;
}
