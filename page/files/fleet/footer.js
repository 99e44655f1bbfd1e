// The footer of the board: STOP ALL, and its outcome.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { stops } from "../input/stop_button.js";
import { isMeant, isThere, recipients } from "./members.js";
import { list } from "./outcome.js";
import { outcomeText, outcomeTone } from "./outcome_text.js";

/** @typedef {import("./fleet.js").Context} Context */
/** @typedef {import("./members.js").Member} Member */

/** @param {Context} context */
export function footer(context) {
  const { board, t, act } = context;
  const { group, stop } = board;
  const all = stops(() => void act.stop("all")), shown = stops(() => void act.stop(recipients(group)));
  return html`
    <button id="stop" type="button" aria-describedby="stop-keys" @pointerdown=${all} @click=${all}>${t("fleet.stop.all")} <small id="stop-keys">${t("stop.keys")}</small></button>
    ${group === null ? nothing : html`<button id="stop-group" class="stops" type="button" @pointerdown=${shown} @click=${shown}>${t("fleet.stop.group", { group })}</button>`}
    <div id="stop-status" data-tone=${stop ? outcomeTone(context, stop) : "off"} role="alert">${stop ? html`<p>${outcomeText(context, stop)}</p>` : nothing}</div>
    ${again(context)}`;
}

/** The stopped members among the recipients. @param {readonly Member[]} members @param {import("./state.js").Recipients} to */
export const stopped = (members, to) => members.filter((member) => isThere(member) && isMeant(to, member) && member.state?.stop);

/** @param {Context} context */
function again({ board, t, act }) {
  const held = stopped(board.members, recipients(board.group));
  if (!held.length) return nothing;
  return html`<button id="reset" type="button" class="small" @click=${() => act.send({ type: "question", question: resetQuestion(board.language, held) })}>${t("fleet.reset", { number: held.length })}</button>`;
}

/** @param {string} language @param {readonly Member[]} members @returns {import("./state.js").Question} */
export function resetQuestion(language, members) {
  const names = members.map(({ name }) => name);
  return { about: "fleet_reset", to: { members: names }, values: { names: list(language, names) } };
}
