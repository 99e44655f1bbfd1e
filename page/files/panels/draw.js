// Draw: source, position, settings, the station's plan, and Start.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { live } from "../vendor/lit-html/directives/live.js";
import { repeat } from "../vendor/lit-html/directives/repeat.js";
import { player } from "../preview/preview.js";
import { accepted, formatNames, hasSubject, withFieldNames, wrongField } from "../state/draw.js";
import { paperOf } from "../state/paper.js";
import { blockedReason, isVirtual } from "../state/selectors.js";
import { problemText, sentence } from "../i18n/problem_text.js";
import { formatDuration } from "../i18n/i18n.js";
import { sheet } from "./sheet.js";

/** @typedef {import("../views/context.js").Context} Context */
/** @typedef {import("../state/draw.js").Settings} Settings */

const FONTS = /** @type {const} */ (["sans", "script", "serif", "gothic"]);
const LAYERS = /** @type {const} */ (["nothing", "color", "group"]);
/** The most warnings shown. */
const MOST_WARNINGS = 8;

/** @param {Context} context */
export const draw = (context) => html`${subject(context)}${place(context)}${way(context)}${plan(context)}${context.page.draw.timeline ? player(context) : nothing}`;

const value = (/** @type {Event} */ event) => /** @type {HTMLInputElement} */ (event.target).value;
const checked = (/** @type {Event} */ event) => /** @type {HTMLInputElement} */ (event.target).checked;

/** @param {Context} context */
function subject({ page, t, act }) {
  const { what, file, text, formats } = page.draw;
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
      @input=${(/** @type {Event} */ event) => act.send({ type: "draw_set", set: { [name]: value(event) } })}></label>`;

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
      ${sheet(context)}
      <div class="fields">
        ${field(context, "x", "mm", "210")}${field(context, "y", "mm", "0")}
        ${field(context, "scale", "%", percent)}${field(context, "rotate", "°", "0")}
      </div>
      <div class="row">${check(context, "fit")}${check(context, "clip")}</div>
      <div class="fields">
        ${field(context, "down", "mm", page.draw.paper ? t("draw.measured") : String(paperOf(page)))}
        <button id="draw-here" type="button" class="small here" title=${t("draw.here.hint")} ?disabled=${!page.station?.arm} @click=${() => act.send({ type: "draw_set", set: { down: (page.station?.arm?.z_mm ?? 0).toFixed(1) } })}>${t("draw.here")}</button>
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
        ${check(context, "hatch")}`}
      <div class="fields">
        ${field(context, "speed", "mm/s", "")}${field(context, "tolerance", "mm", "0.05")}
        ${draw.what === "text" ? field(context, "height", "mm", "10") : nothing}
      </div>
    </section>`;
}

/** A text of the station, with the page's field names. @param {Context["t"]} t @param {string} text */
const named = (t, text) => sentence(withFieldNames(t, text));

/** Status text of the plan, and its tone. @param {Context} context @returns {[string, string]} */
function statusOf({ page, t }) {
  const { draw } = page;
  if (wrongField(draw.set)) return [t("target.number"), "off"];
  switch (draw.phase) {
    case "nothing":
      return ["", "off"];
    case "planning":
      return [t("draw.planning"), "off"];
    case "failed":
      return draw.problem ? [named(t, problemText(t, draw.problem)), "bad"] : [t("draw.cancelled"), "off"];
    case "planned": {
      const refused = draw.planned?.plan.refused;
      if (refused) return [problemText(t, refused), "bad"];
      const figures = draw.planned?.plan.timeline;
      const strokes = figures?.passes.reduce((sum, pass) => sum + pass.strokes, 0) ?? 0;
      const ink_mm = figures?.passes.reduce((sum, pass) => sum + pass.ink_mm, 0) ?? 0;
      return [t(draw.planned?.plan.burns ? "draw.planned.burn" : "draw.planned", { time: formatDuration(t, figures?.duration_s ?? 0), strokes, ink: (ink_mm / 1000).toFixed(2) }), "good"];
    }
  }
}

/** @param {Context} context */
function plan(context) {
  const { page, t, act } = context;
  const { draw } = page;
  if (!hasSubject(draw)) return nothing;
  const [text, tone] = statusOf(context);
  const why = blockedReason(page);
  const ready = draw.phase === "planned" && !draw.planned?.plan.refused && draw.drawing !== null && why === null;
  const warnings = draw.planned?.plan.warnings ?? [];
  const tool = page.around?.tool.kind;
  const needsPen = isVirtual(page) && tool !== undefined && tool !== "pen" && !draw.planned?.plan.burns;
  return html`
    <section class="card" aria-labelledby="draw-plan">
      <h2 id="draw-plan">${t("draw.plan")}</h2>
      <p id="draw-status" class="status" role="status" data-tone=${tone}>${draw.phase === "planned" && why ? t(`blocked.${why}`) : text}</p>
      ${warnings.length ? html`<ul id="draw-warnings" class="warnings">${repeat(warnings.slice(0, MOST_WARNINGS), (warning) => warning, (warning) => html`<li>${named(t, warning)}.</li>`)}${warnings.length > MOST_WARNINGS ? html`<li>${t("draw.more", { count: warnings.length - MOST_WARNINGS })}</li>` : nothing}</ul>` : nothing}
      ${needsPen ? html`<p class="status" data-tone="warn">${t("draw.no_pen")} <button id="draw-pen" type="button" class="small" @click=${() => act.addPen()}>${t("draw.add_pen")}</button></p>` : nothing}
      <div class="row">
        <button id="draw-start" type="button" class="strong" ?disabled=${!ready} @click=${() => act.draw("whole")}>${t("draw.start")}</button>
        <button id="draw-frame" type="button" title=${t("draw.frame.hint")} ?disabled=${!ready} @click=${() => act.draw("frame")}>${t("draw.frame")}</button>
        ${draw.phase === "planning" ? html`<button id="draw-cancel" type="button" class="end" @click=${() => act.send({ type: "draw_cancelled" })}>${t("draw.cancel")}</button>` : nothing}
      </div>
    </section>`;
}
