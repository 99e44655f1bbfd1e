// One tab for each panel.

import { html } from "../vendor/lit-html/lit-html.js";

/** @typedef {import("./context.js").Context} Context */

/** @type {readonly import("../state/state.js").Tab[]} */
export const TABS = ["move", "draw", "teach", "look", "jobs", "watch", "set_up"];
const WAYS = /** @type {Record<string, number>} */ ({ ArrowRight: 1, ArrowLeft: -1 });

/** @param {Context} context */
export function tabs({ page, t, act }) {
  // From the tab that has the focus: the page may not have drawn the one before yet.
  const step = (/** @type {KeyboardEvent} */ event, /** @type {number} */ from) => {
    const way = WAYS[event.key];
    if (!way) return;
    event.preventDefault();
    const next = /** @type {import("../state/state.js").Tab} */ (TABS[(from + way + TABS.length) % TABS.length]);
    act.send({ type: "tab", tab: next });
    document.getElementById(`tab-${next}`)?.focus();
  };
  return html`${TABS.map((tab, at) => html`
    <button type="button" role="tab" id="tab-${tab}" aria-selected=${tab === page.tab ? "true" : "false"} aria-controls="panel" tabindex=${tab === page.tab ? 0 : -1}
      @click=${() => act.send({ type: "tab", tab })} @keydown=${(/** @type {KeyboardEvent} */ event) => step(event, at)}>${t(`tab.${tab}`)}</button>`)}`;
}
