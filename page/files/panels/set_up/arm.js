// Setup of the arm: connection, dialect and pose.

import { html, nothing, svg } from "../../vendor/lit-html/lit-html.js";
import { blockedReason, linkProblem } from "../../state/selectors.js";
import { sentence } from "../../i18n/problem_text.js";
import { problemLine } from "../../views/problem.js";

/** @typedef {import("../../views/context.js").Context} Context */

const TONES = { searching: "warn", listening: "warn", up: "good", lost: "bad" };
/** @type {readonly import("../../state/types.js").Schemas["Dialect"][]} */
const DIALECTS = ["specification", "firmware-1.1"];

/** The arm from above, straight ahead: its cable leaves at its back. @param {Context["t"]} t */
const straightAhead = (t) => svg`
  <svg class="ahead" viewBox="0 0 260 110" role="img" aria-label=${t("arm.ahead.picture")}>
    <path class="cable" d="M62 55 C 40 55 30 42 6 44"/>
    <rect class="base" x="52" y="27" width="60" height="56" rx="8"/>
    <circle class="turn" cx="84" cy="55" r="20"/>
    <rect class="link" x="78" y="48" width="112" height="14" rx="7"/>
    <circle class="tip" cx="186" cy="55" r="9"/>
    <path class="axis" d="M204 55 H 246 M 238 49 L 247 55 L 238 61"/>
    <text x="222" y="44">X</text>
  </svg>`;

/** @param {Context} context */
export function armGuide(context) {
  const { page, t, act } = context;
  const { station, set_up } = page;
  if (!station) return nothing;
  const { link, trust, dialect } = station;
  return html`
    <section class="card guide" aria-labelledby="arm-title">
      <h2 id="arm-title">${t("arm")}</h2>
      <ol>
        <li>
          <h3>${t("arm.found")} <b class="chip" data-tone=${TONES[link.phase]}>${t(`link.${link.phase}`)}</b></h3>
          <p>${link.address ?? t("watch.not_found")}</p>
          ${link.problem ? html`<p class="status" data-tone="warn">${linkProblem(link)}</p>` : nothing}
          ${link.phase === "up" ? nothing : html`<p class="quiet">${t("arm.found.hint")}</p>`}
        </li>
        <li>
          <h3>${t("arm.dialect")} <b id="dialect-now" class="chip" data-tone=${dialect ? "good" : "warn"}>${dialect ?? t("watch.not_known")}</b></h3>
          <p class="quiet">${t("arm.dialect.hint")}</p>
          <div class="row">
            <button id="detect" type="button" class="small" ?disabled=${blockedReason(page) !== null} @click=${() => act.question({ about: "detect" })}>${t("arm.detect")}</button>
            ${DIALECTS.map((choice) => html`<button type="button" class="small" data-dialect=${choice} ?disabled=${choice === dialect || link.phase !== "up"} @click=${() => act.setUp.useDialect(choice)}>${t("arm.use", { dialect: choice })}</button>`)}
          </div>
          ${set_up.finding ? html`
            <p id="finding" class="status" data-tone="good" role="status">${t("arm.is", { dialect: set_up.finding.dialect })}</p>
            <ul class="evidence">${set_up.finding.evidence.map(({ question, saw, means }) => html`<li><b>${sentence(question)}</b> ${saw}: ${means}</li>`)}</ul>` : nothing}
        </li>
        <li>
          <h3>${t("arm.pose")} <b class="chip" data-tone=${trust.trusted ? "good" : "warn"}>${t(trust.trusted ? "arm.pose.trusted" : "arm.pose.not")}</b></h3>
          ${straightAhead(t)}
          <p class="quiet">${t("arm.pose.hint")}</p>
          ${trust.trusted ? nothing : html`<button type="button" class="small strong" ?disabled=${!station.arm} @click=${() => act.question({ about: "confirm_pose" })}>${t("pose.confirm")}</button>`}
        </li>
      </ol>
      ${refusal(context, "arm")}
    </section>`;
}

/** Why the last change was refused, shown in its section. @param {Context} context @param {import("../../state/set_up.js").Place} place */
export function refusal(context, place) {
  const { refused } = context.page.set_up;
  if (refused?.place !== place) return nothing;
  return html`<p class="status refusal" data-tone="bad" role="alert">${problemLine(context, refused.problem)}</p>`;
}
