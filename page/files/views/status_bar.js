// The status bar: live state of arm, control and laser.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { hasControl, isVirtual, laser, othersTime } from "../state/selectors.js";
import { clientName, holderText } from "./people.js";
import { formatClock } from "../i18n/i18n.js";

/** @typedef {import("./context.js").Context} Context */

const LINK_TONES = { searching: "warn", listening: "warn", up: "good", lost: "bad" };
const LASER_TONES = { off: "off", armed: "warn", burning: "bad" };

/** @param {Context} context */
export function statusBar(context) {
  const { page, t } = context;
  const { station } = page;
  const open = page.connection === "open" && station !== null;
  const phase = open ? station.link.phase : page.connection === "connecting" ? "connecting" : "closed";
  const tone = open ? LINK_TONES[station.link.phase] : "off";
  const shines = laser(page);
  return html`
    <h1>Dobot <small>${isVirtual(page) ? t("strip.virtual") : station?.link.address ?? ""}</small></h1>
    <p id="link-chip" class="chip" data-tone=${tone} role="status">${t(/** @type {"link.up"} */ (`link.${phase}`))}</p>
    <p class="quiet wide" id="rate">${station ? t("strip.rate", { rate: station.link.statuses_per_s.toFixed(1) }) : nothing}</p>
    <p class="quiet wide">${station?.dialect ?? nothing}</p>
    ${page.fleet ? html`<a id="fleet" href="fleet">${t("fleet.link", { name: page.fleet })}</a>` : nothing}
    ${control(context)}
    <p id="laser-chip" class="chip" data-tone=${LASER_TONES[shines]}>${t(/** @type {"laser.off"} */ (`laser.${shines}`), { left: formatClock(station?.laser.armed_for_s ?? 0) })}</p>`;
}

/** The lease holder, and the buttons to request or release control. @param {Context} context */
function control(context) {
  const { page, t, act } = context;
  const { station, me } = page;
  if (!station) return nothing;
  const { lease } = station;
  const mine = hasControl(page);
  const asked = lease?.asked_by.some((client) => client.client === me) ?? false;
  if (othersTime(page)) return html`<div class="control"><span id="holder">${t("slots.holder", { name: lease ? clientName(t, lease) : t("slots.nobody") })}</span></div>`;
  return html`
    <div class="control">
      <span id="holder" role="status">${holderText(page, t)}</span>
      ${lease === null || (lease.is_program && !mine) ? html`<button id="take" type="button" class="small" @click=${() => act.ask({ type: "take_lease" })}>${t("control.take")}</button>` : nothing}
      ${mine ? html`<button id="release" type="button" class="small" @click=${() => act.ask({ type: "release_lease" })}>${t("control.release")}</button>` : nothing}
      ${lease && !mine && !lease.is_program ? html`<button id="ask" type="button" class="small" ?disabled=${asked} @click=${() => act.ask({ type: "ask_lease" })}>${t(asked ? "control.requested" : "control.request")}</button>` : nothing}
      ${mine ? lease?.asked_by.map(({ client, ...who }) => html`<button type="button" class="small strong give" @click=${() => act.ask({ type: "grant_lease", to: client })}>${t("control.hand_over", { name: clientName(t, who) })}</button>`) : nothing}
    </div>`;
}
