// Whether this browser announces the end of a job.

import { html, nothing } from "../../vendor/lit-html/lit-html.js";
import { live } from "../../vendor/lit-html/directives/live.js";

const checked = (/** @type {Event} */ event) => /** @type {HTMLInputElement} */ (event.target).checked;

/** @param {import("../../views/context.js").Context} context */
export function alerts({ page, t, act }) {
  const { notify, sound, permission } = page.alerts;
  const refused = permission === "denied" || permission === "insecure";
  return html`
    <section class="card" aria-labelledby="alerts-title">
      <h2 id="alerts-title">${t("alerts")}</h2>
      <label class="check"><input id="alerts-notify" type="checkbox" ?disabled=${refused} .checked=${live(notify)} @change=${(/** @type {Event} */ event) => void act.alerts.notify(checked(event))}> ${t("alerts.notify")}</label>
      ${refused ? html`<p class="quiet">${t(permission === "denied" ? "alerts.denied" : "alerts.insecure")}</p>` : nothing}
      <label class="check"><input id="alerts-sound" type="checkbox" .checked=${live(sound)} @change=${(/** @type {Event} */ event) => act.alerts.sound(checked(event))}> ${t("alerts.sound")}</label>
    </section>`;
}
