// Pump, gripper and laser. Each control sends one command; the display shows what the arm reports.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { blockedReason, laser, mountedTool } from "../state/selectors.js";
import { armLaser } from "../views/problem.js";
import { formatClock } from "../i18n/i18n.js";

/** @typedef {import("../views/context.js").Context} Context */

const TONES = { off: "off", armed: "warn", burning: "bad" };
/** The tools that can be mounted: reach and height depend on them. */
const MOUNTS = /** @type {const} */ ([["suction_cup", "tool.suction_cup"], ["gripper", "tool.gripper_tool"], ["laser", "tool.laser_tool"]]);

/** @param {Context} context */
export function tools({ page, t, act }) {
  const arm = page.station?.arm;
  const why = blockedReason(page) !== null;
  const mounted = mountedTool(page);
  const shines = laser(page);
  const allowed = page.policy?.laser.allowed ?? true;
  const grip = (/** @type {SubmitEvent} */ event) => {
    event.preventDefault();
    const form = /** @type {HTMLFormElement} */ (event.target);
    if (form.reportValidity()) act.grip(/** @type {HTMLInputElement} */ (form.elements.namedItem("deg")).valueAsNumber);
  };
  const words = { off: t("tool.laser.disarmed"), armed: t("tool.laser.armed", { time: formatClock(page.station?.laser.armed_for_s ?? 0) }), burning: t("tool.laser.burning") };
  return html`
    <section class="card" aria-labelledby="tool-title">
      <h2 id="tool-title">${t("tool")}</h2>
      <div class="tool">
        <span class="name">${t("tool.suction")}</span>
        <b id="suction" class="chip" data-tone=${arm?.suction ? "warn" : "off"}>${arm ? t(arm.suction ? "tool.is_on" : "tool.is_off") : "–"}</b>
        <span class="acts">
          <button id="suction-on" type="button" class="small" ?disabled=${why} @click=${() => act.suction(true)}>${t("tool.on")}</button>
          <button id="suction-off" type="button" class="small" ?disabled=${why} @click=${() => act.suction(false)}>${t("tool.off")}</button>
        </span>
      </div>
      <form id="grip" class="tool" @submit=${grip}>
        <label class="name" for="grip-deg">${t("tool.gripper")}</label>
        <b id="gripper" class="chip" data-tone="off">${arm ? `${arm.gripper_deg.toFixed(0)}°` : "–"}</b>
        <span class="acts">
          <input id="grip-deg" name="deg" type="number" min="-90" max="90" step="any" required value="0" aria-describedby="grip-unit"> <span id="grip-unit">°</span>
          <button type="submit" class="small" ?disabled=${why}>${t("tool.set")}</button>
        </span>
      </form>
      <div class="tool">
        <span class="name">${t("tool.laser")}</span>
        <b id="laser" class="chip" data-tone=${TONES[shines]}>${words[shines]}</b>
        <span class="acts">
          ${shines === "off" ? nothing : html`<button id="disarm" type="button" class="small" @click=${() => act.ask({ type: "disarm_laser" })}>${t("tool.laser.disarm")}</button>`}
          <button id="arm-laser" type="button" class="small" ?disabled=${why || !allowed} @click=${() => armLaser({ t, act })}>${t("tool.laser.arm")}</button>
        </span>
      </div>
      <div class="tool">
        <span class="name">${t("tool.mounted")}</span>
        <span class="acts mounts">${MOUNTS.map(([tool, word]) => html`<button type="button" class="small ${tool === mounted ? "strong" : ""}" data-mount=${tool} aria-pressed=${tool === mounted ? "true" : "false"} ?disabled=${why} @click=${() => act.command({ type: "configuration", mode: "end_effector", tool })}>${t(word)}</button>`)}</span>
      </div>
      ${allowed ? nothing : html`<p class="quiet">${t("tool.laser.forbidden")}</p>`}
    </section>`;
}
