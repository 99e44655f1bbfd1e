// Banners above the stage: conditions that a user must know first.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { recorded } from "../state/recordings.js";
import { isVeryOld, othersTime, silence_ms } from "../state/selectors.js";
import { isSamePerson, timeNext, timeNow } from "../state/slots.js";
import { formatDuration } from "../i18n/i18n.js";
import { confirmation } from "./confirm.js";
import { sentence } from "../i18n/problem_text.js";
import { problemLine } from "./problem.js";
import { tokenForm } from "./token.js";

/** @typedef {import("./context.js").Context} Context */

/** When the next time slot, and the end of the current one, are announced. */
const SOON_S = 300, ENDS_S = 60;

/** @param {Context} context */
export const banners = (context) => html`${stale(context)}${locked(context)}${slot(context)}${stopped(context)}${untrusted(context)}${recording(context)}${token(context)}`;

/** Toasts overlay the page: nothing moves under a pointer. @param {Context} context */
export const toasts = (context) => html`${old(context)}${message(context)}${problem(context)}`;

/** @param {Context} context */
function old({ page, t }) {
  if (!isVeryOld(page)) return nothing;
  const why = t(page.connection === "open" ? "old.silent" : "old.connecting");
  return html`<p id="old" class="banner" data-tone="warn" role="status">${t("old", { age: formatDuration(t, silence_ms(page) / 1000), why })}</p>`;
}

/** The station was updated while this page was open. @param {Context} context */
function stale({ page, t }) {
  if (!page.is_stale) return nothing;
  return html`<section id="stale" class="banner" data-tone="warn" role="alert"><p>${t("stale")}</p><button id="stale-reload" type="button" @click=${() => location.reload()}>${t("stale.reload")}</button></section>`;
}

/** The arm is locked by the teacher. @param {Context} context */
function locked({ page, t }) {
  const lock = page.station?.lock;
  if (!lock) return nothing;
  return html`<p id="locked" class="banner" data-tone="warn" role="alert"><span><strong>${t("locked.title")}</strong> ${t("locked.by", { by: lock.by, why: lock.message ? `: ${lock.message}` : "" })}</span></p>`;
}

/** The current time slot. Screen readers announce only what changes rarely. @param {Context} context */
function slot(context) {
  const { page, t, act } = context;
  const { station } = page, now = timeNow(station), next = timeNext(station), others = othersTime(page);
  const isNext = next && next.in_s < SOON_S;
  if (!now && !isNext) return nothing;
  const mine = now !== null && isSamePerson(now.student, page.person);
  const title = now ? t(mine ? "slots.mine" : "slots.others", { name: now.student }) : t("slots.soon", { name: next?.student ?? "" });
  const time = now ? t("slots.left", { left: formatDuration(t, now.left_s) }) : t("slots.in", { time: formatDuration(t, next?.in_s ?? 0) });
  const then = !now ? "" : others ? t("slots.free", { time: formatDuration(t, others.free_in_s) }) : next ? t("slots.then", { name: next.student }) : "";
  const ends = (now?.left_s ?? next?.in_s ?? 0) <= ENDS_S;
  return html`
    <section id="slot" class="banner" data-tone=${others || ends ? "warn" : "good"}>
      <p><strong role="status">${title}</strong> <span id="slot-time">${time} ${then}</span></p>
      ${others && page.says_name ? html`<button id="slot-me" type="button" @click=${() => act.setStudent(others.student)}>${t("slots.me", { name: others.student })}</button>` : nothing}
    </section>`;
}

/** @param {Context} context */
function message({ page, t, act }) {
  if (!page.message) return nothing;
  return html`
    <section id="message" class="banner" data-tone="warn" role="alert">
      <p>${page.message}</p>
      <button id="message-close" type="button" aria-label=${t("close.message")} @click=${() => act.send({ type: "message_closed" })}>${t("close")}</button>
    </section>`;
}

/** @param {Context} context */
function stopped({ page, t, act }) {
  const stop = page.station?.stop;
  if (!stop) return nothing;
  const why = stop.reason ? `: ${stop.reason}` : "";
  const rest = t(!stop.delivered ? "stopped.not_delivered" : stop.at_rest ? "stopped.at_rest" : "stopped.moving");
  return html`
    <section id="stopped" class="banner" data-tone="bad" role="alert">
      <p><strong>${t("stopped.title")}</strong> <span id="stopped-by">${t(stop.of_fleet ? "stopped.by_fleet" : "stopped.by", { by: stop.by, why, rest })}</span></p>
      <button id="reset" type="button" ?disabled=${!stop.at_rest} @click=${() => act.question({ about: "reset_stop" })}>${t("stopped.reset")}</button>
    </section>`;
}

/** @param {Context} context */
function untrusted({ page, t, act }) {
  if (!page.station?.arm || page.station.trust.trusted) return nothing;
  return html`
    <section id="untrusted" class="banner" data-tone="warn" role="status">
      <p><strong>${t("pose.not_confirmed")}</strong> <span id="untrusted-why">${page.station.trust.reason ? `${sentence(page.station.trust.reason)}.` : ""}</span></p>
      <button id="confirm-pose" type="button" @click=${() => act.question({ about: "confirm_pose" })}>${t("pose.confirm")}</button>
    </section>`;
}

/** The stage shows a recording instead of the live arm. @param {Context} context */
function recording({ page, t, act }) {
  if (!recorded(page.recordings)) return nothing;
  return html`
    <section id="recorded" class="banner" data-tone="warn" role="status">
      <p><strong>${t("recorded.title")}</strong> ${t("recorded.text")}</p>
      <button id="recorded-end" type="button" class="strong" @click=${() => act.send({ type: "recording_chosen", name: null })}>${t("recorded.end")}</button>
    </section>`;
}

/** @param {Context} context */
function problem(context) {
  const { page, t, act } = context;
  if (!page.problem) return nothing;
  return html`
    <section id="problem" class="banner" data-tone="bad" role="alert">
      <p id="problem-text">${problemLine(context, page.problem)}</p>
      <button id="problem-close" type="button" aria-label=${t("close.message")} @click=${() => act.send({ type: "problem_closed" })}>${t("close")}</button>
    </section>`;
}

/** @param {Context} context */
const token = ({ page, t, act, connect }) => (page.connection === "token" ? tokenForm(t, t(page.is_token_unknown ? "token.unknown" : "token.required"), (secret) => act.useToken(secret, connect)) : nothing);

/** The open question. @param {Context} context */
export const question = ({ page, t, act }) => (page.question ? confirmation(t, page.question, act.answer) : nothing);
