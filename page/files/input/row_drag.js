// Moves a row of a list by its grip, with a mouse or a finger. STOP cancels the drag.

/** Height of a row, in pixels. */
export const ROW_PX = 34;
/** Distance from the edge at which the list scrolls, and the scroll step per frame. */
const EDGE_PX = 26;
const SCROLL_PX = 9;

/** @typedef {{ over(from: number, to: number): void, drop(from: number, to: number): void, cancel(): void }} RowDrag */

/** Returns the row at a position. @param {number} y_px below the upper edge of all rows @param {number} count */
export const rowBelow = (y_px, count) => Math.max(0, Math.min(count - 1, Math.floor(y_px / ROW_PX)));

/** Returns the scroll step for a pointer position. @param {number} y_px below the upper edge of the visible part @param {number} seen_px */
export const scrollAt = (y_px, seen_px) => (y_px < EDGE_PX ? -SCROLL_PX : y_px > seen_px - EDGE_PX ? SCROLL_PX : 0);

/** Starts a drag at a pressed grip. @param {PointerEvent} event @param {number} count number of rows @param {RowDrag} rowDrag */
export function startRowDrag(event, count, rowDrag) {
  const grip = /** @type {Element} */ (event.target).closest(".grip");
  if (!grip || event.button !== 0) return;
  const list = /** @type {HTMLElement} */ (event.currentTarget);
  const from = Number(/** @type {HTMLElement} */ (grip.closest("[data-row]")).dataset.row);
  let to = from, y = event.clientY;
  const over = new AbortController();
  const options = { signal: over.signal };

  function place() {
    const next = rowBelow(y - list.getBoundingClientRect().top + list.scrollTop, count);
    if (next === to) return;
    to = next;
    rowDrag.over(from, to);
  }
  /** Scrolls the list while the pointer stays at its edge. */
  function follow() {
    if (over.signal.aborted) return;
    const { top, height } = list.getBoundingClientRect();
    list.scrollTop += scrollAt(y - top, height);
    place();
    requestAnimationFrame(follow);
  }
  function end() {
    over.abort();
    if (list.hasPointerCapture(event.pointerId)) list.releasePointerCapture(event.pointerId);
  }
  function cancel() {
    end();
    rowDrag.cancel();
  }

  list.setPointerCapture(event.pointerId);
  rowDrag.over(from, to);
  requestAnimationFrame(follow);
  list.addEventListener("pointermove", (moved) => {
    y = moved.clientY;
    place();
  }, options);
  list.addEventListener("pointerup", () => {
    end();
    rowDrag.drop(from, to);
  }, options);
  list.addEventListener("pointercancel", cancel, options);
  list.addEventListener("lostpointercapture", cancel, options);
  document.addEventListener("keydown", ({ key }) => key === "Escape" && cancel(), { ...options, capture: true });
}
