// STOP buttons act on the press, of any pointer: a finger that moves, slides off, or is not the only one makes no click.

/** The press whose click is still to come. @type {EventTarget | null} */
let pressed = null;

/**
 * What a STOP button listens to, for `@pointerdown` and `@click`. A click that no press led to is that of a key or of a screen reader.
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
