// The jog buttons: they move the arm while held, or by one step.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { live } from "../vendor/lit-html/directives/live.js";
import { blockedReason } from "../state/selectors.js";
import { blockedLine, problemLine } from "../views/problem.js";

/** @typedef {import("../views/context.js").Context} Context */
/** @typedef {import("../i18n/i18n.js").TextKey} TextKey */
/** A button: its axis, label, direction and place. @typedef {[axis: string, name: string, way: TextKey, place: string]} Button */

/** @type {readonly Button[]} */
const LINEAR = [
  ["servo_plus", "R+", "direction.turn", "nw"],
  ["x_plus", "X+", "direction.forward", "n"],
  ["servo_minus", "R−", "direction.turn", "ne"],
  ["z_plus", "Z+", "direction.up", "u"],
  ["y_plus", "Y+", "direction.left", "w"],
  ["y_minus", "Y−", "direction.right", "e"],
  ["x_minus", "X−", "direction.back", "s"],
  ["z_minus", "Z−", "direction.down", "d"],
];
/** @type {readonly Button[]} */
const JOINT = [
  ["base_plus", "J1+", "direction.left", ""],
  ["base_minus", "J1−", "direction.right", ""],
  ["rear_plus", "J2+", "direction.forward", ""],
  ["rear_minus", "J2−", "direction.back", ""],
  ["fore_plus", "J3+", "direction.down", ""],
  ["fore_minus", "J3−", "direction.up", ""],
  ["servo_plus", "J4+", "direction.turn", ""],
  ["servo_minus", "J4−", "direction.turn", ""],
];
/** @type {readonly TextKey[]} */
const JOINTS = ["pose.base", "pose.base", "pose.rear", "pose.rear", "pose.fore", "pose.fore", "pose.servo", "pose.servo"];
const STEPS = [0.1, 1, 10];
/** How far a pointer may slide off a held button. */
const SLIDE_PX = 20;

/** Whether a pointer has left a button: it is captured, so no event says so. @param {{ clientX: number, clientY: number }} pointer @param {Pick<DOMRect, "left" | "right" | "top" | "bottom">} box */
export const isOff = ({ clientX: x, clientY: y }, { left, right, top, bottom }) => Math.max(left - x, x - right, top - y, y - bottom) > SLIDE_PX;

/** Returns the label of an axis. @param {string} axis */
export const nameOf = (axis) => [...LINEAR, ...JOINT].find(([it]) => it === axis)?.[1] ?? axis;

/** Why the last press ended, whether this one waits, or how the buttons work. @param {Context} context */
function status(context) {
  const { page, t } = context;
  const { frame, step, waits_until_s, refused } = page.jog;
  if (refused) return html`${nameOf(refused.axis)}: ${problemLine(context, refused.problem)}${step === null && refused.problem.rule ? html` ${t("jog.slower")}` : nothing}`;
  if (waits_until_s !== null) return t("jog.waits");
  return step === null ? t("jog.hint.hold") : t(`jog.hint.step.${frame}`, { step });
}

/** The tabs in which a person positions the arm. */
const POSITIONS = new Set(["draw", "teach", "set_up"]);

/** The jog pad over the picture, where no tab has to be changed to move the arm. @param {Context} context */
export function floatingJog(context) {
  const { page, t, act } = context;
  if (!POSITIONS.has(page.tab)) return nothing;
  const { floats } = page.jog;
  return html`
    <div id="jog-float" class="jog-float">
      <button id="jog-fold" type="button" class="small" aria-expanded=${floats ? "true" : "false"} @click=${() => act.send({ type: "jog_set", set: { floats: !floats } })}>${t(floats ? "jog.fold" : "jog")}</button>
      ${floats ? jogPanel(context) : nothing}
    </div>`;
}

/** @param {Context} context */
export function jogPanel(context) {
  const { page, t, act, jog } = context;
  const { frame, step, speed_percent, held } = page.jog;
  const why = blockedReason(page);
  const buttons = frame === "linear" ? LINEAR : JOINT;

  const buttonOf = (/** @type {Event} */ event) => /** @type {HTMLButtonElement | null} */ (/** @type {Element} */ (event.target).closest("button[data-axis]"));
  const press = (/** @type {Event} */ event) => {
    const button = buttonOf(event);
    if (button && !button.disabled) jog.press(button, button.dataset.axis ?? "");
  };
  const release = (/** @type {Event} */ event) => jog.releaseBy(buttonOf(event));
  const move = (/** @type {PointerEvent} */ event) => {
    const button = buttonOf(event);
    if (button && isOff(event, button.getBoundingClientRect())) jog.releaseBy(button);
  };
  const pointer = (/** @type {PointerEvent} */ event) => {
    const button = buttonOf(event);
    if (event.button !== 0 || !button) return;
    button.setPointerCapture(event.pointerId);
    press(event);
  };
  const key = (/** @type {KeyboardEvent} */ event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    if (!event.repeat) press(event);
  };

  return html`
    <section class="card" aria-labelledby="jog-title">
      <h2 id="jog-title">${t("jog")}</h2>
      <div class="choices">
        <fieldset class="segments">
          <legend>${t("jog.mode")}</legend>
          ${(/** @type {const} */ (["linear", "joint"])).map((choice) => html`<label><input type="radio" name="frame" value=${choice} .checked=${live(choice === frame)} @change=${() => act.send({ type: "jog_set", set: { frame: choice } })}><span>${t(`jog.${choice}`)}</span></label>`)}
        </fieldset>
        <fieldset class="segments">
          <legend>${t("jog.step")} <small>${t("jog.mm_or_deg")}</small></legend>
          ${[null, ...STEPS].map((choice) => html`<label><input type="radio" name="step" value=${choice ?? "hold"} .checked=${live(choice === step)} @change=${() => act.send({ type: "jog_set", set: { step: choice } })}><span>${choice ?? t("jog.hold")}</span></label>`)}
        </fieldset>
      </div>
      <div class=${frame === "linear" ? "pad" : "pad joints"} @pointerdown=${pointer} @pointermove=${move} @pointerup=${release} @pointercancel=${release} @lostpointercapture=${release}
        @focusout=${release} @keyup=${release} @keydown=${key} @contextmenu=${(/** @type {Event} */ event) => event.preventDefault()}>
        ${buttons.map(([axis, name, way, place], n) => html`<button type="button" data-axis=${axis} class="${place} ${held === axis ? "is-held" : ""}" ?disabled=${why !== null}>${name}<small>${frame === "joint" ? html`<span class="full">${t(/** @type {TextKey} */ (JOINTS[n]))} </span>` : ""}${t(way)}</small></button>`)}
      </div>
      <label class="speed">${t("jog.speed")} <input id="speed" type="range" min="5" max="100" step="5" .value=${live(String(speed_percent))}
        @input=${(/** @type {Event} */ event) => act.send({ type: "jog_set", set: { speed_percent: Number(/** @type {HTMLInputElement} */ (event.target).value) } })}> <output id="speed-shown" for="speed">${speed_percent} %</output></label>
      <p id="jog-why" class="status" role="status" data-tone=${!why && page.jog.refused ? "bad" : "off"}>${why ? blockedLine(context) : status(context)}</p>
    </section>`;
}
