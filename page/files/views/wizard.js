// Places that are touched with the arm: a named point, a tray from three corners, a frame from three places.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { live } from "../vendor/lit-html/directives/live.js";

/** @typedef {import("./context.js").Context} Context */
/** @typedef {import("../state/teach.js").Wizard} Wizard */

/** @type {readonly Wizard["kind"][]} */
const KINDS = ["point", "tray", "frame"];
/** The places of each kind. */
const PLACES = /** @type {const} */ ({ point: ["wizard.here"], tray: ["wizard.first_cell", "wizard.row_end", "wizard.column_end"], frame: ["wizard.origin", "wizard.on_x", "wizard.beside"] });
/** @type {readonly ("columns" | "rows" | "layers")[]} */
const COUNTS = ["columns", "rows", "layers"];

/** @param {Context} context */
export function wizard(context) {
  const { page, t, act } = context;
  const { kind, name, places, layer_mm, layers } = page.teach.wizard;
  const set = (/** @type {Partial<Wizard>} */ values) => act.send({ type: "teach_wizard", set: values });
  const text = (/** @type {Event} */ event) => /** @type {HTMLInputElement} */ (event.target).value;
  const needed = PLACES[kind];
  // A program needs a step, and only a tray brings one.
  const isEmpty = kind !== "tray" && page.teach.text.trim() === "";
  const ready = !isEmpty && name.trim() !== "" && needed.every((_, n) => places[n]);
  return html`
    <details id="wizard">
      <summary>${t("wizard")}</summary>
      <div class="row">
        <fieldset class="segments">
          <legend class="unseen">${t("wizard.kind")}</legend>
          ${KINDS.map((choice) => html`<label><input type="radio" name="wizard-kind" value=${choice} .checked=${live(choice === kind)} @change=${() => set({ kind: choice, places: [] })}><span>${t(`wizard.${choice}`)}</span></label>`)}
        </fieldset>
        <label>${t("wizard.name")} <input id="wizard-name" type="text" maxlength="40" .value=${live(name)} @input=${(/** @type {Event} */ event) => set({ name: text(event) })}></label>
      </div>
      <ol class="wizard-places">
        ${needed.map((place, n) => html`<li><button type="button" class="small" data-touch=${n} ?disabled=${!page.station?.arm || n > places.length} @click=${() => act.teach.touch(n)}>${t(place)}</button> <span class="quiet">${touched(places[n])}</span></li>`)}
      </ol>
      ${kind === "tray" ? html`
        <div class="row">
          ${COUNTS.map((count) => html`<label>${t(`wizard.${count}`)} <input id="wizard-${count}" class="wizard-count" type="number" min="1" max="1000" step="1" .value=${live(String(page.teach.wizard[count]))} @input=${(/** @type {Event} */ event) => set({ [count]: Number(text(event)) })}></label>`)}
          ${layers > 1 ? html`<label>${t("wizard.layer_mm")} <input id="wizard-layer-mm" class="wizard-count" type="number" step="any" .value=${live(String(layer_mm))} @input=${(/** @type {Event} */ event) => set({ layer_mm: Number(text(event)) })}> mm</label>` : nothing}
        </div>` : nothing}
      <div class="row"><button id="wizard-add" type="button" ?disabled=${!ready} @click=${() => void act.teach.addTouched()}>${t("wizard.add")}</button></div>
      <p class="quiet">${t(isEmpty ? "wizard.empty" : `wizard.${kind}.hint`)}</p>
    </details>`;
}

/** @param {import("../state/teach.js").Touched | undefined} place */
const touched = (place) => (place ? `✓ ${place.point_mm.map((mm) => mm.toFixed(1)).join(", ")} mm` : "");
