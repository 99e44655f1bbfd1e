// The foot of the board: STOP for all, and what came of it.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { stops } from "../input/stop_button.js";
import { isMeant, isThere, recipients } from "./members.js";
import { list } from "./outcome.js";
import { told, toneOfTold } from "./outcome_text.js";

/** @typedef {import("./fleet.js").Context} Context */
/** @typedef {import("./members.js").Member} Member */

/** @param {Context} context */
export function foot(context) {
  const { board, say, act } = context;
  const { group, stop } = board;
  const all = stops(() => void act.stop("all")), shown = stops(() => void act.stop(recipients(group)));
  return html`
    <button id="stop" type="button" aria-describedby="stop-keys" @pointerdown=${all} @click=${all}>${say("fleet.stop.all")} <small id="stop-keys">${say("stop.keys")}</small></button>
    ${group === null ? nothing : html`<button id="stop-group" class="stops" type="button" @pointerdown=${shown} @click=${shown}>${say("fleet.stop.group", { group })}</button>`}
    <div id="stop-told" data-tone=${stop ? toneOfTold(context, stop) : "off"} role="alert">${stop ? html`<p>${told(context, stop)}</p>` : nothing}</div>
    ${again(context)}`;
}

/** Those that may move again once somebody has looked at them. @param {readonly Member[]} members @param {import("./state.js").Recipients} to */
export const stopped = (members, to) => members.filter((it) => isThere(it) && isMeant(to, it) && it.state?.stop);

/** @param {Context} context */
function again({ board, say, act }) {
  const held = stopped(board.members, recipients(board.group));
  if (!held.length) return nothing;
  return html`<button id="reset" type="button" class="small" @click=${() => act.send({ type: "question", question: resetQuestion(board.language, held) })}>${say("fleet.reset", { number: held.length })}</button>`;
}

/** @param {string} language @param {readonly Member[]} members @returns {import("./state.js").Question} */
export function resetQuestion(language, members) {
  const names = members.map(({ name }) => name);
  return { about: "fleet_reset", to: { members: names }, values: { names: list(language, names) } };
}
