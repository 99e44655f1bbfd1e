// Go to: the target is typed, or dragged as a ghost on the stage. The station checks the path at each change, and reports why
// it is refused and the nearest allowed position. Nothing moves before Go.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { live } from "../vendor/lit-html/directives/live.js";
import { blockedReason } from "../state/selectors.js";
import { FIELDS, placeOf } from "../state/target.js";
import { problemText } from "../i18n/problem_text.js";

/** @typedef {import("../views/context.js").Context} Context */
/** @typedef {import("../state/target.js").TargetPath} TargetPath */

/** @type {Record<import("../state/target.js").Field, [string, string]>} */
const NAMES = { x_mm: ["X", "mm"], y_mm: ["Y", "mm"], z_mm: ["Z", "mm"], rotation_deg: ["R", "°"] };
/** @type {readonly TargetPath[]} */
const PATHS = ["movj", "movl", "jump", "vector"];

/** Status text of the target, and its tone. @param {Context} context @returns {[string, string]} */
function statusOf({ page, t }) {
  const { target } = page;
  if (!target.typed) return [t("target.hint"), "off"];
  if (!placeOf(target)) return [t("target.number"), "off"];
  if (target.path === "vector" && !(Number(target.speed) > 0)) return [t("target.speed.number"), "off"];
  if (target.goes) return [t("target.going"), "good"];
  switch (target.check.type) {
    case "unknown":
      return [t("target.checking"), "off"];
    case "refused":
      return [problemText(t, target.check.problem), "bad"];
    case "free": {
      const { takes_s } = target.check;
      return [takes_s === null ? t("target.free.untimed") : t("target.free", { time: takes_s.toFixed(1) }), "good"];
    }
  }
}

/** The speed and the tool of a line. @param {Context} context */
const lineFields = ({ page: { target }, t, act }) => html`
  <div class="row">
    <label class="field"><span>${t("target.speed")} <small>mm/s</small></span>
      <input id="target-speed" type="text" inputmode="decimal" autocomplete="off" .value=${live(target.speed)}
        @input=${(/** @type {Event} */ event) => act.send({ type: "target_speed", text: /** @type {HTMLInputElement} */ (event.target).value })}></label>
    <label class="check"><input id="target-burns" type="checkbox" .checked=${live(target.burns)} @change=${(/** @type {Event} */ event) => act.send({ type: "target_burns", burns: /** @type {HTMLInputElement} */ (event.target).checked })}> ${t("target.burns")}</label>
  </div>`;

/** @param {Context} context */
export function targetPanel(context) {
  const { page, t, act } = context;
  const { target } = page;
  const [text, tone] = statusOf(context);
  const why = blockedReason(page);
  const nearest = target.check.type === "refused" ? target.check.problem.nearest_mm : null;
  const arm = page.station?.arm;
  const isLine = target.path === "vector";
  const submit = (/** @type {SubmitEvent} */ event) => {
    event.preventDefault();
    act.go();
  };
  return html`
    <section class="card" aria-labelledby="target-title">
      <h2 id="target-title">${t("target")} <small>${t("target.live")}</small></h2>
      <form id="target" novalidate @submit=${submit}>
        <div class="fields">
          ${FIELDS.map((field) => html`<label><span>${NAMES[field][0]} <small>${NAMES[field][1]}</small></span>
            <input id="target-${field}" type="text" inputmode="decimal" autocomplete="off" ?disabled=${isLine && field === "rotation_deg"} placeholder=${arm ? arm[field].toFixed(1) : ""} .value=${live(target.typed?.[field] ?? "")}
              @input=${(/** @type {Event} */ event) => act.send({ type: "target_typed", field, text: /** @type {HTMLInputElement} */ (event.target).value })}></label>`)}
        </div>
        <fieldset class="segments">
          <legend>${t("target.path")}</legend>
          ${PATHS.map((path) => html`<label><input type="radio" name="path" value=${path} .checked=${live(path === target.path)} @change=${() => act.send({ type: "target_path", path })}><span>${t(`target.${path}`)}</span></label>`)}
        </fieldset>
        ${isLine ? lineFields(context) : nothing}
        <p id="target-status" class="status" role="status" data-tone=${tone}>${why && target.check.type === "free" ? t(`blocked.${why}`) : text}</p>
        <div class="row">
          <button id="target-go" type="submit" class="strong" ?disabled=${target.check.type !== "free" || why !== null || target.goes}>${t("target.go")}</button>
          ${nearest ? html`<button id="target-nearest" type="button" @click=${() => act.send({ type: "target_placed", place: { x_mm: nearest[0], y_mm: nearest[1], z_mm: nearest[2] } })}>${t("target.nearest")}</button>` : nothing}
          ${target.typed ? html`<button id="target-clear" type="button" @click=${() => act.send({ type: "target_cleared" })}>${t("target.clear")}</button>` : nothing}
          <button id="home" type="button" class="end" title=${t("target.home.hint")} ?disabled=${why !== null} @click=${() => act.home()}>${t("target.home")}</button>
        </div>
      </form>
    </section>`;
}
