// Arrow keys on the board: focus moves to the tile in that direction. Pure.

/** @typedef {{ left: number, top: number, right: number, bottom: number }} Box */

/**
 * Returns the index of the tile in a direction; unchanged at the edge.
 * @param {readonly Box[]} boxes in their order @param {number} from @param {string} key @returns {number | undefined} nothing for a key that leads nowhere
 */
export function nextTile(boxes, from, key) {
  const last = boxes.length - 1;
  switch (key) {
    case "ArrowRight":
      return Math.min(last, from + 1);
    case "ArrowLeft":
      return Math.max(0, from - 1);
    case "Home":
      return 0;
    case "End":
      return last;
    case "ArrowDown":
      return inRow(boxes, from, (it, now) => it.top >= now.bottom);
    case "ArrowUp":
      return inRow(boxes, from, (it, now) => it.bottom <= now.top);
    default:
      return undefined;
  }
}

/** Returns the horizontally closest tile of the nearest row above or below. @param {readonly Box[]} boxes @param {number} from @param {(it: Box, now: Box) => boolean} isThatWay */
function inRow(boxes, from, isThatWay) {
  const now = boxes[from];
  if (!now) return from;
  const middle = (/** @type {Box} */ { left, right }) => (left + right) / 2;
  const away = (/** @type {Box} */ box) => Math.abs((box.top + box.bottom) / 2 - (now.top + now.bottom) / 2) * 1000 + Math.abs(middle(box) - middle(now));
  const found = boxes.map((it, n) => ({ it, n })).filter(({ it }) => isThatWay(it, now)).sort((a, b) => away(a.it) - away(b.it))[0];
  return found?.n ?? from;
}

/** Lets the keys lead from one of these elements to another. @param {HTMLElement} root @param {string} selector */
export function listenToWalk(root, selector) {
  root.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const all = /** @type {HTMLElement[]} */ ([...root.querySelectorAll(selector)]);
    const from = all.indexOf(/** @type {HTMLElement} */ (document.activeElement));
    if (from < 0) return;
    const to = nextTile(all.map((tile) => tile.getBoundingClientRect()), from, event.key);
    if (to === undefined) return;
    event.preventDefault();
    all[to]?.focus();
  });
}
