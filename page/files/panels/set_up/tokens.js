// Access from other computers: tokens, and a QR code for phones.

import { html, nothing, svg } from "../../vendor/lit-html/lit-html.js";
import { encode } from "../../vendor/uqr/uqr.js";
import { refusal } from "./arm.js";

/** @typedef {import("../../views/context.js").Context} Context */
/** @typedef {import("../../state/types.js").Role} Role */

/** @type {readonly Role[]} */
const ROLES = ["watch", "queue", "control", "admin"];

/** An address as a QR code. @param {string} text @param {string} label */
function qr(text, label) {
  const { data, size } = encode(text, { border: 3 });
  const cells = data.flatMap((row, y) => row.flatMap((dark, x) => (dark ? [`M${x} ${y}h1v1h-1z`] : []))).join("");
  return svg`<svg class="qr" viewBox=${`0 0 ${size} ${size}`} role="img" aria-label=${label} shape-rendering="crispEdges"><rect width=${size} height=${size}/><path d=${cells}/></svg>`;
}

/** @param {Context} context */
export function tokens(context) {
  const { page, t, act } = context;
  const { tokens, made, addresses, needs_network } = page.set_up;
  if (!tokens) return nothing;
  const make = (/** @type {SubmitEvent} */ event) => {
    event.preventDefault();
    const form = /** @type {HTMLFormElement} */ (event.target);
    const field = (/** @type {string} */ name) => /** @type {HTMLInputElement} */ (form.elements.namedItem(name));
    void act.setUp.makeToken(field("name").value.trim(), /** @type {Role} */ (field("role").value), field("shared").checked);
    form.reset();
  };
  const isLoopback = ["localhost", "127.0.0.1", "[::1]"].includes(location.hostname);
  const site = isLoopback ? (addresses[0] ?? location.origin) : location.origin;
  // After the #, the token is in no log.
  const address = made ? `${site}/#token=${made.secret}` : "";
  const phone = (/** @type {SubmitEvent} */ event) => {
    event.preventDefault();
    const role = /** @type {HTMLSelectElement} */ (/** @type {HTMLFormElement} */ (event.currentTarget).elements.namedItem("role"));
    void act.setUp.usePhone(/** @type {Role} */ (role.value));
  };
  const roles = (/** @type {string} */ label) => html`<select name="role" aria-label=${label}>${ROLES.map((role) => html`<option value=${role} ?selected=${role === "control"}>${t(`role.${role}`)}</option>`)}</select>`;
  return html`
    <section class="card" aria-labelledby="tokens-title">
      <h2 id="tokens-title">${t("tokens")}</h2>
      <p class="quiet">${t("tokens.hint")}</p>
      <ul class="tokens">
        ${tokens.map(({ name, role, shared }) => html`<li><span>${name} <b class="chip">${t(`role.${role}`)}</b>${shared ? html` <b class="chip">${t("tokens.is_shared")}</b>` : nothing}</span>
          <button type="button" class="small" aria-label=${t("tokens.remove", { name })} @click=${() => act.question({ about: "remove_token", values: { name } })}>×</button></li>`)}
      </ul>
      <form id="phone" class="row" @submit=${phone}>
        <button id="phone-use" type="submit" class="small strong">${t("phone.use")}</button>
        ${roles(t("phone.role"))}
      </form>
      ${needs_network ? html`<p id="phone-near" class="status" data-tone="warn" role="status">${t("phone.near")}</p>` : nothing}
      <form id="token-new" class="row" @submit=${make}>
        <input name="name" type="text" required maxlength="60" autocomplete="off" placeholder=${t("tokens.name")} aria-label=${t("tokens.name")}>
        ${roles(t("tokens.role"))}
        <label class="check"><input name="shared" type="checkbox"> ${t("tokens.shared")}</label>
        <button type="submit" class="small">${t("tokens.create")}</button>
      </form>
      ${made ? html`
        <div id="token-made" class="made" role="status">
          <p><strong>${t("tokens.once", { name: made.name })}</strong></p>
          ${qr(address, t("tokens.qr"))}
          <p><code id="token-secret">${made.secret}</code></p>
          <p class="quiet"><a id="token-address" href=${address} rel="noreferrer">${address.slice(0, 60)}…</a></p>
          <p class="status" data-tone=${isLoopback && !addresses.length ? "warn" : "off"}>${t(isLoopback && !addresses.length ? "phone.near" : "phone.hint")}</p>
        </div>` : nothing}
      ${refusal(context, "tokens")}
    </section>`;
}
