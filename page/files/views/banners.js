// What a person has to know before anything else, above the stage.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { recorded } from "../state/recordings.js";
import { isVeryOld, othersTime, silence_ms } from "../state/selectors.js";
import { isSamePerson, timeNext, timeNow } from "../state/slots.js";
import { span } from "../i18n/i18n.js";
import { sure } from "./confirm.js";
import { tokenForm } from "./token.js";

/** @typedef {import("./context.js").Context} Context */

/** From when on it is told whose time comes next, and that a time is nearly over. */
const SOON_S = 300, ENDS_S = 60;

/** @param {string} text */
export const sentence = (text) => text.charAt(0).toUpperCase() + text.slice(1);

/** @param {Context} context */
export const banners = (context) => html`${locked(context)}${slot(context)}${stopped(context)}${untrusted(context)}${recording(context)}${token(context)}`;

/** What comes and goes by itself lies over the page: nothing moves under a pointer. @param {Context} context */
export const toasts = (context) => html`${old(context)}${message(context)}${problem(context)}`;

/** @param {Context} context */
function old({ page, say }) {
  if (!isVeryOld(page)) return nothing;
  const why = say(page.connection === "open" ? "old.silent" : "old.connecting");
  return html`<p id="old" class="banner" data-tone="warn" role="status">${say("old", { age: span(say, silence_ms(page) / 1000), why })}</p>`;
}

/** Somebody has the eyes of all. @param {Context} context */
function locked({ page, say }) {
  const lock = page.station?.lock;
  if (!lock) return nothing;
  return html`<p id="locked" class="banner" data-tone="warn" role="alert"><span><strong>${say("locked.title")}</strong> ${say("locked.by", { by: lock.by, why: lock.message ? `: ${lock.message}` : "" })}</span></p>`;
}

/** Whose time it is, so that nobody wonders what he may do. Only what changes seldom is read out. @param {Context} context */
function slot(context) {
  const { page, say, act } = context;
  const { station } = page, now = timeNow(station), next = timeNext(station), others = othersTime(page);
  const isNext = next && next.in_s < SOON_S;
  if (!now && !isNext) return nothing;
  const mine = now !== null && isSamePerson(now.student, page.person);
  const title = now ? say(mine ? "slots.mine" : "slots.others", { name: now.student }) : say("slots.soon", { name: next?.student ?? "" });
  const time = now ? say("slots.left", { left: span(say, now.left_s) }) : say("slots.in", { time: span(say, next?.in_s ?? 0) });
  const then = !now ? "" : others ? say("slots.free", { time: span(say, others.free_in_s) }) : next ? say("slots.then", { name: next.student }) : "";
  const ends = (now?.left_s ?? next?.in_s ?? 0) <= ENDS_S;
  return html`
    <section id="slot" class="banner" data-tone=${others || ends ? "warn" : "good"}>
      <p><strong role="status">${title}</strong> <span id="slot-time">${time} ${then}</span></p>
      ${others && page.says_name ? html`<button id="slot-me" type="button" @click=${() => act.beStudent(others.student)}>${say("slots.me", { name: others.student })}</button>` : nothing}
    </section>`;
}

/** @param {Context} context */
function message({ page, say, act }) {
  if (!page.message) return nothing;
  return html`
    <section id="message" class="banner" data-tone="warn" role="alert">
      <p>${page.message}</p>
      <button id="message-close" type="button" aria-label=${say("close.message")} @click=${() => act.send({ type: "message_closed" })}>${say("close")}</button>
    </section>`;
}

/** @param {Context} context */
function stopped({ page, say, act }) {
  const stop = page.station?.stop;
  if (!stop) return nothing;
  const why = stop.reason ? `: ${stop.reason}` : "";
  const rest = say(!stop.delivered ? "stopped.not_delivered" : stop.at_rest ? "stopped.at_rest" : "stopped.moving");
  return html`
    <section id="stopped" class="banner" data-tone="bad" role="alert">
      <p><strong>${say("stopped.title")}</strong> <span id="stopped-by">${say(stop.of_fleet ? "stopped.by_fleet" : "stopped.by", { by: stop.by, why, rest })}</span></p>
      <button id="reset" type="button" ?disabled=${!stop.at_rest} @click=${() => act.question({ about: "reset_stop" })}>${say("stopped.reset")}</button>
    </section>`;
}

/** @param {Context} context */
function untrusted({ page, say, act }) {
  if (!page.station?.arm || page.station.trust.trusted) return nothing;
  return html`
    <section id="untrusted" class="banner" data-tone="warn" role="status">
      <p><strong>${say("pose.not_confirmed")}</strong> <span id="untrusted-why">${page.station.trust.reason ? `${sentence(page.station.trust.reason)}.` : ""}</span></p>
      <button id="confirm-pose" type="button" @click=${() => act.question({ about: "confirm_pose" })}>${say("pose.confirm")}</button>
    </section>`;
}

/** The stage shows something else than the arm: that has to be known before all else that is seen on it. @param {Context} context */
function recording({ page, say, act }) {
  if (!recorded(page.recordings)) return nothing;
  return html`
    <section id="recorded" class="banner" data-tone="warn" role="status">
      <p><strong>${say("recorded.title")}</strong> ${say("recorded.text")}</p>
      <button id="recorded-end" type="button" class="strong" @click=${() => act.send({ type: "recording_chosen", name: null })}>${say("recorded.end")}</button>
    </section>`;
}

/** @param {Context} context */
function problem({ page, say, act }) {
  if (!page.problem) return nothing;
  const { title, detail, hint } = page.problem;
  return html`
    <section id="problem" class="banner" data-tone="bad" role="alert">
      <p><strong id="problem-title">${sentence(title)}:</strong>
        <span id="problem-detail">${sentence(detail)}.</span>
        <em id="problem-hint">${hint ? `${sentence(hint)}.` : ""}</em></p>
      <button id="problem-close" type="button" aria-label=${say("close.message")} @click=${() => act.send({ type: "problem_closed" })}>${say("close")}</button>
    </section>`;
}

/** @param {Context} context */
const token = ({ page, say, act, connect }) => (page.connection === "token" ? tokenForm(say, say("token.required"), (secret) => act.useToken(secret, connect)) : nothing);

/** What a person is asked before something is done. @param {Context} context */
export const question = ({ page, say, act }) => (page.question ? sure(say, page.question, act.answer) : nothing);
