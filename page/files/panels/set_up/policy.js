// The safety policy: keep-out zones as fields, all rules as text. The stage shows the zones of the draft.

import { html, nothing } from "../../vendor/lit-html/lit-html.js";
import { live } from "../../vendor/lit-html/directives/live.js";
import { unlessFocused } from "../../parts/unless_focused.js";
import { shownPolicy } from "../../state/selectors.js";
import { isChanged } from "../../state/set_up.js";
import { problemText } from "../../i18n/problem_text.js";
import { refusal } from "./arm.js";

/** @typedef {import("../../views/context.js").Context} Context */
/** @typedef {import("../../state/types.js").Schemas["KeepOut"]} Zone */

/** Something new that stands on the table. @param {number} table_z_mm @returns {Record<"box" | "cylinder", Zone>} */
const created = (table_z_mm) => ({
  box: { box: { x_mm: [200, 260], y_mm: [80, 140], z_mm: [table_z_mm, 0] } },
  cylinder: { cylinder: { x_mm: 180, y_mm: -180, radius_mm: 30, z_mm: [table_z_mm, 60] } },
});

/** The numbers of a zone: what each is called, its value, and the zone with another one. @param {Zone} zone @returns {[name: string, value: number, to: (value: number) => Zone][]} */
function numbersOf(zone) {
  if ("box" in zone) {
    const { box } = zone;
    return /** @type {const} */ (["x_mm", "y_mm", "z_mm"]).flatMap((axis) => [0, 1].map((n) => {
      /** @type {[string, number, (value: number) => Zone]} */
      const row = [`${axis[0].toUpperCase()} ${n ? "≤" : "≥"}`, box[axis][n] ?? 0, (value) => ({ box: { ...box, [axis]: box[axis].map((it, k) => (k === n ? value : it)) } })];
      return row;
    }));
  }
  const { cylinder } = zone;
  return [
    ["X", cylinder.x_mm, (x_mm) => ({ cylinder: { ...cylinder, x_mm } })],
    ["Y", cylinder.y_mm, (y_mm) => ({ cylinder: { ...cylinder, y_mm } })],
    ["R", cylinder.radius_mm, (radius_mm) => ({ cylinder: { ...cylinder, radius_mm } })],
    ["Z ≥", cylinder.z_mm[0] ?? 0, (low) => ({ cylinder: { ...cylinder, z_mm: [low, cylinder.z_mm[1] ?? 0] } })],
    ["Z ≤", cylinder.z_mm[1] ?? 0, (high) => ({ cylinder: { ...cylinder, z_mm: [cylinder.z_mm[0] ?? 0, high] } })],
  ];
}

/** @param {Context} context */
export function policy(context) {
  const { page, t, act } = context;
  const { draft, check, overtaken } = page.set_up;
  if (draft === null) return nothing;
  const mayKeep = page.role === "admin";
  const shown = shownPolicy(page), zones = shown?.keep_out ?? {};
  const write = (/** @type {string} */ text) => act.send({ type: "policy_typed", text });
  const changed = isChanged(page.set_up);
  const statusText = check.type === "bad" ? problemText(t, check.problem) : changed ? t(mayKeep ? "policy.changed" : "policy.admin") : t("policy.in_force");
  const tone = check.type === "bad" ? "bad" : changed ? "warn" : "off";
  return html`
    <section class="card" aria-labelledby="policy-title">
      <h2 id="policy-title">${t("policy")}</h2>
      <h3>${t("policy.zones")}</h3>
      <div id="zones">${Object.entries(zones).map(([name, zone]) => zoneRow(context, name, zone, (keep_out) => void act.setUp.editKeepOut(keep_out ? { type: "replace", name, keep_out } : { type: "remove", name })))}</div>
      ${Object.keys(zones).length ? nothing : html`<p class="quiet">${t("policy.no_zones")}</p>`}
      <div class="row">
        ${(/** @type {const} */ (["box", "cylinder"])).map((shape) => html`<button type="button" class="small" data-new-zone=${shape} ?disabled=${check.type !== "good" || !shown}
          @click=${() => shown && act.setUp.editKeepOut({ type: "add", keep_out: created(shown.table.z_mm)[shape] })}>${t(`policy.new_${shape}`)}</button>`)}
      </div>
      <details id="policy-text-part">
        <summary><h3>${t("policy.text")}</h3></summary>
        <textarea id="policy-text" rows="16" spellcheck="false" aria-label=${t("policy.text")} aria-describedby="policy-status" .value=${live(draft)}
          @input=${(/** @type {Event} */ event) => write(/** @type {HTMLTextAreaElement} */ (event.target).value)}></textarea>
      </details>
      <p id="policy-status" class="status" role="status" data-tone=${tone}>${statusText}</p>
      ${overtaken ? html`<p class="status" data-tone="warn">${t("policy.conflict")}</p>` : nothing}
      <div class="row">
        <button id="policy-keep" type="button" class="strong" ?disabled=${!changed || check.type !== "good" || !mayKeep} @click=${() => act.setUp.keepPolicy()}>${t("policy.apply")}</button>
        <button id="policy-forget" type="button" ?disabled=${!changed} @click=${() => act.send({ type: "policy_forgotten" })}>${t("policy.discard")}</button>
      </div>
      ${refusal(context, "policy")}
    </section>`;
}

/** @param {Context} context @param {string} name @param {Zone} zone @param {(zone: Zone | null) => void} write */
function zoneRow({ t }, name, zone, write) {
  return html`
    <fieldset class="zone" data-zone=${name}>
      <legend>${name}</legend>
      ${numbersOf(zone).map(([label, value, to]) => html`<label>${label} <input type="number" step="any" .value=${unlessFocused(String(value))} @change=${(/** @type {Event} */ event) => {
        const number = /** @type {HTMLInputElement} */ (event.target).valueAsNumber;
        if (Number.isFinite(number)) write(to(number));
      }}></label>`)}
      <button type="button" class="small" aria-label=${t("policy.remove", { name })} @click=${() => write(null)}>×</button>
    </fieldset>`;
}
