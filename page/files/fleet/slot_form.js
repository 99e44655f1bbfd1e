// Time slots of one or several arms: the form, and the schedule.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { formatDuration } from "../i18n/i18n.js";
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
  const { board, t, act } = context;
  if (!board.slots.open) return nothing;
  const to = recipients(board.group);
  const members = board.members.filter((member) => isThere(member) && isMeant(to, member));
  return html`
    <div class="details-head">
      <h2 id="slots-title">${t("fleet.slots.of", { to: toText(t, to, board.language) })}</h2>
      <button id="slots-close" type="button" class="small" @click=${() => act.send({ type: "slots_open", open: false })}>${t("close")}</button>
    </div>
    ${form(context, "group", to, members)}
    ${members.map((member) => html`<h3 id="slots-of-${member.id}">${member.name}</h3>${list(context, member)}`)}`;
}

/** Those of one arm, among its details. @param {Context} context @param {Member} member */
export function slotsOfArm(context, member) {
  return html`
    <h3 id="slots-of-${member.id}">${context.t("fleet.slots")}</h3>
    ${list(context, member)}
    ${form(context, "arm", { members: [member.name] }, [member])}`;
}

/** @param {Context} context @param {string} id @param {import("./state.js").Recipients} to @param {readonly Member[]} members */
function form({ board, t, act }, id, to, members) {
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
      <label>${t("fleet.slots.names")} <textarea name="names" rows="4" required autocomplete="off" spellcheck="false" placeholder=${t("fleet.slots.example")}></textarea></label>
      <p class="row">
        <label>${t("fleet.slots.minutes")} <input name="minutes" type="number" min="1" max=${MOST_MINUTES} step="1" value=${MINUTES} required></label>
        <button type="submit" class="small strong" ?disabled=${!members.length}>${t("fleet.slots.set")}</button>
        ${members.some(({ state }) => state?.slots) ? html`<button type="button" class="small" data-act="clear" @click=${() => act.clearSlots(to)}>${t("fleet.slots.clear")}</button>` : nothing}
      </p>
      <p class="quiet">${t(members.length > 1 ? "fleet.slots.hint.turn" : "fleet.slots.hint")}</p>
    </form>`;
}

/** @param {Context} context @param {Member} member */
function list({ board, t }, { id }) {
  const slots = board.slots.lists[id];
  if (!slots) return html`<p class="quiet">${t("fleet.slots.reading")}</p>`;
  if (!slots.length) return html`<p class="quiet">${t("fleet.slots.none")}</p>`;
  return html`<ol class="slots" aria-labelledby="slots-of-${id}">${slots.map((slot) => html`<li data-now=${String(slot.starts_in_s === 0)}><span class="title">${slot.student}</span> <span class="quiet">${when(t, slot)}</span></li>`)}</ol>`;
}

/** @param {Context["t"]} t @param {TimeSlot} slot */
function when(t, { starts_in_s, ends_in_s }) {
  const lasts = formatDuration(t, ends_in_s - starts_in_s);
  return starts_in_s === 0 ? t("fleet.slots.left", { left: lasts }) : t("fleet.slots.in", { time: formatDuration(t, starts_in_s), lasts });
}
