// The calibration procedure: current calibration, points to record, result and review.

import { html, nothing, svg } from "../../vendor/lit-html/lit-html.js";
import { live } from "../../vendor/lit-html/directives/live.js";
import { HIGHEST_BLOCK_MM, LEAST_TOUCHES, nextPoint, numbersOf, pointBlockedReason, touchBlockedReason, touchesOf } from "../../state/calibrate.js";
import { blockedReason } from "../../state/selectors.js";
import { problemText } from "../../i18n/problem_text.js";
import { CROSSES } from "../../vision/drawn_crosses.js";
import { refusal } from "./arm.js";

/** @typedef {import("../../views/context.js").Context} Context */
/** @typedef {import("../../state/types.js").Problem} Problem */
/** @typedef {import("../../state/types.js").Schemas} Schemas */

/** The sheet (A4 landscape), and the distance of its near edge from the base axis. */
const SHEET = { wide_mm: 297, high_mm: 210, near_mm: 95 };
const TONES = { good: "good", unchecked: "warn", unmeasured: "warn", doubtful: "bad" };
/** The values shown before the review. */
const MAIN = new Set(["base", "rear", "fore", "out", "left"]);

/** To two decimals, without a sign at nothing. @param {number} value */
const number = (value) => value.toFixed(2).replace(/^-0\.00$/, "0.00").replace("-", "−");
/** @param {number} value */
const change = (value) => (number(value).startsWith("−") ? number(value) : `+${number(value)}`);

/** Whether the arm has no calibration except for the paper. @param {Schemas["CalibrationFile"]} calibration */
const isAsDrawn = (calibration) => numbersOf(calibration).filter(({ name }) => MAIN.has(name)).every(({ value }) => value === 0);

/** Position on the sheet from its upper left corner; forward is up. @param {readonly number[]} place */
const onSheet = ([x_mm = 0, y_mm = 0]) => [SHEET.wide_mm / 2 - y_mm, SHEET.high_mm + SHEET.near_mm - x_mm];

/** Moves the focus to an element of the next frame, because the focused one disappears. @param {string} id */
const focusOn = (id) => requestAnimationFrame(() => document.getElementById(id)?.focus());

/** @param {Context["t"]} t @param {Problem | null} problem */
const problemOf = (t, problem) => (problem ? html`<p class="status" data-tone="bad" role="alert">${problemText(t, problem)}</p>` : nothing);

/** @param {Context} context */
export function calibrateGuide(context) {
  const { page, t } = context;
  const { known, sheet, print } = page.calibrate;
  if (!known) return nothing;
  const part = !sheet ? choices : print === null ? printing : touching;
  return html`
    <section id="calibrate" class="card" aria-labelledby="calibrate-title">
      <h2 id="calibrate-title">${t("calibrate")}</h2>
      ${whatIsKnown(context, known)}
      ${part(context)}
      ${refusal(context, "calibrate")}
    </section>`;
}

/** @param {Context} context @param {ReturnType<typeof numbersOf>} rows */
const numbers = ({ t }, rows) => html`
  <dl class="list">${rows.map(({ name, unit, value, by }) => html`<div><dt>${t(`calibrate.number.${name}`)}</dt><dd data-number=${name}>${number(value)}${unit}${by === null ? "" : ` (${change(by)})`}</dd></div>`)}</dl>`;

/** @param {Context} context @param {Schemas["Calibrations"]} known */
function whatIsKnown(context, { calibration }) {
  const { page, t } = context;
  if (!calibration || isAsDrawn(calibration)) return html`<p id="calibrate-known">${t("calibrate.nominal")}</p>`;
  const { touched } = calibration;
  return html`
    <div id="calibrate-known">
      <p>${t("calibrate.known")}${calibration.name ? ` ${t("calibrate.name", { name: calibration.name })}` : ""}</p>
      ${numbers(context, numbersOf(calibration).filter(({ name }) => MAIN.has(name)))}
      ${touched ? html`<p class="quiet">${t("calibrate.agreed", { points: touched.points, typical: number(touched.typical_mm), largest: number(touched.largest_mm) })}</p>` : nothing}
      ${page.station?.calibrated?.angles_set ? html`<p class="quiet">${t("calibrate.angles_sent")}</p>` : nothing}
    </div>`;
}

