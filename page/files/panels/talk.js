// Hold to talk: shown while a listener runs next to the station.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { blockedReason } from "../state/selectors.js";

/** Refusals that have words of the page. */
const KNOWN = new Set(["insecure", "not_allowed", "none", "unplugged"]);

/** @param {import("../views/context.js").Context} context */
export function talk({ page, t, act }) {
  const { listens, microphone, refused, holds, heard, order } = page.talk;
  if (!listens) return html`<p class="quiet" id="talk-off">${t("talk.off")}</p>`;
  if (refused) return html`
    <p class="status" id="talk-refused" role="status" data-tone="warn">${KNOWN.has(refused) ? t(/** @type {"talk.refused.none"} */ (`talk.refused.${refused}`)) : refused}</p>
    <div class="row"><button type="button" id="talk-again" @click=${() => act.talk.again()}>${t("look.again")}</button></div>`;
  const why = blockedReason(page);
  const press = (/** @type {PointerEvent} */ event) => {
    if (event.button !== 0) return;
    /** @type {Element} */ (event.currentTarget).setPointerCapture(event.pointerId);
    act.talk.hold();
  };
  const isKey = (/** @type {KeyboardEvent} */ { key }) => key === "Enter";
  return html`
    <div class="row">
      <button type="button" id="talk-hold" class="strong" aria-pressed=${holds ? "true" : "false"} ?disabled=${microphone !== "on"}
        @pointerdown=${press} @lostpointercapture=${() => act.talk.release()} @blur=${() => act.talk.release()}
        @keydown=${(/** @type {KeyboardEvent} */ event) => isKey(event) && !event.repeat && act.talk.hold()}
        @keyup=${(/** @type {KeyboardEvent} */ event) => isKey(event) && act.talk.release()}>${t(holds ? "talk.holds" : "talk.hold")}</button>
      ${order ? html`<button type="button" id="talk-go" ?disabled=${why !== null} @click=${() => act.talk.go()}>${t("talk.go")}</button>
        <button type="button" id="talk-no" @click=${() => act.talk.forget()}>${t("talk.no")}</button>` : nothing}
    </div>
    <p id="talk-heard" class="status" role="status" data-tone=${order && why === null ? "good" : "off"}>${order ? t("talk.order", { words: order.words }) : heard === null || holds ? t("talk.hint") : t(`talk.${heard}`)} ${order && why ? t(`blocked.${why}`) : nothing}</p>`;
}
