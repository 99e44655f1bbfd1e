// Measures the paper surface from three or more points and saves it for all drawings.

import { html, nothing } from "../../vendor/lit-html/lit-html.js";
import { touchBlockedReason } from "../../state/calibrate.js";
import { bent_mm, PLACES, steep_deg } from "../../state/touch_paper.js";
import { problemText } from "../../i18n/problem_text.js";
import { refusal } from "./arm.js";

/** @typedef {import("../../views/context.js").Context} Context */

/** @param {number} value */
const number = (value) => value.toFixed(2).replace(/^-0\.00$/, "0.00").replace("-", "−");
/** Moves the focus to an element of the next frame, because the focused one disappears. @param {string} id */
const focusOn = (id) => requestAnimationFrame(() => document.getElementById(id)?.focus());

/** @param {Context} context */
export function touchPaper(context) {
  const { page, t } = context;
  const { known } = page.calibrate;
  if (!known) return nothing;
  const plane = known.calibration?.paper ?? null;
  return html`
    <section id="paper" class="card" aria-labelledby="paper-title">
      <h2 id="paper-title">${t("paper")}</h2>
      <p id="paper-known">${plane ? t("paper.known", { z: number(plane.z_mm), slope: number(steep_deg(plane)) }) : t("paper.unknown")}</p>
      ${page.touch_paper.places ? touching(context, page.touch_paper.places) : choices(context, plane !== null)}
      ${refusal(context, "paper")}
    </section>`;
}

/** @param {Context} context @param {boolean} isKnown */
function choices({ page, t, act }, isKnown) {
  const mayKeep = page.role === "admin";
  const begin = () => {
    act.send({ type: "paper_begun" });
    focusOn("paper-touch");
  };
  return html`
    <p class="quiet">${t(mayKeep ? "paper.hint" : "policy.admin")}</p>
    <div class="row">
      <button id="paper-begin" type="button" class="small strong" @click=${begin}>${t("paper.begin")}</button>
      <button id="paper-forget" type="button" class="small" ?disabled=${!isKnown || !mayKeep} @click=${() => act.calibrate.keepPaper(null)}>${t("paper.clear")}</button>
    </div>`;
}

/** @param {Context} context @param {readonly import("../../stage/view.js").Point[]} places */
function touching(context, places) {
  const { page, t, act } = context;
  const { found, problem } = page.touch_paper;
  const plane = found?.paper ?? null;
  const why = touchBlockedReason(page);
  const end = () => {
    act.send({ type: "paper_ended" });
    focusOn("paper-begin");
  };
  const keep = async () => {
    if (plane && (await act.calibrate.keepPaper(plane))) end();
  };
  const missing = Math.max(0, PLACES - places.length);
  return html`
    <p class="quiet">${t("paper.touch.hint")}</p>
    <dl id="paper-touches" class="list">${places.map(([x, y, z], n) => html`<div><dt>${t("paper.place", { place: n + 1, x: x.toFixed(0), y: y.toFixed(0) })}</dt><dd>${number(z)} mm</dd></div>`)}</dl>
    <div class="row">
      <button id="paper-touch" type="button" class="small strong" ?disabled=${why !== null} aria-describedby="paper-why" @click=${() => act.calibrate.touchPaper()}>${t("paper.touch")}</button>
      <button id="paper-back" type="button" class="small" ?disabled=${places.length === 0} @click=${() => act.send({ type: "paper_back" })}>${t("calibrate.undo")}</button>
      <button id="paper-leave" type="button" class="small end" @click=${end}>${t("calibrate.leave")}</button>
    </div>
    <p id="paper-why" class="quiet">${why ? t(`blocked.${why}`) : missing > 0 ? t("paper.missing", { missing }) : ""}</p>
    ${problem ? html`<p id="paper-problem" class="status" data-tone="bad" role="alert">${problemText(t, problem)}</p>` : nothing}
    ${found && plane ? html`
      <div class="made" role="status" id="paper-found">
        <p>${t("paper.found", { z: number(plane.z_mm), slope: number(steep_deg(plane)) })} ${t(places.length > PLACES ? "paper.bent" : "paper.flat", { mm: number(bent_mm(found)) })}</p>
        <div class="row"><button id="paper-keep" type="button" class="strong" ?disabled=${page.role !== "admin"} @click=${keep}>${t("paper.save")}</button></div>
      </div>` : nothing}`;
}
