// Draw: source, position, settings and warnings; the plan and Start are at the lower edge.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { live } from "../vendor/lit-html/directives/live.js";
import { repeat } from "../vendor/lit-html/directives/repeat.js";
import { player } from "../preview/preview.js";
import { GCODE, LAYERS, accepted, formatNames, hasSubject, isGcode, wrongField } from "../state/draw.js";
import { files, theirs } from "./files.js";
import { paperOf } from "../state/paper.js";
import { named, startBar } from "./draw_start.js";
import { sheet } from "./sheet.js";

/** @typedef {import("../views/context.js").Context} Context */
/** @typedef {import("../state/draw.js").Settings} Settings */

const FONTS = /** @type {const} */ (["sans", "script", "serif", "gothic", "hand"]);
/** The most warnings shown. */
const MOST_WARNINGS = 8;

/** @param {Context} context */
export const draw = (context) => html`${subject(context)}${files(context, false)}${place(context)}${way(context)}${warnings(context)}${context.page.draw.timeline ? player(context) : nothing}${startBar(context)}`;

const value = (/** @type {Event} */ event) => /** @type {HTMLInputElement} */ (event.target).value;
const checked = (/** @type {Event} */ event) => /** @type {HTMLInputElement} */ (event.target).checked;

/** @param {Context} context */
function subject({ page, t, act }) {
  const { what, text, formats } = page.draw;
  const file = page.draw.file ?? page.draw.stored;
  const chosen = (/** @type {Event} */ event) => {
    const input = /** @type {HTMLInputElement} */ (event.target);
    if (input.files?.[0]) act.openFile(input.files[0]);
    // Choosing the same file again is a change too: its content may be new.
    input.value = "";
  };
  return html`
    <section class="card" aria-labelledby="draw-title">
      <h2 id="draw-title">${t("draw")}</h2>
      <fieldset class="segments">
        <legend>${t("draw.what")}</legend>
        ${/** @type {const} */ (["file", "text"]).map((source) => html`<label><input type="radio" name="draw-what" value=${source} .checked=${live(source === what)} @change=${() => act.send({ type: "draw_what", what: source })}><span>${t(`draw.${source}`)}</span></label>`)}
      </fieldset>
      ${what === "text" ? html`<textarea id="draw-text" rows="2" aria-label=${t("draw.text")} .value=${live(text)} @input=${(/** @type {Event} */ event) => act.send({ type: "draw_text", text: value(event) })}></textarea>` : html`
        <div class="drop">
          <p>${file ? html`<strong id="draw-name">${file.name}</strong>` : t("draw.drop", { formats: formatNames(formats) })}</p>
          <input id="draw-file" type="file" accept=${accepted(formats)} aria-label=${t("draw.choose")} @change=${chosen}>
          <label for="draw-file" class="button">${t(file ? "draw.another" : "draw.choose")}</label>
        </div>`}
    </section>`;
}

/** A field for a number. @param {Context} context @param {keyof Settings} name @param {string} unit @param {string} placeholder */
const field = ({ page, t, act }, name, unit, placeholder) => html`
  <label><span>${t(/** @type {import("../i18n/i18n.js").TextKey} */ (`draw.${name}`))} <small>${unit}</small></span>
    <input id="draw-${name}" type="text" inputmode="decimal" autocomplete="off" placeholder=${placeholder} aria-invalid=${wrongField(page.draw.set) === name ? "true" : "false"} .value=${live(String(page.draw.set[name]))}
      @change=${() => act.send({ type: "draw_settled" })} @input=${(/** @type {Event} */ event) => act.send({ type: "draw_set", set: { [name]: value(event) } })}></label>`;

/** @param {Context} context @param {"hatch" | "clip" | "fit"} name */
const check = ({ page, t, act }, name) => html`
  <label class="check"><input id="draw-${name}" type="checkbox" .checked=${live(page.draw.set[name])} @change=${(/** @type {Event} */ event) => act.send({ type: "draw_set", set: { [name]: checked(event) } })}> ${t(`draw.${name}`)}</label>`;

