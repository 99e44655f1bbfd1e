// The header of the board: counts, filters, class tools and warnings.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { live } from "../vendor/lit-html/directives/live.js";
import { confirmation } from "../views/confirm.js";
import { tokenForm } from "../views/token.js";
import { formatDuration } from "../i18n/i18n.js";
import { SORTS, count, giver, groups, isMeant, isThere, lockOf, nameOf, recipients } from "./members.js";
import { counts } from "./queue.js";
import { problemText } from "../i18n/problem_text.js";
import { outcomeText, outcomeTone, toText } from "./outcome_text.js";

/** @typedef {import("./fleet.js").Context} Context */
/** @typedef {import("../i18n/i18n.js").TextKey} TextKey */

/** Age at which a banner reports it. */
const OLD_MS = 2000;
const SORT_TONES = { running: "good", stopped: "bad", offline: "warn", locked: "warn", stuck: "warn" };

/** @param {Context} context */
export function header(context) {
  const { board, t, act } = context;
  const all = groups(board.members);
  return html`
    <h1>${t("fleet")} <small>${board.name ? html`<a href="./" title=${t("fleet.page.own")}>${t("fleet.seen_by", { name: board.name })}</a>` : nothing}</small></h1>
    <div id="count" role="group" aria-label=${t("fleet.sort")}>
      <span class="chip" data-tone="off" role="status">${t("fleet.online", { there: board.members.filter(isThere).length, all: board.members.length })}</span>
      ${SORTS.map((sort) => chip(context, sort))}
    </div>
    <div class="sift">
      <input id="filter" type="text" aria-label=${t("fleet.filter")} placeholder=${t("fleet.filter")} .value=${live(board.filter)} @input=${(/** @type {Event} */ event) => act.send({ type: "filter", text: /** @type {HTMLInputElement} */ (event.target).value })}>
      ${all.length ? html`
        <select id="group" aria-label=${t("fleet.group")} @change=${(/** @type {Event} */ event) => act.send({ type: "group", group: /** @type {HTMLSelectElement} */ (event.target).value || null })}>
          <option value="" .selected=${live(board.group === null)}>${t("fleet.groups.all")}</option>
          ${all.map((name) => html`<option value=${name} .selected=${live(name === board.group)}>${name}</option>`)}
        </select>` : nothing}
      <button id="lesson-open" type="button" class="small" aria-expanded=${String(board.lesson)} aria-controls="lesson" @click=${() => act.send({ type: "lesson", open: !board.lesson })}>${t("fleet.lesson")}</button>
      ${armButton(context)}
      ${queueButton(context)}
    </div>
    ${wanting(context)}
    ${lesson(context)}`;
}

/** Opens the queue; the button shows jobs of uncertain state, which need a person. @param {Context} context */
function queueButton({ board, t, act }) {
  const { open } = board.queue, { open: number, doubt } = counts(board.queue.all);
  return html`<button id="queue-open" type="button" class="small" data-tone=${doubt ? "warn" : "off"} aria-expanded=${String(open)} aria-controls="queue" @click=${() => act.send({ type: "queue_open", open: !open })}>${t(doubt ? "fleet.queue.open.doubt" : "fleet.queue.open", { number, doubt })}</button>`;
}

/** Opens the form for those who have no arm, where a station gives virtual ones. @param {Context} context */
function armButton({ board, t, act }) {
  if (!giver(board.members)) return nothing;
  return html`<button id="arm-open" type="button" class="small" aria-expanded=${String(board.wanting)} aria-controls="arm" @click=${() => act.send({ type: "wanting", open: !board.wanting })}>${t("fleet.arm.open")}</button>`;
}

/** The form to request a virtual arm. @param {Context} context */
function wanting({ board, t, act }) {
  const from = giver(board.members);
  if (!from || !board.wanting) return nothing;
  const ask = async (/** @type {SubmitEvent} */ event) => {
    event.preventDefault();
    const field = /** @type {HTMLInputElement} */ (/** @type {HTMLFormElement} */ (event.currentTarget).elements.namedItem("name"));
    const answers = await act.giveArm(from.name, nameOf(field.value));
    if (answers.some(({ answer }) => answer.status < 300)) field.value = "";
  };
  return html`
    <form id="arm" @submit=${ask}>
      <label for="arm-name">${t("fleet.arm.text", { giver: from.name })}</label>
      <input id="arm-name" name="name" type="text" maxlength="40" autocomplete="off" autocapitalize="none" spellcheck="false" required placeholder=${t("fleet.arm.name")}>
      <button id="arm-give" type="submit" class="small strong">${t("fleet.arm.create")}</button>
    </form>`;
}

