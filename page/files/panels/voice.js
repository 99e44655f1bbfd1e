// Voice mode commands, as buttons and as text.

import { html } from "../vendor/lit-html/lit-html.js";
import { blockedReason } from "../state/selectors.js";
import { talk } from "./talk.js";

/** The commands, in English for every language of the page. */
const WORDS = /** @type {const} */ ({ forward: "ahead ten", back: "back ten", left: "left ten", right: "right ten", up: "up ten", down: "down ten", catch: "catch", release: "release" });

/** @param {import("../views/context.js").Context} context */
export function voice(context) {
  const { page, t, act } = context;
  const why = blockedReason(page) !== null;
  const tell = (/** @type {SubmitEvent} */ event) => {
    event.preventDefault();
    const text = /** @type {HTMLInputElement} */ (/** @type {HTMLFormElement} */ (event.target).elements.namedItem("text")).value.trim();
    if (text) void act.command({ type: "voice", text });
  };
  return html`
    <details class="card" id="voice" @toggle=${(/** @type {Event} */ event) => (/** @type {HTMLDetailsElement} */ (event.currentTarget).open ? act.talk.open() : act.talk.close())}>
      <summary><h2>${t("voice")}</h2></summary>
      ${talk(context)}
      <p class="quiet">${t("voice.hint")}</p>
      <div class="row words">
        ${Object.entries(WORDS).map(([word, text]) => html`<button type="button" class="small" data-say=${text} ?disabled=${why} @click=${() => act.command({ type: "voice", text })}>${t(/** @type {"voice.catch"} */ (`voice.${word}`))}</button>`)}
      </div>
      <form id="say" class="row" @submit=${tell}>
        <input id="say-text" name="text" type="text" maxlength="40" autocomplete="off" required aria-label=${t("voice.text")}>
        <button type="submit" ?disabled=${why}>${t("voice.send")}</button>
      </form>
    </details>`;
}
