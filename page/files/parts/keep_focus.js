// Keeps the keyboard focus near its place when the focused button disappears or is disabled.

/**
 * Renders. A focus that was lost goes to the buttons of the same job, or to the panel: never to a button that does something else.
 * @param {() => void} render
 */
export function keepFocus(render) {
  const focused = /** @type {HTMLElement | null} */ (document.activeElement);
  const job = /** @type {HTMLElement | null | undefined} */ (focused?.closest("[data-job]"))?.dataset.job;
  render();
  if (!focused || focused === document.body) return;
  const isUsable = focused.isConnected && !focused.matches(":disabled");
  const now = document.activeElement;
  // A view may have moved the focus on purpose.
  if ((now === focused && isUsable) || (now !== focused && now !== document.body)) return;
  const next = isUsable ? focused : document.querySelector(`[data-job="${job ?? ""}"] button:enabled`) ?? document.getElementById("panel");
  /** @type {HTMLElement | null} */ (next)?.focus({ preventScroll: true });
}