/** @param {Context} context */
function choices({ page, t, act }) {
  const { known } = page.calibrate;
  const mayKeep = page.role === "admin";
  const begin = () => act.calibrate.begin().then(() => focusOn("calibrate-number"));
  const maySetAngles = known?.calibration && page.station?.calibrated?.angles_set === false;
  return html`
    <p class="quiet">${t(mayKeep ? "calibrate.hint" : "policy.admin")}</p>
    <div class="row">
      <button id="calibrate-begin" type="button" class="small strong" @click=${begin}>${t("calibrate.begin")}</button>
      <button id="calibrate-before" type="button" class="small" ?disabled=${!known?.before || !mayKeep} @click=${() => act.calibrate.bringBack()}>${t("calibrate.restore")}</button>
      <button id="calibrate-forget" type="button" class="small" ?disabled=${!known?.calibration || !mayKeep} @click=${() => act.question({ about: "clear_calibration" })}>${t("calibrate.clear")}</button>
      ${maySetAngles ? html`<button id="calibrate-angles" type="button" class="small" ?disabled=${blockedReason(page) !== null} @click=${() => act.question({ about: "send_angles" })}>${t("calibrate.angles")}</button>` : nothing}
    </div>`;
}

/** @param {Context} context */
function leave({ t, act }) {
  const end = () => {
    act.send({ type: "calibrate_ended" });
    focusOn("calibrate-begin");
  };
  return html`<button id="calibrate-leave" type="button" class="small end" @click=${end}>${t("calibrate.leave")}</button>`;
}

/** The first step: a sheet, and whether the printer has scaled it. @param {Context} context */
function printing(context) {
  const { page, t, act } = context;
  const { number, bar, bar_refused } = page.calibrate;
  const take = (/** @type {SubmitEvent} */ event) => {
    event.preventDefault();
    void act.calibrate.takeBar().then(() => focusOn("calibrate-touch"));
  };
  return html`
    <h3>${t("calibrate.print")}</h3>
    <p class="quiet">${t("calibrate.print.hint")}</p>
    <div class="row"><button id="calibrate-sheet" type="button" class="small" @click=${() => act.calibrate.saveSheet()}>${t("calibrate.sheet")}</button></div>
    <form class="row" @submit=${take}>
      <label for="calibrate-number">${t("calibrate.sheet.number")}</label>
      <input id="calibrate-number" class="length" type="number" required .value=${live(number)} @input=${(/** @type {Event} */ event) => act.send({ type: "calibrate_number_typed", text: /** @type {HTMLInputElement} */ (event.target).value })}>
      <label for="calibrate-bar">${t("calibrate.bar")}</label>
      <input id="calibrate-bar" class="length" type="number" step="any" required .value=${live(bar)} @input=${(/** @type {Event} */ event) => act.send({ type: "calibrate_bar_typed", text: /** @type {HTMLInputElement} */ (event.target).value })}> mm
      <button id="calibrate-next" type="submit" class="small strong">${t("calibrate.next")}</button>
      ${leave(context)}
    </form>
    ${problemOf(t, bar_refused)}`;
}

/** The sheet as it lies before the arm, with the point that is next. @param {Context} context */
function picture({ page, t }) {
  const { sheet, visits } = page.calibrate;
  const next = nextPoint(page.calibrate);
  const touched = new Set(touchesOf(page.calibrate).map(({ point }) => point));
  const mark = (/** @type {readonly number[]} */ place, /** @type {number} */ point) => {
    const [right, down] = onSheet(place);
    return svg`<g class=${point === next ? "is-next" : touched.has(point) ? "is-touched" : ""}><circle cx=${right} cy=${down} r="11"/><text x=${right} y=${down} dy="5">${point + 1}</text></g>`;
  };
  return svg`
    <svg class="sheet-points" viewBox="0 0 297 230" role="img" aria-label=${t("calibrate.picture", { point: next + 1, touched: touched.size, visits: visits.length })}>
      <rect x="1" y="1" width="295" height="208" rx="2"/>
      <path d="M148.5 180 V 226 M 141 218 L 148.5 227 L 156 218"/>
      ${(sheet?.points_mm ?? []).map(mark)}
    </svg>`;
}

