// What the link does, and what happened.

import { html } from "../vendor/lit-html/lit-html.js";
import { repeat } from "../vendor/lit-html/directives/repeat.js";

/** @typedef {import("../views/context.js").Context} Context */

/** @param {Context} context */
export const watch = (context) => html`${link(context)}${happened(context)}`;

/** @param {Context} context */
function link({ page, say }) {
  const { station } = page;
  if (!station) return html``;
  const { link, dialect, queue, clients } = station;
  const rows = /** @type {const} */ ([
    ["watch.address", "address", link.address ?? say("watch.not_found")],
    ["watch.dialect", "dialect", dialect ?? say("watch.not_known")],
    ["watch.statuses", "statuses", say("watch.statuses.value", { rate: link.statuses_per_s.toFixed(1) })],
    ["watch.lost", "lost", say("watch.lost.value", { statuses: link.lost_statuses, bytes: link.damaged_bytes })],
    ["watch.latency", "latency", link.latency_ms === null ? say("watch.not_known") : say("watch.ms", { ms: link.latency_ms.toFixed(0) })],
    ["watch.waiting", "queue", say("watch.waiting.value", { here: queue.waiting, under_way: queue.under_way, s: queue.ahead_s.toFixed(1) })],
    ["watch.clients", "clients", String(clients)],
  ]);
  return html`
    <section class="card" aria-labelledby="link-title">
      <h2 id="link-title">${say("watch.link")}</h2>
      ${link.problem ? html`<p id="link-problem" class="told" data-tone="warn">${link.problem}</p>` : ""}
      <dl class="list">${rows.map(([word, id, value]) => html`<div><dt>${say(word)}</dt><dd id=${id}>${value}</dd></div>`)}</dl>
    </section>`;
}

/** @param {Context} context */
function happened({ page, say }) {
  const now_s = page.station?.at_s ?? 0;
  const newest = page.notices.slice(-60).reverse();
  const time = (/** @type {number} */ at_s) => new Date(page.heard_ms - Math.max(0, now_s - at_s) * 1000).toLocaleTimeString(page.language);
  return html`
    <section class="card" aria-labelledby="notices-title">
      <h2 id="notices-title">${say("watch.happened")}</h2>
      <ol id="notices" class="notices" aria-live="polite">
        ${repeat(newest, ({ number }) => number, ({ at_s, text }) => html`<li><time>${time(at_s)}</time> ${text}</li>`)}
      </ol>
      <p class="quiet"><a href="api/v1/openapi.json">${say("watch.api")}</a> (OpenAPI)</p>
    </section>`;
}
