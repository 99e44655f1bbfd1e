// The plan of a drawing, what is missing before it can start, and Start: always visible at the lower edge of the panel.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { hasSubject, withFieldNames, wrongField } from "../state/draw.js";
import { isBlocking, isReason, missingFor } from "../state/missing.js";
import { problemText, sentence } from "../i18n/problem_text.js";
import { remedyButton } from "../views/problem.js";
import { formatDuration } from "../i18n/i18n.js";

/** @typedef {import("../views/context.js").Context} Context */

/** A text of the station, with the page's field names. @param {Context["t"]} t @param {string} text */
export const named = (t, text) => sentence(withFieldNames(t, text));

/** Status text of the plan, and its tone. @param {Context} context @returns {[string, string]} */
function statusOf({ page, t }) {
  const { draw } = page;
  if (wrongField(draw.set)) return [t("target.number"), "off"];
  switch (draw.phase) {
    case "nothing":
      return ["", "off"];
    case "planning":
      return [t("draw.planning"), "off"];
    case "failed":
      return draw.problem ? [named(t, problemText(t, draw.problem)), "bad"] : [t("draw.cancelled"), "off"];
    case "planned": {
      const refused = draw.planned?.plan.refused;
      if (refused) return [problemText(t, refused), "bad"];
      const figures = draw.planned?.plan.timeline;
      const strokes = figures?.passes.reduce((sum, pass) => sum + pass.strokes, 0) ?? 0;
      const ink_mm = figures?.passes.reduce((sum, pass) => sum + pass.ink_mm, 0) ?? 0;
      return [t(draw.planned?.plan.burns ? "draw.planned.burn" : "draw.planned", { time: formatDuration(t, figures?.duration_s ?? 0), strokes, ink: (ink_mm / 1000).toFixed(2) }), "good"];
    }
  }
}

/** @param {Context} context */
export function startBar(context) {
  const { page, t, act } = context;
  const { draw } = page;
  if (!hasSubject(draw)) return nothing;
  const [text, tone] = statusOf(context);
  const isPlanned = draw.phase === "planned" && !draw.planned?.plan.refused && draw.drawing !== null;
  const missing = isPlanned ? missingFor(page) : [];
  const blocks = missing.filter(isBlocking);
  // Around the drawing the laser is off.
  const frames = isPlanned && !blocks.some(isReason);
  return html`
    <section class="dock" aria-label=${t("draw.plan")}>
      <p id="draw-status" class="status" role="status" data-tone=${tone}>${text}</p>
      ${missing.length ? html`<ul id="draw-missing" class="missing" aria-label=${t("missing")}>${missing.map((kind) => html`<li><span>${t(isReason(kind) ? `blocked.${kind}` : `missing.${kind}`)}</span> ${remedyButton(context, kind)}</li>`)}</ul>` : nothing}
      <div class="row">
        <button id="draw-start" type="button" class="strong" ?disabled=${!isPlanned || blocks.length > 0} @click=${() => act.draw("whole")}>${t("draw.start")}</button>
        <button id="draw-frame" type="button" title=${t("draw.frame.hint")} ?disabled=${!frames} @click=${() => act.draw("frame")}>${t("draw.frame")}</button>
        ${draw.phase === "planning" ? html`<button id="draw-cancel" type="button" class="end" @click=${() => act.send({ type: "draw_cancelled" })}>${t("draw.cancel")}</button>` : nothing}
      </div>
    </section>`;
}