/** The number of members in a category; pressed, only these are shown. @param {Context} context @param {import("./members.js").Sort} sort */
function chip({ board, t, act }, sort) {
  const number = count(board.members, sort), pressed = board.sort === sort;
  if (!number && !pressed) return nothing;
  return html`<button type="button" class="chip" data-sort=${sort} data-tone=${SORT_TONES[sort]} aria-pressed=${String(pressed)} @click=${() => act.send({ type: "sort", sort: pressed ? null : sort })}>${t(/** @type {TextKey} */ (`fleet.sort.${sort}`), { number })}</button>`;
}

/** Words to all, or to the group that is shown: a message, "eyes on me", and the pictures of what was drawn. @param {Context} context */
function lesson({ board, t, act }) {
  const to = recipients(board.group);
  const meant = board.members.filter((member) => isThere(member) && isMeant(to, member));
  const name = toText(t, to, board.language);
  const text = (/** @type {Event} */ event) => /** @type {HTMLInputElement} */ (/** @type {HTMLElement} */ (event.currentTarget).closest("form")?.elements.namedItem("text"));
  const write = async (/** @type {SubmitEvent} */ event) => {
    event.preventDefault();
    const field = text(event);
    const answers = await act.message(to, field.value.trim());
    if (answers.some(({ answer }) => answer.status < 300)) field.value = "";
  };
  const lock = (/** @type {Event} */ event) => act.lock(to, text(event).value.trim() || t("fleet.eyes"));
  return html`
    <form id="lesson" data-open=${String(board.lesson)} @submit=${write}>
      <input id="lesson-text" name="text" type="text" maxlength="200" autocomplete="off" required aria-label=${t("fleet.message.to", { to: name })} placeholder=${t("fleet.message.to", { to: name })}>
      <button id="send" type="submit" class="small">${t("fleet.message.send")}</button>
      <button id="lock" type="button" class="small strong" title=${t("fleet.lock.hint")} @click=${lock}>${t("fleet.lock", { to: name })}</button>
      ${meant.some(({ state }) => lockOf(state)) ? html`<button id="release" type="button" class="small" @click=${() => act.release(to)}>${t("fleet.release", { to: name })}</button>` : nothing}
      <button id="slots-open" type="button" class="small" aria-expanded=${String(board.slots.open)} aria-controls="slots" @click=${() => act.send({ type: "slots_open", open: !board.slots.open })}>${t("fleet.slots.of", { to: name })}</button>
      <button id="drawings" type="button" class="small" ?disabled=${!meant.some(({ about }) => about?.is_virtual)} title=${t("fleet.drawings.hint")} @click=${() => void act.saveDrawings(to)}>${t("fleet.drawings", { to: name })}</button>
    </form>`;
}

/** @param {Context} context */
export function banners(context) {
  const { board, t, act } = context;
  return html`
    ${lost(context)}
    ${board.connection === "alone" ? html`<p id="alone" class="banner" data-tone="warn" role="status">${t("fleet.alone")}</p>` : nothing}
    ${board.denied ? html`<div id="denied">${tokenForm(t, problemText(t, board.denied), act.useToken)}<button type="button" class="small" @click=${() => act.send({ type: "outcome_closed", what: "denied" })}>${t("close")}</button></div>` : nothing}`;
}

/** Nothing on a board may look as if it were now when it is not. @param {Context} context */
function lost({ board: { connection, received_ms, now_ms }, t }) {
  const quiet_ms = now_ms - received_ms;
  const isLost = connection === "closed" || (connection === "open" && quiet_ms > OLD_MS);
  if (!isLost) return nothing;
  const text = received_ms ? t("fleet.lost", { age: formatDuration(t, quiet_ms / 1000) }) : t("fleet.lost.never");
  return html`<p id="lost" class="banner" data-tone="bad" role="alert">${text}</p>`;
}

/** @param {Context} context */
export function toasts(context) {
  const { board: { request }, t, act } = context;
  if (!request) return nothing;
  const close = html`<button id="outcome-close" type="button" class="small" aria-label=${t("close.message")} @click=${() => act.send({ type: "outcome_closed", what: "request" })}>${t("close")}</button>`;
  return html`<section id="outcome" class="banner" data-tone=${outcomeTone(context, request)} role="status"><p>${outcomeText(context, request)}</p>${close}</section>`;
}

/** @param {Context} context */
export const question = ({ board, t, act }) => (board.question ? confirmation(t, board.question, act.answer) : nothing);
