// Buttons that people have added: positions, programs and commands, reached with one click.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { COLORS, EFFECTS, actionOf, lacks } from "../state/buttons.js";
import { blockedReason } from "../state/selectors.js";
import { blockedLine, problemLine } from "../views/problem.js";

/** @typedef {import("../views/context.js").Context} Context */
/** @typedef {import("../state/buttons.js").CustomButton} CustomButton */
/** @typedef {import("../state/buttons.js").Effect} Effect */

/** The most characters of a name. */
const NAME_LENGTH = 30;

/** Whether this page may change the buttons. @param {Context["page"]} page */
const mayEdit = ({ role }) => role === "control" || role === "admin";

/** @param {Context} context */
export function buttons(context) {
  const { page, t, act } = context;
  const { all, edits } = page.buttons;
  const why = blockedReason(page);
  if (!all.length && !mayEdit(page)) return nothing;
  return html`
    <section class="card" aria-labelledby="buttons-title">
      <h2 id="buttons-title">${t("buttons")}</h2>
      <div id="buttons" class="buttons">
        ${all.map((button) => html`<span class="custom">
          <button type="button" data-button=${button.name} data-color=${button.color} ?disabled=${why !== null} @click=${() => void act.buttons.press(button, act.command)}>${button.name}</button>
          ${edits ? html`<button type="button" class="small" data-remove=${button.name} aria-label=${t("buttons.remove", { name: button.name })} @click=${() => act.buttons.remove(button.name)}>×</button>` : nothing}
        </span>`)}
      </div>
      ${!all.length && !edits ? html`<p class="quiet">${t("buttons.none")}</p>` : nothing}
      ${why && all.length ? html`<p class="quiet">${blockedLine(context)}</p>` : nothing}
      ${mayEdit(page) ? html`<div class="row"><button id="buttons-edit" type="button" class="small" aria-expanded=${edits ? "true" : "false"} @click=${() => act.send({ type: "buttons_edited", edits: !edits })}>${t(edits ? "buttons.done" : "buttons.edit")}</button></div>` : nothing}
      ${edits && mayEdit(page) ? form(context) : nothing}
    </section>`;
}

/** @param {Context} context */
function form(context) {
  const { page, t, act } = context;
  const { refused } = page.buttons;
  const add = async (/** @type {SubmitEvent} */ event) => {
    event.preventDefault();
    const form = /** @type {HTMLFormElement} */ (event.currentTarget);
    const value = (/** @type {string} */ name) => /** @type {HTMLInputElement} */ (form.elements.namedItem(name)).value;
    const effect = /** @type {Effect} */ (value("effect"));
    if (lacks(effect, page)) return;
    const button = { name: value("name").trim(), color: /** @type {CustomButton["color"]} */ (value("color")), action: actionOf(effect, page) };
    if (await act.buttons.add(button)) form.reset();
  };
  return html`
    <form id="button-new" class="button-new" @submit=${add}>
      <input name="name" type="text" maxlength=${NAME_LENGTH} required pattern=".*\\S.*" autocomplete="off" placeholder=${t("buttons.name")} aria-label=${t("buttons.name")}>
      <select name="effect" aria-label=${t("buttons.effect")}>${EFFECTS.map((effect) => html`<option value=${effect} ?disabled=${lacks(effect, page) !== null}>${t(`buttons.effect.${effect}`)}</option>`)}</select>
      <select name="color" aria-label=${t("buttons.color")}>${COLORS.map((color) => html`<option value=${color} ?selected=${color === "blue"}>${t(`buttons.color.${color}`)}</option>`)}</select>
      <button type="submit" class="small">${t("buttons.add")}</button>
    </form>
    <p class="quiet">${t("buttons.hint")}</p>
    ${refused ? html`<p id="button-refused" class="status" data-tone="bad" role="alert">${problemLine(context, refused)}</p>` : nothing}`;
}
