// The keyboard: STOP from anywhere, and jogging while the stage has the focus.

/** @typedef {import("../state/jog.js").Axis} Axis */
/** @typedef {import("../state/jog.js").Frame} Frame */

/** @type {Record<Frame, Record<string, Axis>>} */
const JOG_KEYS = {
  linear: { ArrowUp: "x_plus", ArrowDown: "x_minus", ArrowLeft: "y_plus", ArrowRight: "y_minus", PageUp: "z_plus", PageDown: "z_minus", q: "servo_plus", e: "servo_minus" },
  joint: { ArrowLeft: "base_plus", ArrowRight: "base_minus", ArrowUp: "rear_plus", ArrowDown: "rear_minus", PageUp: "fore_minus", PageDown: "fore_plus", q: "servo_plus", e: "servo_minus" },
};
const WRITES = "input:not([type=checkbox], [type=radio], [type=range], [type=file], [type=color]), textarea, [contenteditable]";
const PRESSED = "button, a, summary, select, [type=checkbox], [type=radio], [type=file], [type=color]";

/**
 * Whether a key stops the arm. Escape always does. Space does not in a text field, nor on a control focused by the keyboard; a
 * control focused by a click does not keep it.
 * @param {string} key @param {Pick<Element, "matches"> | null} focused @param {boolean} byKeys whether the focus came there by keys
 */
export function isStop(key, focused, byKeys) {
  if (key === "Escape") return true;
  if (key !== " " || focused?.matches(WRITES)) return false;
  return !(byKeys && focused?.matches(PRESSED));
}

/** Returns the jog axis of a key pressed on the stage. @param {KeyboardEvent} event @param {Frame} frame @returns {Axis | undefined} */
export function axisOf({ key, ctrlKey, altKey, metaKey, shiftKey }, frame) {
  if (ctrlKey || altKey || metaKey || shiftKey) return undefined;
  return JOG_KEYS[frame][key];
}

/** Stops on Escape and Space wherever the focus is, before any other listener. @param {() => void} stop @param {AbortSignal} [signal] what ends it */
export function listenToStop(stop, signal) {
  const options = { capture: true, signal };
  let byKeys = false, lastWasKey = false;
  document.addEventListener("pointerdown", () => (byKeys = lastWasKey = false), options);
  document.addEventListener("focusin", () => (byKeys = lastWasKey), options);
  document.addEventListener("keydown", (event) => {
    if (event.key !== " ") lastWasKey = true;
    if (!isStop(event.key, document.activeElement, byKeys)) return;
    event.preventDefault();
    if (!event.repeat) stop();
  }, options);
}

/**
 * @param {object} outside
 * @param {HTMLElement} outside.stage
 * @param {() => void} outside.stop
 * @param {import("./jog.js").JogInput} outside.jog
 * @param {() => Frame} outside.frame
 */
export function listenToKeys({ stage, stop, jog, frame }) {
  listenToStop(stop);
  // The name of a key may change between press and release; its code does not.
  stage.addEventListener("keydown", (event) => {
    const axis = axisOf(event, frame());
    if (!axis) return;
    event.preventDefault();
    if (!event.repeat) jog.press(event.code, axis);
  });
  stage.addEventListener("keyup", (event) => jog.releaseBy(event.code));
  stage.addEventListener("blur", () => jog.release());
  window.addEventListener("blur", () => jog.release());
  window.addEventListener("pagehide", () => jog.release());
  document.addEventListener("visibilitychange", () => jog.release());
}
