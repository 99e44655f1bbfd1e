// The Look panel: the camera's picture with what was found in it, and what can be done with that.

import { html, nothing, svg } from "../vendor/lit-html/lit-html.js";
import { live } from "../vendor/lit-html/directives/live.js";
import { HUES, MARKER_MM, hasCup, lookBlockedReason, spotInPicture, thingsOf, transferBlockedReason } from "../state/look.js";
import { onSheet } from "../vision/geometry.js";
import { unlessFocused } from "../parts/unless_focused.js";

/** @typedef {import("../views/context.js").Context} Context */
/** @typedef {import("../state/look.js").Thing} Thing */

/** Refusals that have words of the page. */
const KNOWN = new Set(["insecure", "not_allowed", "none", "unplugged", "no_connection"]);

/** @param {Context} context */
export function look(context) {
  const { page, t, act } = context;
  const { camera, refused, cameras, chosen, hue, answers } = page.look;
  const value = (/** @type {Event} */ event) => /** @type {HTMLSelectElement} */ (event.target).value;
  return html`
    <section class="card" aria-labelledby="look-title">
      <h2 id="look-title">${t("look")}</h2>
      ${camera === "on" ? picture(context) : html`<p id="look-off" class="drop quiet" role="status">${refused ? (KNOWN.has(refused) ? t(/** @type {"look.refused.none"} */ (`look.refused.${refused}`)) : refused) : t("look.asking")}</p>
        ${refused ? html`<div class="row"><button id="look-again" type="button" class="strong" @click=${() => act.look.open()}>${t("look.again")}</button></div>` : nothing}`}
      <div class="row look-choices">
        ${cameras.length > 1 ? html`<label class="field"><span>${t("look.camera")}</span><select id="look-camera" @change=${(/** @type {Event} */ event) => {
          act.send({ type: "look_set", set: { chosen: value(event) } });
          void act.look.open();
        }}>${cameras.map(({ id, label }) => html`<option value=${id} .selected=${live(id === chosen)}>${label || id}</option>`)}</select></label>` : nothing}
        <label class="field"><span>${t("look.hue")}</span><select id="look-hue" @change=${(/** @type {Event} */ event) => act.send({ type: "look_set", set: { hue: /** @type {keyof typeof HUES | ""} */ (value(event)) } })}>
          <option value="" .selected=${live(hue === "")}>${t("look.hue.off")}</option>
          ${Object.keys(HUES).map((name) => html`<option value=${name} .selected=${live(hue === name)}>${t(/** @type {"look.hue.red"} */ (`look.hue.${name}`))}</option>`)}</select></label>
        <label class="check"><input id="look-answers" type="checkbox" ?disabled=${camera !== "on"} .checked=${live(answers)} @change=${(/** @type {Event} */ event) => act.send({ type: "look_set", set: { answers: /** @type {HTMLInputElement} */ (event.target).checked } })}> ${t("look.answers")}</label>
      </div>
    </section>
    ${camera === "on" ? things(context) : nothing}`;
}

