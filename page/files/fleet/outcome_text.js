// The outcome of a request to several stations, as text.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { problemText } from "../i18n/problem_text.js";
import { pageIn, pageOf } from "./members.js";
import { list, outcomeOf, problemOf } from "./outcome.js";

/** @typedef {import("./fleet.js").Context} Context */
/** @typedef {import("./state.js").FleetRequest} FleetRequest */
/** @typedef {import("../i18n/i18n.js").TextKey} TextKey */

/** Whom it was for. @param {Context["t"]} t @param {import("./state.js").Recipients} to @param {string} language */
export function toText(t, to, language) {
  if (to === "all") return t("fleet.to.all");
  return "group" in to ? to.group : list(language, to.members);
}

/** @param {Context} context @param {FleetRequest} request @returns {"good" | "warn" | "bad"} */
export function outcomeTone(context, { answers, problem }) {
  if (problem) return "bad";
  if (!answers) return "warn";
  const { silent, refused } = outcomeOf(answers);
  return silent.length + refused.length ? "bad" : "good";
}

/** @param {Context} context @param {FleetRequest} request */
export function outcomeText(context, request) {
  const { board: { language }, t } = context;
  const { what, to, answers, problem } = request;
  if (problem) return html`<strong>${t(`fleet.failed.${what}`)}</strong> ${problemText(t, problem)} ${what === "stop" ? pages(context, context.board.members.map(({ name }) => name)) : nothing}`;
  if (!answers) return html`${t(`fleet.pending.${what}`, { to: toText(t, to, language) })}`;
  const { done, silent, refused } = outcomeOf(answers);
  const all = answers.length;
  return html`
    ${what === "give_arm" ? given(context, answers) : html`<strong>${t(`fleet.done.${what}`, { done: done.length, all })}</strong>`}
    ${silent.length ? html`<span class="silent">${t(what === "stop" ? "fleet.silent.stop" : "fleet.silent", { names: list(language, silent) })} ${what === "stop" ? pages(context, silent) : nothing}</span>` : nothing}
    ${refused.map((refusal) => html`<span class="refused">${list(language, refusal.members)}: ${problemText(t, refusal.problem)}</span>`)}`;
}

/** The new virtual arm, with a link to its page. @param {Context} context @param {readonly import("./state.js").MemberAnswer[]} answers */
function given({ t }, answers) {
  const arms = answers.filter(({ answer }) => !problemOf(answer)).map(({ answer }) => /** @type {import("../state/types.js").Schemas["GivenArm"]} */ (answer.body));
  if (!arms.length) return html`<strong>${t("fleet.failed.give_arm")}</strong>`;
  return arms.map(({ name, page }) => html`<strong>${t("fleet.arm.ready", { name })}</strong> <a id="arm-page" href=${pageIn(page) ?? ""} target="_blank" rel="noreferrer">${t("fleet.page.of", { name })}</a>`);
}

/** Links to the pages of these stations, if known. @param {Context} context @param {readonly string[]} names */
function pages({ board, t }, names) {
  const known = board.members.filter((member) => names.includes(member.name) && !member.here && pageOf(member));
  if (!known.length) return nothing;
  return html`<span class="pages">${known.map((member) => html`<a href=${pageOf(member)} target="_blank" rel="noreferrer">${t("fleet.page.of", { name: member.name })}</a> `)}</span>`;
}