/** @param {Context} context */
function place(context) {
  const { page, t, act } = context;
  if (!hasSubject(page.draw)) return nothing;
  const percent = page.draw.planned ? (100 * page.draw.planned.plan.scale).toFixed(0) : "100";
  return html`
    <section class="card" aria-labelledby="draw-place">
      <h2 id="draw-place">${t("draw.place")} <small>${t("draw.place.hint")}</small></h2>
      ${theirs(context)}
      ${sheet(context)}
      <div class="row">
        <button id="draw-undo" type="button" class="small" ?disabled=${!page.draw.past.length} @click=${() => act.send({ type: "draw_undo" })}>${t("teach.undo")}</button>
        <button id="draw-redo" type="button" class="small" ?disabled=${!page.draw.future.length} @click=${() => act.send({ type: "draw_redo" })}>${t("teach.redo")}</button>
      </div>
      <div class="fields">
        ${field(context, "x", "mm", "210")}${field(context, "y", "mm", "0")}
        ${field(context, "scale", "%", percent)}${field(context, "rotate", "°", "0")}
      </div>
      <div class="row">${check(context, "fit")}${check(context, "clip")}</div>
      <div class="fields">
        ${field(context, "down", "mm", page.draw.paper ? t("draw.measured") : String(paperOf(page)))}
        <button id="draw-here" type="button" class="small here" title=${t("draw.here.hint")} ?disabled=${!page.station?.arm} @click=${() => act.useHeight()}>${t("draw.here")}</button>
      </div>
    </section>`;
}

/** A choice of pens and materials. @param {Context} context @param {string} id @param {string} chosen @param {string} label @param {(name: string) => void} choose */
function pens({ page, t }, id, chosen, label, choose) {
  const group = (/** @type {"pen" | "laser"} */ tool) => html`
    <optgroup label=${t(`draw.${tool}s`)}>${page.draw.materials.filter((material) => material.tool === tool).map(({ name }) => html`<option value=${name} ?selected=${name === chosen}>${name}</option>`)}</optgroup>`;
  return html`<select id=${id} aria-label=${label} .value=${live(chosen)} @change=${(/** @type {Event} */ event) => choose(value(event))}>${group("pen")}${group("laser")}</select>`;
}

/** @param {Context} context */
function way(context) {
  const { page, t, act } = context;
  const { draw } = page;
  if (!hasSubject(draw)) return nothing;
  const set = (/** @type {Partial<Settings>} */ set) => act.send({ type: "draw_set", set });
  const layers = draw.set.layers === "nothing" ? [] : (draw.planned?.plan.timeline.passes ?? []);
  return html`
    <section class="card" aria-labelledby="draw-way">
      <h2 id="draw-way">${t("draw.settings")}</h2>
      <div class="setting"><span>${t("draw.tool")}</span>${pens(context, "draw-tool", draw.set.tool, t("draw.tool"), (tool) => set({ tool }))}</div>
      ${draw.what === "text" ? html`
        <div class="setting"><span>${t("draw.font")}</span><select id="draw-font" aria-label=${t("draw.font")} .value=${live(draw.set.font)} @change=${(/** @type {Event} */ event) => set({ font: value(event) })}>${FONTS.map((font) => html`<option value=${font}>${font}</option>`)}</select></div>` : html`
        <div class="setting"><span>${t("draw.layers")}</span><select id="draw-layers" aria-label=${t("draw.layers")} .value=${live(draw.set.layers)} @change=${(/** @type {Event} */ event) => set({ layers: /** @type {Settings["layers"]} */ (value(event)) })}>${LAYERS.map((choice) => html`<option value=${choice}>${t(`draw.layers.${choice}`)}</option>`)}</select></div>
        ${layers.map(({ name }, n) => html`<div class="setting layer"><span class="swatch" data-pass=${n}>${name}</span>${pens(context, `draw-layer-${n}`, draw.set.pens[name] ?? draw.set.tool, `${t("draw.layer")} ${name}`, (pen) => set({ pens: { ...draw.set.pens, [name]: pen } }))}</div>`)}
        ${isGcode(draw) ? html`
          <div class="setting"><span>${t("draw.gcode")}</span><select id="draw-gcode" aria-label=${t("draw.gcode")} .value=${live(draw.set.gcode)} @change=${(/** @type {Event} */ event) => set({ gcode: /** @type {Settings["gcode"]} */ (value(event)) })}>${GCODE.map((choice) => html`<option value=${choice}>${t(`draw.gcode.${choice}`)}</option>`)}</select></div>` : nothing}
        ${check(context, "hatch")}`}
      <div class="fields">
        ${field(context, "speed", "mm/s", "")}${field(context, "tolerance", "mm", "0.05")}
        ${draw.what === "text" ? field(context, "height", "mm", "10") : nothing}
      </div>
    </section>`;
}

/** What the plan warns of. @param {Context} context */
function warnings({ page, t }) {
  const all = page.draw.planned?.plan.warnings ?? [];
  if (!hasSubject(page.draw) || !all.length) return nothing;
  return html`
    <section class="card" aria-labelledby="draw-plan">
      <h2 id="draw-plan">${t("draw.plan")}</h2>
      <ul id="draw-warnings" class="warnings">${repeat(all.slice(0, MOST_WARNINGS), (warning) => warning, (warning) => html`<li>${named(t, warning)}.</li>`)}${all.length > MOST_WARNINGS ? html`<li>${t("draw.more", { count: all.length - MOST_WARNINGS })}</li>` : nothing}</ul>
    </section>`;
}
