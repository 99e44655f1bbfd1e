// Time slots of one arm or of several: the form to give them, and the lists of who is at which arm when.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { span } from "../i18n/i18n.js";
import { isMeant, isThere, recipients } from "./members.js";
import { deal, namesOf } from "./slots.js";
import { toText } from "./outcome_text.js";

/** @typedef {import("./fleet.js").Context} Context */
/** @typedef {import("./members.js").Member} Member */
/** @typedef {import("../state/slots.js").TimeSlot} TimeSlot */

const MINUTES = 15;
/** A slot ends within a day. */
const MOST_MINUTES = 1440;

/** Those of the group that is shown, or of all, beside the tiles. @param {Context} context */
export function slotsAside(context) {
  const { board, say, act } = context;
  if (!board.slots.open) return nothing;
  const to = recipients(board.group);
  const members = board.members.filter((it) => isThere(it) && isMeant(to, it));
  return html`
    <div class="details-head">
      <h2 id="slots-title">${say("fleet.slots.of", { to: toText(say, to, board.language) })}</h2>
      <button id="slots-close" type="button" class="small" @click=${() => act.send({ type: "slots_open", open: false })}>${say("close")}</button>
    </div>
    ${form(context, "group", to, members)}
    ${members.map((it) => html`<h3 id="slots-of-${it.id}">${it.name}</h3>${list(context, it)}`)}`;
}

/** Those of one arm, among its details. @param {Context} context @param {Member} member */
export function slotsOfArm(context, member) {
  return html`
    <h3 id="slots-of-${member.id}">${context.say("fleet.slots")}</h3>
    ${list(context, member)}
    ${form(context, "arm", { members: [member.name] }, [member])}`;
}

/** @param {Context} context @param {string} id @param {import("./state.js").Recipients} to @param {readonly Member[]} members */
function form({ board, say, act }, id, to, members) {
  const give = async (/** @type {SubmitEvent} */ event) => {
    event.preventDefault();
    const { elements } = /** @type {HTMLFormElement} */ (event.currentTarget);
    const names = /** @type {HTMLTextAreaElement} */ (elements.namedItem("names"));
    const minutes = /** @type {HTMLInputElement} */ (elements.namedItem("minutes"));
    const shares = deal(namesOf(names.value), minutes.valueAsNumber, members, board.group);
    if (!shares.length) return;
    const answers = await act.setSlots(to, shares);
    if (answers.length && answers.every(({ answer }) => answer.status < 300)) names.value = "";
  };
  return html`
    <form id="slots-${id}" class="slot-form" @submit=${give}>
      <label>${say("fleet.slots.names")} <textarea name="names" rows="4" required autocomplete="off" spellcheck="false" placeholder=${say("fleet.slots.example")}></textarea></label>
      <p class="row">
        <label>${say("fleet.slots.minutes")} <input name="minutes" type="number" min="1" max=${MOST_MINUTES} step="1" value=${MINUTES} required></label>
        <button type="submit" class="small strong" ?disabled=${!members.length}>${say("fleet.slots.set")}</button>
        ${members.some(({ state }) => state?.slots) ? html`<button type="button" class="small" data-act="clear" @click=${() => act.clearSlots(to)}>${say("fleet.slots.clear")}</button>` : nothing}
      </p>
      <p class="quiet">${say(members.length > 1 ? "fleet.slots.hint.turn" : "fleet.slots.hint")}</p>
    </form>`;
}

/** @param {Context} context @param {Member} member */
function list({ board, say }, { id }) {
  const slots = board.slots.lists[id];
  if (!slots) return html`<p class="quiet">${say("fleet.slots.reading")}</p>`;
  if (!slots.length) return html`<p class="quiet">${say("fleet.slots.none")}</p>`;
  return html`<ol class="slots" aria-labelledby="slots-of-${id}">${slots.map((it) => html`<li data-now=${String(it.starts_in_s === 0)}><span class="title">${it.student}</span> <span class="quiet">${when(say, it)}</span></li>`)}</ol>`;
}

/** @param {Context["say"]} say @param {TimeSlot} slot */
function when(say, { starts_in_s, ends_in_s }) {
  const lasts = span(say, ends_in_s - starts_in_s);
  return starts_in_s === 0 ? say("fleet.slots.left", { left: lasts }) : say("fleet.slots.in", { time: span(say, starts_in_s), lasts });
}
