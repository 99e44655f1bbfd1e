// The welcome card for the virtual arm.

import { html } from "../vendor/lit-html/lit-html.js";
import { isVirtual } from "../state/selectors.js";

/** Whether the card is shown. @param {import("../state/state.js").Page} page */
export const welcomes = (page) => !page.greeted && isVirtual(page);

/** @param {import("./context.js").Context} context */
export function welcome({ t, act }) {
  const choose = (/** @type {import("../state/state.js").Tab} */ tab) => {
    act.send({ type: "greeted" });
    act.send({ type: "tab", tab });
  };
  return html`
    <section class="first" aria-labelledby="first-title">
      <p><strong id="first-title">${t("first.title")}</strong> ${t("first.text")}</p>
      <div class="row">
        <button id="first-jog" type="button" class="small strong" @click=${() => choose("move")}>${t("first.jog")}</button>
        <button id="first-draw" type="button" class="small" @click=${() => { choose("draw"); act.send({ type: "draw_text", text: "Dobot" }); }}>${t("first.draw")}</button>
        <button id="first-tour" type="button" class="small" @click=${() => { act.send({ type: "greeted" }); void act.lessons.open("tour"); }}>${t("learn.tour")}</button>
        <button id="first-real" type="button" class="small" @click=${() => choose("set_up")}>${t("first.real")}</button>
        <button id="first-close" type="button" class="small" @click=${() => act.send({ type: "greeted" })}>${t("close")}</button>
      </div>
    </section>`;
}
