// Pointer and wheel on the stage: dragging a handle moves the target, anything else moves the camera.

/** @typedef {{ orbit(dx: number, dy: number): void, pan(dx: number, dy: number): void, zoom(times: number): void }} CameraInput Pixels. */
/** @typedef {{ hover(at: At | null): boolean, grab(at: At): boolean, drag(at: At): void, drop(): void }} TargetInput */
/** @typedef {{ x: number, y: number }} At From -1 to 1, to the right and up. */

/**
 * @param {HTMLElement} element
 * @param {CameraInput} camera
 * @param {TargetInput} target
 * @returns {() => void} takes the hands away
 */
export function createPointerInput(element, camera, target) {
  /** @type {Map<number, { x: number, y: number, right: boolean }>} */ const fingers = new Map();
  let dragging = -1;
  const leave = new AbortController();
  const options = { signal: leave.signal };

  /** @param {PointerEvent} event @returns {At} */
  function at(event) {
    const { left, top, width, height } = element.getBoundingClientRect();
    return { x: ((event.clientX - left) / width) * 2 - 1, y: 1 - ((event.clientY - top) / height) * 2 };
  }

  /** @param {PointerEvent} event */
  function down(event) {
    if (event.pointerType === "mouse" && event.button > 2) return;
    element.setPointerCapture(event.pointerId);
    if (fingers.size === 0 && event.button === 0 && !event.shiftKey && target.grab(at(event))) {
      dragging = event.pointerId;
      element.classList.add("is-dragging");
      return;
    }
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY, right: event.button !== 0 || event.shiftKey });
  }

  /** @param {PointerEvent} event */
  function move(event) {
    if (event.pointerId === dragging) return target.drag(at(event));
    const finger = fingers.get(event.pointerId);
    if (!finger) {
      if (event.pointerType === "mouse") element.classList.toggle("is-over-handle", target.hover(at(event)));
      return;
    }
    const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
    const [dx, dy] = [event.clientX - finger.x, event.clientY - finger.y];
    if (other) {
      const before = Math.hypot(finger.x - other.x, finger.y - other.y);
      const after = Math.hypot(event.clientX - other.x, event.clientY - other.y);
      if (before > 20 && after > 20) camera.zoom(after / before);
      camera.pan(dx / 2, dy / 2);
    } else if (finger.right) camera.pan(dx, dy);
    else camera.orbit(dx, dy);
    Object.assign(finger, { x: event.clientX, y: event.clientY });
  }

  /** @param {PointerEvent} event */
  function up(event) {
    fingers.delete(event.pointerId);
    if (event.pointerId !== dragging) return;
    dragging = -1;
    element.classList.remove("is-dragging");
    target.drop();
  }

  /** @param {WheelEvent} event */
  function wheel(event) {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    // A trackpad pinches as a wheel with Control.
    camera.zoom(Math.exp((-event.deltaY * lines * (event.ctrlKey ? 6 : 1)) / 900));
  }

  element.addEventListener("pointerdown", down, options);
  element.addEventListener("pointermove", move, options);
  element.addEventListener("pointerup", up, options);
  element.addEventListener("pointercancel", up, options);
  element.addEventListener("lostpointercapture", up, options);
  element.addEventListener("pointerleave", () => target.hover(null), options);
  element.addEventListener("contextmenu", (event) => event.preventDefault(), options);
  element.addEventListener("wheel", wheel, { ...options, passive: false });
  return () => leave.abort();
}
