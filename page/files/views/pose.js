// Pose numbers and camera buttons on the stage.

import { html } from "../vendor/lit-html/lit-html.js";
import { recorded } from "../state/recordings.js";

/** @typedef {import("./context.js").Context} Context */
/** @typedef {import("../i18n/i18n.js").TextKey} TextKey */

/** @type {readonly import("../stage/view.js").Preset[]} */
const PRESETS = ["iso", "top", "side", "tool"];
/** @type {readonly ["x_mm" | "y_mm" | "z_mm" | "rotation_deg" | "base_deg" | "rear_deg" | "fore_deg" | "servo_deg", string, TextKey | null, "mm" | "°"][]} */
const NUMBERS = [
  ["x_mm", "X", null, "mm"],
  ["y_mm", "Y", null, "mm"],
  ["z_mm", "Z", null, "mm"],
  ["rotation_deg", "R", "pose.rotation", "°"],
  ["base_deg", "J1", "pose.base", "°"],
  ["rear_deg", "J2", "pose.rear", "°"],
  ["fore_deg", "J3", "pose.fore", "°"],
  ["servo_deg", "J4", "pose.servo", "°"],
];

/** The numbers of what the stage shows. @param {Context} context */
export function pose({ page, t }) {
  const then = recorded(page.recordings);
  const arm = then ?? page.station?.arm;
  const moving = !then && (page.station?.arm?.moving ?? false);
  return html`
    <dl class="pose" id="pose" aria-label=${t("pose")}>
      ${NUMBERS.map(([field, short, word, unit], n) => html`
        <div class=${n < 4 ? "tip" : "joint"} title=${word ? t(word) : short}>
          <dt>${short}${word ? html` <span class="full">${t(word)}</span>` : ""}</dt>
          <dd><output data-pose=${field}>${arm ? arm[field].toFixed(1) : "–"}</output> <small>${unit}</small></dd>
        </div>`)}
    </dl>
    <p id="moving" class="moving" data-moving=${String(moving)}>${then ? t("recorded") : arm ? t(moving ? "pose.moving" : "pose.at_rest") : ""}</p>`;
}

/** @param {Context} context */
export const cameras = ({ page, t, look }) => html`
  ${page.flattened ? html`<p id="flattened" class="flattened" role="status">${t("camera.flattened")}</p>` : ""}
  <div class="cameras" role="group" aria-label=${t("camera")}>
    ${PRESETS.map((preset) => html`<button type="button" class="small" data-look=${preset} @click=${() => look(preset)}>${t(/** @type {TextKey} */ (`camera.${preset}`))}</button>`)}
  </div>`;
