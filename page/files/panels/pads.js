// The mouse pad and the hand pad.

import { html } from "../vendor/lit-html/lit-html.js";
import { blockedReason } from "../state/selectors.js";

/** @typedef {import("../views/context.js").Context} Context */

/** Pointer position on a pad: up and left are 1, down and right -1. @param {PointerEvent} event @returns {[far: number, left: number]} */
function shares({ currentTarget, clientX, clientY }) {
  const { left, top, width, height } = /** @type {Element} */ (currentTarget).getBoundingClientRect();
  const share = (/** @type {number} */ value) => Math.max(-1, Math.min(1, 1 - 2 * value));
  return [share((clientY - top) / height), share((clientX - left) / width)];
}

/** @param {PointerEvent} event */
function capture(event) {
  if (event.button !== 0) return false;
  /** @type {Element} */ (event.currentTarget).setPointerCapture(event.pointerId);
  return true;
}

/** @param {PointerEvent} event */
const isHeld = ({ currentTarget, pointerId }) => /** @type {Element} */ (currentTarget).hasPointerCapture(pointerId);

/** @param {Context} context */
export function pads({ page, t, pads }) {
  const { mouse, hand } = pads;
  const why = blockedReason(page);
  const off = why !== null;
  const statusText = why ? t(`blocked.${why}`) : page.pad_refused;
  return html`
    <details class="card" id="pads">
      <summary><h2>${t("pads")}</h2></summary>
      <div class="two-pads">
        <div>
          <div id="mouse-pad" class="track" data-off=${String(off)} aria-label=${t("pads.mouse")} role="img"
            @pointerdown=${(/** @type {PointerEvent} */ event) => !off && capture(event) && mouse.begin()}
            @pointermove=${(/** @type {PointerEvent} */ event) => isHeld(event) && mouse.move(event.movementX, event.movementY)}
            @wheel=${(/** @type {WheelEvent} */ event) => (event.preventDefault(), mouse.lift(event.deltaY < 0 ? 2 : -2))}
            @lostpointercapture=${() => mouse.end()}><b>${t("pads.mouse")}</b></div>
          <p class="quiet">${t("pads.mouse.hint")}</p>
        </div>
        <div>
          <div id="hand-pad" class="track" data-off=${String(off)} aria-label=${t("pads.hand")} role="img"
            @pointerdown=${(/** @type {PointerEvent} */ event) => !off && capture(event) && hand.begin(...shares(event))}
            @pointermove=${(/** @type {PointerEvent} */ event) => isHeld(event) && hand.move(...shares(event))}
            @lostpointercapture=${() => hand.end()}><b>${t("pads.hand")}</b></div>
          <p class="quiet">${t("pads.hand.hint")}</p>
        </div>
      </div>
      <div class="row">
        <label>${t("pads.hand.height")} <input id="hand-height" type="number" min="-20" max="100" step="5" value="40" @change=${(/** @type {Event} */ event) => hand.height(/** @type {HTMLInputElement} */ (event.target).valueAsNumber || 0)}> mm</label>
        <label class="check"><input id="hand-grab" type="checkbox" @change=${(/** @type {Event} */ event) => hand.grab(/** @type {HTMLInputElement} */ (event.target).checked)}> ${t("pads.hand.grab")}</label>
      </div>
      <p id="pad-status" class="status" role="status" data-tone=${!why && page.pad_refused ? "bad" : "off"}>${statusText ?? ""}</p>
    </details>`;
}