/** Whether each point of the sheet is recorded. @param {import("../../state/calibrate.js").Calibrate} calibrate */
const isWhole = (calibrate) => new Set(touchesOf(calibrate).map(({ point }) => point)).size === calibrate.sheet?.points_mm.length;

/** The second step: one point after the other. @param {Context} context */
function touching(context) {
  const { page, t, act } = context;
  const { sheet, visits, fit, shown, problem, lost, block } = page.calibrate;
  const point = nextPoint(page.calibrate);
  const [x, y] = sheet?.points_mm[point] ?? [];
  const why = pointBlockedReason(page);
  return html`
    <h3 id="calibrate-point" aria-live="polite">${t(isWhole(page.calibrate) ? "calibrate.all" : "calibrate.point", { point: point + 1, x: x ?? 0, y: y ?? 0 })}</h3>
    ${picture(context)}
    <p class="quiet">${t("calibrate.point.hint")}</p>
    <div class="row">
      <button id="calibrate-touch" type="button" class="small strong" ?disabled=${why !== null} aria-describedby="calibrate-why" @click=${() => act.calibrate.touch()}>${t("calibrate.touch")}</button>
      <button id="calibrate-skip" type="button" class="small" @click=${() => act.send({ type: "calibrate_visited", raw_deg: null })}>${t("calibrate.skip")}</button>
      <button id="calibrate-back" type="button" class="small" ?disabled=${visits.length === 0} @click=${() => act.send({ type: "calibrate_back" })}>${t("calibrate.undo")}</button>
      ${leave(context)}
    </div>
    <div class="row">
      <label for="calibrate-block">${t("calibrate.block")}</label>
      <input id="calibrate-block" class="length" type="number" min="0" max=${HIGHEST_BLOCK_MM} step="any" placeholder="0" aria-describedby="calibrate-why" .value=${live(block)} @input=${(/** @type {Event} */ event) => act.send({ type: "calibrate_block_typed", text: /** @type {HTMLInputElement} */ (event.target).value })}> mm
    </div>
    <p id="calibrate-why" class="quiet">${why ? t(`blocked.${why}`) : ""}</p>
    ${photo(context)}
    ${lost ? html`<p id="calibrate-lost" class="status" data-tone="warn" role="alert">${t("calibrate.lost", { lost })}</p>` : nothing}
    ${problemOf(t, problem)}
    ${touches(context)}
    ${fit ? result(context, fit) : nothing}
    ${shown ? review(context, shown) : nothing}`;
}

/** Another way: crosses drawn by the arm, and a photo of them. @param {Context} context */
function photo({ page, t, act }) {
  const { drawn, state, found } = page.calibrate.photo;
  const why = blockedReason(page) ?? touchBlockedReason(page);
  const take = (/** @type {FileList | null | undefined} */ files) => files?.[0] && void act.photo.take(files[0]);
  const isDrawn = drawn.length === CROSSES.length;
  return html`
    <details class="made" id="calibrate-photo" @dragover=${(/** @type {DragEvent} */ event) => event.preventDefault()}
      @drop=${(/** @type {DragEvent} */ event) => (event.preventDefault(), event.stopPropagation(), take(event.dataTransfer?.files))}>
      <summary>${t("photo")}</summary>
      <p class="quiet">${t("photo.hint")}</p>
      <div class="row">
        <button id="photo-draw" type="button" class="small strong" ?disabled=${why !== null || state === "draws"} @click=${() => act.photo.draw()}>${t("photo.draw")}</button>
        <label for="photo-file">${t("photo.take")}</label>
        <input id="photo-file" type="file" accept="image/*" capture="environment" ?disabled=${!isDrawn || state === "looks"} @change=${(/** @type {Event} */ event) => take(/** @type {HTMLInputElement} */ (event.target).files)}>
      </div>
      <p id="photo-status" class="status" role="status" data-tone=${["few_corners", "few_crosses", "unreadable", "interrupted"].includes(state) ? "warn" : "off"}>${state === "none" ? (why ? t(`blocked.${why}`) : "") : t(`photo.${state}`, { drawn: drawn.length, found })}</p>
    </details>`;
}

