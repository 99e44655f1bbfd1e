// A gamepad: the sticks jog while the right shoulder button is held; any face button stops.

/** @typedef {import("../state/jog.js").Axis} Axis */

const ENABLES = 5;
const STOPS = [0, 1, 2, 3];
/** Deflection below which a stick is at rest. */
const REST = 0.25;

/** The axes of the sticks by their number, and the jog axes of their positive and negative ends. */
const STICKS = /** @type {const} */ ([
  [0, "y_minus", "y_plus"],
  [1, "x_minus", "x_plus"],
  [2, "servo_minus", "servo_plus"],
  [3, "z_minus", "z_plus"],
]);

/**
 * Returns the axis of the stick that is furthest out, and its deflection from 0 to 1.
 * @param {readonly number[]} axes @returns {{ axis: Axis, share: number } | null}
 */
export function pushed(axes) {
  let best = { axis: "", share: 0 };
  for (const [number, plus, minus] of STICKS) {
    const value = axes[number] ?? 0;
    const share = Math.min(1, (Math.abs(value) - REST) / (1 - REST));
    if (share > best.share) best = { axis: value > 0 ? plus : minus, share };
  }
  return best.share > 0 ? best : null;
}

/**
 * @param {object} outside
 * @param {() => void} outside.stop
 * @param {import("./jog.js").JogInput} outside.jog
 * @param {() => number} outside.speed_percent
 * @param {() => void} outside.linear selects the linear frame
 */
export function listenToGamepad({ stop, jog, speed_percent, linear }) {
  let frame = 0, stopped = false, share = 0;

  function look() {
    const pad = navigator.getGamepads().find((gamepad) => gamepad?.connected);
    if (!pad) {
      frame = 0;
      return jog.releaseBy("gamepad");
    }
    frame = requestAnimationFrame(look);
    const stops = STOPS.some((button) => pad.buttons[button]?.pressed);
    if (stops && !stopped) stop();
    stopped = stops;
    const push = pad.buttons[ENABLES]?.pressed && !stops ? pushed(pad.axes) : null;
    if (!push) return jog.releaseBy("gamepad");
    share = push.share;
    linear();
    jog.hold("gamepad", push.axis, () => Math.max(1, Math.round(share * speed_percent())));
  }

  const begin = () => {
    if (!frame) frame = requestAnimationFrame(look);
  };
  window.addEventListener("gamepadconnected", begin);
  if (navigator.getGamepads().some(Boolean)) begin();
}