/** @param {Context} context */
function picture(context) {
  const { page, t, act } = context;
  const { seen, rate, spot, is_above, held, surface_mm } = page.look;
  const [wide, high] = seen?.view?.size ?? [640, 480];
  const why = lookBlockedReason(page), whyNoPlace = transferBlockedReason(page);
  const click = (/** @type {PointerEvent} */ event) => {
    const view = page.look.seen?.view;
    if (!view || why) return;
    const box = /** @type {Element} */ (event.currentTarget).getBoundingClientRect();
    const [x_mm, y_mm] = onSheet(view, [((event.clientX - box.left) / box.width) * wide, ((event.clientY - box.top) / box.height) * high], surface_mm);
    void act.look.above({ x_mm, y_mm });
  };
  const setSurface = (/** @type {HTMLInputElement} */ field) => {
    if (field.value !== "" && field.checkValidity()) act.send({ type: "look_surface", surface_mm: field.valueAsNumber });
  };
  const at = spotInPicture(page.look);
  const moved = seen?.troubles.find((it) => it === "sheet_moved" || it === "camera_moved");
  return html`
    <div id="look-picture" class=${why ? "is-blocked" : ""} data-rate=${rate.toFixed(1)} @click=${click}>
      ${act.look.video}
      <svg viewBox="0 0 ${wide} ${high}" aria-hidden="true">
        ${(seen?.markers ?? []).map(({ id, corners }) => svg`<polygon class=${id > 3 ? "object" : "corner"} points=${corners.map((corner) => corner.join(",")).join(" ")}></polygon>
          ${id > 3 ? svg`<text x=${corners[0][0]} y=${corners[0][1] - 4}>${id}</text>` : nothing}`)}
        ${seen?.blob ? svg`<circle class="blob" cx=${seen.blob[0]} cy=${seen.blob[1]} r="9"></circle>` : nothing}
        ${at ? svg`<path class="spot" d="M${at[0] - 9} ${at[1]}h18M${at[0]} ${at[1] - 9}v18"></path>` : nothing}
      </svg>
    </div>
    <p id="look-status" class="status" role="status" data-tone=${why ? "warn" : "good"}>${why ? t(why) : t("look.exact", { mm: (2 * (seen?.view?.typical_mm ?? 0)).toFixed(1), markers: seen?.view?.markers ?? 0 })} ${notes(context)}</p>
    <div class="row look-choices">
      <label class="field" title=${t("look.surface.hint")}><span>${t("look.surface")} <small>mm</small></span><input id="look-surface" type="number" min="0" max="150" step="any" .value=${unlessFocused(String(surface_mm))}
        @change=${(/** @type {Event} */ event) => setSurface(/** @type {HTMLInputElement} */ (event.target))}></label>
      ${moved ? html`<button id="look-settled" type="button" @click=${() => act.look.settled()}>${t(`look.settled.${moved}`)}</button>` : nothing}
      <button id="look-down" type="button" ?disabled=${why !== null || !is_above || !spot} @click=${() => act.look.down()}>${t("look.down")}</button>
      <button id="look-place" type="button" title=${whyNoPlace ? t(whyNoPlace) : ""} ?disabled=${whyNoPlace !== null || !spot || !held} @click=${() => act.look.place()}>${t("look.place")}</button>
    </div>`;
}

/** What is not quite right with the picture, but does not prevent its use. @param {Context} context */
const notes = ({ page, t }) => (page.look.seen?.troubles ?? []).filter((it) => it === "glare" || it === "camera_moved").map((it) => html`<br>${t(`look.${it}`)}`);

/** The objects. @param {Context} context */
function things(context) {
  const { page, t, act } = context;
  const all = thingsOf(page.look);
  const why = transferBlockedReason(page);
  const row = (/** @type {Thing} */ { name, marker, x_mm, y_mm, turn_deg, height_mm, measured_mm }) => {
    const label = marker === null ? t(/** @type {"look.hue.red"} */ (`look.hue.${name}`)) : t("look.marker", { number: marker });
    return html`
      <li class="entry" data-thing=${name}>
        <p class="head"><strong>${label}</strong> <span class="quiet">x ${x_mm.toFixed(1)}, y ${y_mm.toFixed(1)} mm${marker === null ? "" : `, ${turn_deg.toFixed(0)}°`}</span></p>
        <div class="row">
          <label class="field"><span>${t("look.height")} <small>mm</small></span><input type="number" min="0" max="150" step="any" .value=${unlessFocused(height_mm === null ? "" : String(height_mm))}
            @change=${(/** @type {Event} */ event) => setHeight(name, /** @type {HTMLInputElement} */ (event.target))}></label>
          ${height_mm === null && measured_mm !== null ? html`<button type="button" class="small" data-act="measure" title=${t("look.measured.hint", { side: MARKER_MM })} @click=${() => act.send({ type: "look_height", name, height_mm: Math.round(measured_mm) })}>${t("look.measured", { mm: measured_mm.toFixed(0) })}</button>` : nothing}
          <button type="button" class="small strong" data-act="pick" title=${why ? t(why) : ""} ?disabled=${why !== null || height_mm === null || !hasCup(page)} @click=${() => act.look.pick(name)}>${t("look.pick")}</button>
        </div>
      </li>`;
  };
  const setHeight = (/** @type {string} */ name, /** @type {HTMLInputElement} */ field) => {
    if (field.value !== "" && field.checkValidity()) act.send({ type: "look_height", name, height_mm: field.valueAsNumber });
  };
  return html`
    <section class="card" aria-labelledby="look-things">
      <h2 id="look-things">${t("look.things")}</h2>
      ${all.length === 0 ? html`<p class="quiet">${t("look.things.none")}</p>` : html`<ul class="jobs">${all.map(row)}</ul>`}
      ${all.length > 0 && !hasCup(page) ? html`<p class="quiet">${t("look.cup")}</p>` : all.some(({ height_mm }) => height_mm === null) ? html`<p class="quiet">${t("look.height.hint")}</p>` : nothing}
    </section>`;
}
