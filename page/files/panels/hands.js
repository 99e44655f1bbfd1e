// The arm follows a hand in front of the camera.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { blockedReason } from "../state/selectors.js";

/** Refusals that have words of the page. */
const KNOWN = new Set(["insecure", "not_allowed", "none", "unplugged"]);

/** @param {import("../views/context.js").Context} context */
export function hands(context) {
  const { t, hands: requests } = context;
  return html`
    <details class="card" id="hands" @toggle=${(/** @type {Event} */ event) => (/** @type {HTMLDetailsElement} */ (event.currentTarget).open ? requests.open() : requests.close())}>
      <summary><h2>${t("hands")}</h2></summary>
      ${content(context)}
    </details>`;
}

/** @param {import("../views/context.js").Context} context */
function content({ page, t, hands: requests }) {
  const { view, refused, state, share, closed } = page.hands;
  const detail = refused && (KNOWN.has(refused) ? t(/** @type {"look.refused.none"} */ (`look.refused.${refused}`)) : refused);
  const why = blockedReason(page);
  switch (view) {
    case "closed":
      return nothing;
    case "not_installed":
      return html`<p id="hands-status" class="quiet">${t("hands.not_installed")}</p>`;
    case "refused":
      return html`<p id="hands-status" class="status" role="status" data-tone="warn">${detail}</p>
        <div class="row"><button type="button" @click=${() => requests.open()}>${t("look.again")}</button></div>`;
    default:
      return html`
        <p class="quiet">${t("hands.hint")}</p>
        <div id="hands-picture" data-state=${state}>${requests.video}<progress max="10" value=${share} aria-label=${t("hands.opening")}></progress></div>
        <p id="hands-status" class="status" role="status" data-tone=${state === "controls" && !why ? "good" : "off"}>${view !== "on" ? t(`hands.${view}`) : why ? t(`blocked.${why}`) : detail ? detail : t(state === "controls" && closed ? "hands.closed" : `hands.${state}`)}</p>`;
  }
}
