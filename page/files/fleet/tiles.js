// The arms of the fleet, one tile each, in sections.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { repeat } from "../vendor/lit-html/directives/repeat.js";
import { stops } from "../input/stop_button.js";
import { isSamePerson, timeNow } from "../state/slots.js";
import { formatClock, formatDuration } from "../i18n/i18n.js";
import { learnerLine } from "./learners.js";
import { alarms, isStuck, isThere, pageOf, recipients, sections, share, toneOf } from "./members.js";
import { problemText } from "../i18n/problem_text.js";

/** @typedef {import("./fleet.js").Context} Context */
/** @typedef {import("./members.js").Member} Member */
/** @typedef {import("./members.js").Section} Section */

/** The most large tiles, and the number above which tiles are small. */
const FEW = 6, MANY = 24;
/** @param {Context} context */
export function tiles(context) {
  const { board, t } = context;
  const all = sections(board.members, board);
  const shown = all.flatMap(({ members }) => members);
  // One tile has its place in the order of the tab key; the arrow keys lead to the others.
  const first = shown.some(({ id }) => id === board.current) ? board.current : shown[0]?.id ?? null;
  if (!shown.length) return html`<p id="none" class="quiet">${board.members.length ? t("fleet.none.found") : board.connection === "open" ? t("fleet.none") : nothing}</p>`;
  return html`<div class="sections" data-size=${shown.length <= FEW ? "large" : shown.length <= MANY ? "medium" : "small"}>${repeat(all, ({ group }) => group, (it, n) => section(context, it, n, first))}</div>`;
}

/** @param {Context} context @param {Section} section @param {number} n @param {string | null} first */
function section(context, { group, members }, n, first) {
  const { t, act } = context;
  const there = members.filter(isThere).length;
  const listener = stops(() => void act.stop(recipients(group)));
  return html`
    <section class="group" aria-labelledby="group-${n}">
      <div class="group-head">
        <h2 id="group-${n}">${group ?? t("fleet.group.none")} <small>${t("fleet.online", { there, all: members.length })}</small></h2>
        ${group === null ? nothing : html`<button type="button" class="stops small" data-stop-group=${group} @pointerdown=${listener} @click=${listener}>${t("fleet.stop.group", { group })}</button>`}
      </div>
      <ul class="tiles">${repeat(members, ({ id }) => id, (member) => tile(context, member, first))}</ul>
    </section>`;
}

/** @param {Context} context @param {Member} member @param {string | null} first */
function tile({ board, t, act }, member, first) {
  const { id, name, here, presence, state } = member;
  const isFirst = id === first;
  const listener = stops(() => void act.stop({ members: [name] }));
  return html`
    <li class="tile" data-tone=${toneOf(member)} data-member=${name} data-presence=${presence.type}>
      <p class="head">
        <button type="button" class="name" tabindex=${isFirst ? 0 : -1} aria-expanded=${String(id === board.chosen)} aria-controls="details" aria-describedby="alarms-${id} says-${id}"
          @focus=${() => act.send({ type: "current", id })} @click=${() => act.send({ type: "chosen", id: id === board.chosen ? null : id })}>${name}</button>
        ${here ? html`<span class="quiet here">${t("fleet.here")}</span>` : nothing}
        <button type="button" class="stops small one" tabindex=${isFirst ? 0 : -1} aria-label=${t("fleet.stop.one", { name })} @pointerdown=${listener} @click=${listener}>${t("fleet.stop.short")}</button>
      </p>
      <div class="sight">
        <canvas class="picture" data-arm=${id} aria-hidden="true"></canvas>
        <p class="alarms" id="alarms-${id}">${alarms(member).map(({ word, tone }) => html`<span class="chip" data-tone=${tone}>${t(word, { left: formatClock(state?.laser.armed_for_s ?? 0) })}</span> `)}</p>
      </div>
      <div class="says" id="says-${id}">
        ${presence.type === "present" ? work(t, member) : gone(t, member)}
      </div>
    </li>`;
}

/** The job, and the lease holder. @param {Context["t"]} t @param {Member} member */
function work(t, { state, learners = [] }) {
  const job = state?.job, lease = state?.lease;
  // A tile has room for one student; the details show all.
  const learner = learners.find(isStuck) ?? learners[0];
  return html`
    ${job ? html`
      <p class="job"><span class="title">${job.title}</span> <span class="part">${Math.floor(share(job) * 100)} %</span></p>
      <progress max="1" data-phase=${job.phase} .value=${share(job)} aria-label=${t("job.progress")}></progress>` : html`<p class="job idle quiet">${t(state ? "fleet.idle" : "fleet.no_data")}</p>`}
    <p class="quiet who">${whose(t, state)}${lease?.asked_by.length ? html` · <span class="asks">${t("fleet.asks.number", { number: lease.asked_by.length })}</span>` : nothing}</p>
    ${learner ? learnerLine(t, learner, learners.length - 1) : nothing}`;
}

/** The time slot and the lease holder, once if they are the same person. @param {Context["t"]} t @param {Member["state"]} state */
function whose(t, state) {
  const now = timeNow(state), lease = state?.lease;
  if (!now) return lease?.name ?? t("fleet.free");
  const text = t("fleet.slots.now", { name: now.student, left: formatDuration(t, now.left_s) });
  return lease && !isSamePerson(lease.person || lease.name, now.student) ? `${text} · ${lease.name}` : text;
}

/** Why the state is unknown, and what to do. @param {Context["t"]} t @param {Member} member */
function gone(t, member) {
  const { presence } = member, page = pageOf(member);
  return html`
    <p class="why">${presence.type === "refused" ? problemText(t, presence.problem) : page ? html`<a href=${page} target="_blank" rel="noreferrer">${t("fleet.offline.stops")}</a>` : t("fleet.offline.stops")}</p>`;
}
