// The form that submits a drawing to the shared queue.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { live } from "../vendor/lit-html/directives/live.js";
import { accepted } from "../state/draw.js";
import { arms, canSubmit, isWrongHeight, offers } from "./queue.js";
import { groups } from "./members.js";
import { list } from "./outcome.js";
import { problemText } from "../i18n/problem_text.js";

/** @typedef {import("./fleet.js").Context} Context */
/** @typedef {import("./queue.js").Form} Form */

const value = (/** @type {Event} */ event) => /** @type {HTMLInputElement} */ (event.target).value;
const checked = (/** @type {Event} */ event) => /** @type {HTMLInputElement} */ (event.target).checked;

/** @param {Context} context */
export function submission(context) {
  const { board: { queue }, t, act } = context;
  const { form, submitting, submitted, refused } = queue;
  const send = (/** @type {SubmitEvent} */ event) => {
    event.preventDefault();
    if (canSubmit(form) && !submitting) void act.queue.submit();
  };
  return html`
    <form id="submit" aria-labelledby="submit-title" @submit=${send}>
      <h3 id="submit-title">${t("fleet.submit")}</h3>
      ${subject(context)}
      <div class="fields">${whose(context)}</div>
      ${needs(context)}
      <div class="fields">
        <label><span>${t("draw.down")} <small>mm</small></span><input id="submit-down" type="text" inputmode="decimal" autocomplete="off" placeholder=${t("fleet.submit.down")} aria-invalid=${String(isWrongHeight(form))} .value=${live(form.down)} @input=${(/** @type {Event} */ event) => set(context, { down: value(event) })}></label>
        <label class="check"><input id="submit-fit" type="checkbox" .checked=${live(form.fit)} @change=${(/** @type {Event} */ event) => set(context, { fit: checked(event) })}> <span>${t("draw.fit")}</span></label>
      </div>
      <div class="row"><button id="submit-send" type="submit" class="small strong" ?disabled=${!canSubmit(form) || submitting}>${t("fleet.submit.send")}</button>
        ${submitted === null ? nothing : html`<span id="submitted" role="status">${t("fleet.submit.done", { title: submitted })}</span>`}</div>
      ${refused?.work === null ? html`<p class="status-of" data-tone="bad" role="alert">${problemText(t, refused.problem)}</p>` : nothing}
    </form>`;
}

/** @param {Context} context @param {Partial<Form>} form */
const set = ({ act }, form) => act.send({ type: "queue_form", form });

/** @param {Context} context */
function subject(context) {
  const { board: { queue: { form, formats } }, t } = context;
  const chosen = (/** @type {Event} */ event) => {
    const input = /** @type {HTMLInputElement} */ (event.target);
    if (input.files?.[0]) set(context, { file: input.files[0] });
    // Choosing the same file again is a change too: its content may be new.
    input.value = "";
  };
  return html`
    <fieldset class="segments">
      <legend>${t("draw.what")}</legend>
      ${/** @type {const} */ (["file", "text"]).map((source) => html`<label><input type="radio" name="submit-what" value=${source} .checked=${live(source === form.what)} @change=${() => set(context, { what: source })}><span>${t(`draw.${source}`)}</span></label>`)}
    </fieldset>
    ${form.what === "text" ? html`<textarea id="submit-text" rows="2" aria-label=${t("draw.text")} .value=${live(form.text)} @input=${(/** @type {Event} */ event) => set(context, { text: value(event) })}></textarea>` : html`
      <div class="drop">
        <p>${form.file ? html`<strong id="submit-name">${form.file.name}</strong>` : t("fleet.submit.drop")}</p>
        <input id="submit-file" type="file" accept=${accepted(formats)} aria-label=${t("draw.choose")} @change=${chosen}>
        <label for="submit-file" class="button">${t(form.file ? "draw.another" : "draw.choose")}</label>
      </div>`}`;
}

/** @param {Context} context */
function whose(context) {
  const { board, t } = context;
  const { form } = board.queue;
  return html`
    <label><span>${t("fleet.submit.student")}</span><input id="submit-student" type="text" maxlength="60" required autocomplete="off" .value=${live(form.student)} @input=${(/** @type {Event} */ event) => set(context, { student: value(event) })}></label>
    <label><span>${t("fleet.group")}</span><input id="submit-group" type="text" maxlength="40" list="submit-groups" autocomplete="off" placeholder="room-2" .value=${live(form.group)} @input=${(/** @type {Event} */ event) => set(context, { group: value(event) })}></label>
    <datalist id="submit-groups">${groups(board.members).map((group) => html`<option value=${group}></option>`)}</datalist>`;
}

/** The required equipment, and the suitable arms. @param {Context} context */
function needs(context) {
  const { board, t } = context;
  const { needs } = board.queue.form;
  const found = arms(board.members, needs).map(({ name }) => name);
  const toggled = (/** @type {string} */ word, /** @type {boolean} */ on) => set(context, { needs: on ? [...needs, word] : needs.filter((need) => need !== word) });
  const all = offers(board.members, needs);
  return html`
    ${all.length ? html`
      <fieldset id="submit-needs" class="needs">
        <legend>${t("fleet.submit.needs")}</legend>
        ${all.map((word) => html`<label class="check"><input type="checkbox" value=${word} .checked=${live(needs.includes(word))} @change=${(/** @type {Event} */ event) => toggled(word, checked(event))}> ${word}</label>`)}
      </fieldset>` : nothing}
    <p id="submit-arms" class="quiet">${found.length ? t("fleet.submit.arms", { names: list(board.language, found) }) : t("fleet.submit.no_arm")}</p>`;
}
