// Connection figures, charts, events and packets.

import { html } from "../vendor/lit-html/lit-html.js";
import { chart } from "../parts/chart.js";
import { linkProblem } from "../state/selectors.js";
import { packets } from "./packets.js";
import { repeat } from "../vendor/lit-html/directives/repeat.js";

/** @typedef {import("../views/context.js").Context} Context */
/** @typedef {import("../i18n/i18n.js").TextKey} TextKey */
/** @typedef {import("../state/history.js").History} History */

/** @param {Context} context */
export const watch = (context) => html`${link(context)}${charts(context)}${happened(context)}${packets(context)}`;

/** The charts, by related values. @type {readonly (readonly [TextKey, readonly [number, number], readonly (readonly [keyof History, TextKey, string])[]])[]} */
const CHARTS = [
  ["chart.rate", [0, 15], [["rate", "watch.statuses", "--key"]]],
  ["chart.latency", [0, 50], [["latency_ms", "watch.latency", "--key"]]],
  ["chart.queue", [0, 5], [["queue", "watch.waiting", "--key"]]],
  ["chart.joints", [-10, 90], [["base_deg", "pose.base", "--line-1"], ["rear_deg", "pose.rear", "--line-2"], ["fore_deg", "pose.fore", "--line-3"], ["servo_deg", "pose.servo", "--line-4"]]],
];
/** Lines also differ by their dashes. */
const DASHES = [[], [8, 4], [2, 3], [8, 3, 2, 3]];

/** The newest value of a line, in words. @param {readonly (number | null)[]} values */
const last = (values) => values.at(-1)?.toFixed(1) ?? "–";

/** @param {Context} context */
function charts({ page, t }) {
  const { history } = page;
  const now_s = history.at_s.at(-1) ?? 0;
  const times = history.at_s.map((at_s) => (at_s ?? 0) - now_s);
  const theme = document.documentElement.dataset.theme;
  return html`
    <section class="card" aria-labelledby="charts-title">
      <h2 id="charts-title">${t("charts")}</h2>
      ${CHARTS.map(([title, seen, lines]) => html`
        <figure class="chart" aria-label=${t(title)}>
          <figcaption>${t(title)} ${lines.map(([name, word], n) => html`<span class="line-${n + 1}">${lines.length > 1 ? t(word) : ""} <b data-last=${name}>${last(history[name])}</b></span>`)}</figcaption>
          <div ${chart([times, ...lines.map(([name]) => history[name])], lines.map(([, word, color], n) => ({ name: t(word), color, dash: DASHES[n] })), seen, `${theme} ${page.language}`)}></div>
        </figure>`)}
    </section>`;
}

/** @param {Context} context */
function link({ page, t }) {
  const { station } = page;
  if (!station) return html``;
  const { link, dialect, queue, clients } = station;
  const rows = /** @type {const} */ ([
    ["watch.address", "address", link.address ?? t("watch.not_found")],
    ["watch.dialect", "dialect", dialect ?? t("watch.not_known")],
    ["watch.statuses", "statuses", t("watch.statuses.value", { rate: link.statuses_per_s.toFixed(1) })],
    ["watch.lost", "lost", t("watch.lost.value", { statuses: link.lost_statuses, bytes: link.damaged_bytes })],
    ["watch.latency", "latency", link.latency_ms === null ? t("watch.not_known") : t("watch.ms", { ms: link.latency_ms.toFixed(0) })],
    ["watch.waiting", "queue", t("watch.waiting.value", { here: queue.waiting, in_flight: queue.under_way, s: queue.ahead_s.toFixed(1) })],
    ["watch.clients", "clients", String(clients)],
  ]);
  return html`
    <section class="card" aria-labelledby="link-title">
      <h2 id="link-title">${t("watch.link")}</h2>
      ${link.problem ? html`<p id="link-problem" class="status" data-tone="warn">${linkProblem(link)}</p>` : ""}
      <dl class="list">${rows.map(([word, id, value]) => html`<div><dt>${t(word)}</dt><dd id=${id}>${value}</dd></div>`)}</dl>
    </section>`;
}

/** @param {Context} context */
function happened({ page, t, act }) {
  const now_s = page.station?.at_s ?? 0;
  const filter = page.filter.toLowerCase();
  const newest = page.notices.filter(({ text }) => text.toLowerCase().includes(filter)).slice(-60).reverse();
  const time = (/** @type {number} */ at_s) => new Date(page.received_ms - Math.max(0, now_s - at_s) * 1000).toLocaleTimeString(page.language);
  return html`
    <section class="card" aria-labelledby="notices-title">
      <h2 id="notices-title">${t("watch.events")}</h2>
      <input id="filter" type="text" placeholder=${t("watch.filter")} aria-label=${t("watch.filter")} .value=${page.filter} @input=${(/** @type {Event} */ event) => act.send({ type: "filter", text: /** @type {HTMLInputElement} */ (event.target).value })}>
      <ol id="notices" class="notices" aria-live="polite">
        ${repeat(newest, ({ number }) => number, ({ at_s, text }) => html`<li><time>${time(at_s)}</time> ${text}</li>`)}
      </ol>
      <p class="quiet"><a href="api/v1/openapi.json">${t("watch.api")}</a> (OpenAPI)</p>
    </section>`;
}
