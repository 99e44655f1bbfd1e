// Faults and scene of the virtual arm.

import { html } from "../../vendor/lit-html/lit-html.js";
import { refusal } from "./arm.js";

/** @typedef {import("../../views/context.js").Context} Context */
/** @typedef {import("../../i18n/i18n.js").TextKey} TextKey */

/** Common faults by name. @type {readonly [TextKey, string][]} */
const FAULTS = [
  ["fault.drop", "drop=1%"],
  ["fault.flip", "flip=0.1%"],
  ["fault.delay", "delay=50ms"],
  ["fault.withhold", "withhold@5s..8s"],
  ["fault.reset", "reset@3s"],
  ["fault.power", "power@3s..6s"],
  ["fault.backlash", "backlash=base:0.3"],
];

/** Worlds to begin with. @type {readonly [TextKey, string][]} */
const WORLDS = [
  ["world.pen", "# A pen over a sheet of paper.\n[paper]\nx_mm = [150, 298]\ny_mm = [-105, 105]\n\n[pen]\ndown_z_mm = -40           # z of the arm when the pen touches the paper\ngive_mm = 2\nwidth_mm = 0.5\n"],
  ["world.cubes", '# A suction cup and two cubes.\n[suction-cup]\ndown_z_mm = -60           # z of the arm when the cup touches the table\ngive_mm = 3\ndiameter_mm = 12\nlifts_g = 500\n\n[[box]]\nname = "red cube"\nsize_mm = [20, 20, 20]\nat_mm = [220, 60]\nmass_g = 10\ncolor = "red"\n\n[[box]]\nname = "blue cube"\nsize_mm = [20, 20, 20]\nat_mm = [220, -60]\nmass_g = 10\ncolor = "blue"\n'],
];

/** @param {Context} context */
export function virtualArm(context) {
  const { page, t, act } = context;
  const area = (/** @type {string} */ id) => /** @type {HTMLTextAreaElement} */ (document.getElementById(id));
  const lines = (/** @type {string} */ text) => text.split("\n").map((line) => line.trim()).filter(Boolean);
  const add = (/** @type {string} */ fault) => {
    area("faults-text").value = [...lines(area("faults-text").value), fault].join("\n");
  };
  return html`
    <section class="card" aria-labelledby="faults-title">
      <h2 id="faults-title">${t("faults")}</h2>
      <p class="quiet">${t("faults.hint")}</p>
      <div class="row">${FAULTS.map(([word, fault]) => html`<button type="button" class="small" data-fault=${fault} @click=${() => add(fault)}>${t(word)}</button>`)}</div>
      <textarea id="faults-text" rows="4" spellcheck="false" aria-label=${t("faults")} .value=${(page.set_up.faults ?? []).join("\n")}></textarea>
      <div class="row">
        <button id="faults-set" type="button" class="small strong" @click=${() => act.setUp.setFaults(lines(area("faults-text").value))}>${t("faults.apply")}</button>
        <button id="faults-none" type="button" class="small" @click=${() => { area("faults-text").value = ""; void act.setUp.setFaults([]); }}>${t("faults.clear")}</button>
        <span id="faults-now" class="quiet" role="status">${page.set_up.faults?.length ? t("faults.active", { count: page.set_up.faults.length }) : t("faults.none")}</span>
      </div>
      ${refusal(context, "faults")}
    </section>
    <section class="card" aria-labelledby="world-title">
      <h2 id="world-title">${t("world")}</h2>
      <p class="quiet">${t("world.hint")}</p>
      <div class="row">${WORLDS.map(([word, scene]) => html`<button type="button" class="small" data-world=${word} @click=${() => { area("world-text").value = scene; }}>${t(word)}</button>`)}</div>
      <textarea id="world-text" rows="10" spellcheck="false" aria-label=${t("world")}></textarea>
      <div class="row"><button id="world-set" type="button" class="small strong" @click=${() => act.setUp.setWorld(area("world-text").value)}>${t("world.apply")}</button></div>
      ${refusal(context, "world")}
    </section>`;
}