/** The recorded points and their errors. @param {Context} context */
function touches({ page, t }) {
  const { fit } = page.calibrate;
  const all = touchesOf(page.calibrate);
  const away = (/** @type {number} */ n) => (fit ? t("calibrate.away", { mm: number(fit.away_mm[n] ?? 0) }) : "–");
  const missing = LEAST_TOUCHES - all.length;
  return html`
    <dl id="calibrate-touches" class="list">${all.map(({ point, height_mm }, n) => html`<div><dt>${t(height_mm ? "calibrate.touched.block" : "calibrate.touched", { point: point + 1, height: height_mm })}</dt>
      <dd>${away(n)} ${fit?.wrong.includes(n) ? html`<b class="chip" data-tone="bad">${t("calibrate.left_out")}</b>` : nothing}</dd></div>`)}</dl>
    ${missing > 0 ? html`<p class="quiet">${t("calibrate.missing", { missing })}</p>` : nothing}`;
}

/** @param {Context} context @param {Schemas["FitReport"]} fit */
function result(context, fit) {
  const { page, t, act } = context;
  const { calibration, expected_mm, trust, unsure, advice, tool_mm } = fit;
  const isUnmeasured = trust === "unmeasured";
  const before = page.calibrate.known?.calibration ?? null;
  const best = advice && page.calibrate.sheet?.points_mm.findIndex((place) => String(place) === String(advice.place_mm));
  const show = () => {
    act.send({ type: "calibrate_shown" });
    focusOn("calibrate-keep");
  };
  return html`
    <div id="calibrate-result" role="status">
      <p><b id="calibrate-trust" class="chip" data-tone=${TONES[trust]}>${t(`calibrate.trust.${trust}`)}</b> ${t("calibrate.expected", { mm: number(expected_mm) })}</p>
      <p class="quiet">${t(`calibrate.trust.${trust}.text`, { out: tool_mm[0].toFixed(0), left: tool_mm[1].toFixed(0) })}</p>
      ${isUnmeasured ? html`<div class="row"><button id="calibrate-measured" type="button" class="small" @click=${() => act.send({ type: "calibrate_tool_measured" })}>${t("calibrate.measured")}</button></div>` : nothing}
      ${unsure.map(({ what, by, unit }) => html`<p class="quiet">${t("calibrate.uncertain", { what, by: number(by), unit })}</p>`)}
      ${typeof best === "number" && best >= 0 ? html`<p class="quiet">${t(advice?.height_mm ? "calibrate.advice.block" : "calibrate.advice", { point: best + 1, height: advice?.height_mm ?? 0 })}</p>` : nothing}
    </div>
    ${numbers(context, numbersOf(calibration, before).filter(({ name }) => MAIN.has(name)))}
    ${before ? html`<p class="quiet">${t("calibrate.since")}</p>` : nothing}
    <div class="row"><button id="calibrate-show" type="button" class="small" ?disabled=${isUnmeasured} @click=${show}>${t("calibrate.review")}</button></div>`;
}

/** The last step: all that is kept. @param {Context} context @param {Schemas["CalibrationFile"]} shown */
function review(context, shown) {
  const { page, t, act } = context;
  const keep = () => act.calibrate.keep().then(() => focusOn("calibrate-begin"));
  const mayKeep = page.role === "admin";
  return html`
    <section id="calibrate-shown" class="made" aria-labelledby="calibrate-shown-title">
      <h3 id="calibrate-shown-title">${t("calibrate.new")}</h3>
      ${numbers(context, numbersOf(shown))}
      <p class="quiet">${t(mayKeep ? "calibrate.new.hint" : "policy.admin")}</p>
      <div class="row"><button id="calibrate-keep" type="button" class="strong" ?disabled=${!mayKeep} @click=${keep}>${t("calibrate.save")}</button></div>
    </section>`;
}
