// STOP buttons act on the press of any pointer: a finger that moves, slides off, or is not the only one creates no click.

/** The button whose click is still to come. @type {EventTarget | null} */
let pressed = null;

/**
 * Listener for `@pointerdown` and `@click`. A click without a press comes from a key or a screen reader.
 * @param {() => void} stop
 */
export const stops = (stop) => ({
  capture: true,
  /** @param {Event} event */
  handleEvent(event) {
    const isPress = event.type === "pointerdown", wasPressed = pressed === event.currentTarget && /** @type {UIEvent} */ (event).detail > 0;
    pressed = isPress ? event.currentTarget : null;
    if (isPress || !wasPressed) stop();
  },
});
