// All packets between station and arm, in both directions, decoded.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { live } from "../vendor/lit-html/directives/live.js";
import { repeat } from "../vendor/lit-html/directives/repeat.js";
import { saveAs } from "../parts/download.js";
import { exported, line, wanted } from "../state/packets.js";
import { problemText } from "../i18n/problem_text.js";

/** @typedef {import("../views/context.js").Context} Context */
/** @typedef {import("../state/packets.js").Passed} Passed */

/** The most packets shown; the export has all that are kept. */
const SEEN = 120;
const WAYS = /** @type {const} */ (["both", "to_arm", "from_arm"]);
const ARROWS = { to_arm: "→", from_arm: "←" };

/** @param {Context} context */
export function packets(context) {
  const { page, t, act } = context;
  const { listening } = page.packets;
  // Only the state decides whether it is open: a frame may be drawn before the browser's toggle event.
  const toggle = (/** @type {Event} */ event) => {
    event.preventDefault();
    act.send({ type: "packets_wanted", listening: !listening });
  };
  return html`
    <details id="packets" class="card" ?open=${listening}>
      <summary @click=${toggle}><h2>${t("packets")} <small>${t("packets.what")}</small></h2></summary>
      ${listening ? list(context) : nothing}
    </details>`;
}

/** @param {Context} context */
function list({ page, t, act }) {
  const { frozen, way, filter, lost, problem } = page.packets;
  const found = wanted(page.packets);
  const newest = found.slice(-SEEN).reverse();
  return html`
    <fieldset class="segments">
      <legend class="unseen">${t("packets.direction")}</legend>
      ${WAYS.map((choice) => html`<label><input type="radio" name="packets-way" value=${choice} .checked=${live(choice === way)} @change=${() => act.send({ type: "packets_way", way: choice })}><span>${t(`packets.direction.${choice}`)}</span></label>`)}
    </fieldset>
    <input id="packets-filter" type="text" placeholder=${t("watch.filter")} aria-label=${t("watch.filter")} .value=${live(filter)} @input=${(/** @type {Event} */ event) => act.send({ type: "packets_filter", text: /** @type {HTMLInputElement} */ (event.target).value })}>
    <div class="row">
      <button id="packets-pause" type="button" class="small strong" @click=${() => act.send({ type: "packets_frozen", frozen: frozen === null })}>${t(frozen ? "packets.resume" : "packets.pause")}</button>
      <button id="packets-clear" type="button" class="small" @click=${() => act.send({ type: "packets_cleared" })}>${t("packets.clear")}</button>
      <button id="packets-save" type="button" class="small" ?disabled=${!found.length} @click=${() => saveAs(new Blob([exported(found)], { type: "application/jsonl" }), "packets.jsonl")}>${t("packets.save")}</button>
      <span id="packets-count" class="quiet">${t("packets.count", { count: found.length })}</span>
    </div>
    ${problem ? html`<p id="packets-problem" class="status" data-tone="bad" role="alert">${problemText(t, problem)}</p>` : nothing}
    ${lost ? html`<p id="packets-lost" class="status" data-tone="warn">${t("packets.lost", { count: lost })}</p>` : nothing}
    <ol class="packets">${repeat(newest, ({ number }) => number, row)}</ol>`;
}

/** @param {Passed} packet */
const row = (packet) => html`
  <li><details data-way=${packet.direction}>
    <summary><time>${packet.at_s.toFixed(2)}</time> <span aria-hidden="true">${ARROWS[packet.direction]}</span> <span class="says">${line(packet)}</span></summary>
    <p class="bytes">${packet.bytes.match(/../g)?.join(" ")}</p>
  </details></li>`;
