// Speeds of moves and programs, in percent of the configured ones (state 10).

import { html } from "../vendor/lit-html/lit-html.js";
import { blockedReason } from "../state/selectors.js";

/** @param {import("../views/context.js").Context} context */
export function speeds({ page, t, act }) {
  const set = (/** @type {SubmitEvent} */ event) => {
    event.preventDefault();
    const form = /** @type {HTMLFormElement} */ (event.target);
    const number = (/** @type {string} */ name) => /** @type {HTMLInputElement} */ (form.elements.namedItem(name)).valueAsNumber;
    if (!form.reportValidity()) return;
    void act.command({ type: "playback_adjustment", speed_percent: number("speed"), acceleration_percent: number("acceleration"), teach_speed_percent: page.jog.speed_percent });
  };
  return html`
    <details class="card" id="speeds">
      <summary><h2>${t("speeds")}</h2></summary>
      <p class="quiet">${t("speeds.hint")}</p>
      <form class="row" @submit=${set}>
        <label>${t("speeds.percent")} <input id="speed-percent" name="speed" type="number" min="1" max="100" step="any" required value="100"> %</label>
        <label>${t("speeds.acceleration")} <input id="acceleration-percent" name="acceleration" type="number" min="1" max="100" step="any" required value="100"> %</label>
        <button id="speeds-set" type="submit" ?disabled=${blockedReason(page) !== null}>${t("speeds.set")}</button>
      </form>
    </details>`;
}
