// The paper from above, seen from behind the arm: the drawing can be moved, rotated and scaled on it.

import { html, nothing, svg } from "../vendor/lit-html/lit-html.js";
import { memoize } from "../state/selectors.js";
import { liesOf } from "../state/draw.js";

/** @typedef {import("../views/context.js").Context} Context */
/** @typedef {import("../state/draw.js").Lies} Lies */
/** @typedef {import("../state/draw.js").Plan} Plan */

/** The visible area: Y to the left and X up, in mm. */
const SEEN = { left_mm: 180, top_mm: 335, width_mm: 360, height_mm: 265 };
/** The most vertices drawn; more are not visible here. */
const MOST_CORNERS = 20_000;
const HANDLE_MM = 7;
const LEAST_SCALE = 0.01;

/** The lines of a plan around its middle, and how far they go. */
const outline = memoize((/** @type {{ plan: Plan, lies: Lies }} */ { plan, lies }) => {
  const { x_mm, y_mm, ink } = plan.timeline.path;
  const skip = Math.max(1, Math.ceil(ink.length / MOST_CORNERS));
  /** @type {string[]} */ const corners = [];
  let [left, right, top, bottom] = [Infinity, -Infinity, Infinity, -Infinity];
  let since = 0;
  for (let row = 0; row < ink.length; row += 1) {
    if (ink[row] === 0) continue;
    const u = lies.y_mm - (y_mm[row] ?? 0), v = lies.x_mm - (x_mm[row] ?? 0);
    [left, right, top, bottom] = [Math.min(left, u), Math.max(right, u), Math.min(top, v), Math.max(bottom, v)];
    const ends = ink[row + 1] !== 1;
    since = ink[row] === 2 ? 0 : since + 1;
    if (ink[row] === 2) corners.push(`M${u.toFixed(2)} ${v.toFixed(2)}${ends ? "h.01" : ""}`);
    else if (since % skip === 0 || ends) corners.push(`L${u.toFixed(2)} ${v.toFixed(2)}`);
  }
  return { path: corners.join(""), left, right, top, bottom };
});

/** The running drag: placement and pointer position at its start. @type {{ kind: "move" | "turn" | "scale", lies: Lies, from: [number, number] } | null} */
let held = null;

/** Pointer position on the paper: X and Y in mm. @param {PointerEvent} event @returns {[number, number]} */
function placeOf(event) {
  const element = /** @type {SVGElement} */ (event.currentTarget);
  const paper = /** @type {SVGSVGElement} */ (element.ownerSVGElement ?? element);
  const matrix = paper.getScreenCTM();
  if (!matrix) return [0, 0];
  const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
  return [-y, -x];
}

/** Returns the settings for a pointer position. @param {NonNullable<typeof held>} held @param {[number, number]} to @returns {Partial<import("../state/draw.js").Settings>} */
export function moved({ kind, lies, from }, to) {
  const [x, y] = [to[0] - lies.x_mm, to[1] - lies.y_mm];
  const [x0, y0] = [from[0] - lies.x_mm, from[1] - lies.y_mm];
  switch (kind) {
    case "move":
      return { x: (lies.x_mm + to[0] - from[0]).toFixed(1), y: (lies.y_mm + to[1] - from[1]).toFixed(1) };
    case "turn": {
      const turned_deg = ((Math.atan2(y, x) - Math.atan2(y0, x0)) * 180) / Math.PI + lies.rotate_deg;
      return { rotate: (((turned_deg + 540) % 360) - 180).toFixed(0) };
    }
    case "scale":
      return { fit: false, scale: (100 * Math.max(LEAST_SCALE, (lies.scale * Math.hypot(x, y)) / Math.max(1, Math.hypot(x0, y0)))).toFixed(0) };
  }
}

/** @param {Context} context */
export function sheet({ page, t, act }) {
  const { planned } = page.draw;
  const lies = liesOf(page.draw);
  const reach_mm = page.facts?.workspace.reach_mm ?? [];
  const take = (/** @type {NonNullable<typeof held>["kind"]} */ kind) => (/** @type {PointerEvent} */ event) => {
    if (!lies || event.button !== 0) return;
    event.preventDefault();
    /** @type {Element} */ (event.currentTarget).setPointerCapture(event.pointerId);
    held = { kind, lies, from: placeOf(event) };
  };
  const move = (/** @type {PointerEvent} */ event) => {
    if (held) act.send({ type: "draw_set", set: moved(held, placeOf(event)) });
  };
  const let_go = () => {
    held = null;
    act.send({ type: "draw_settled" });
  };
  const hand = (/** @type {NonNullable<typeof held>["kind"]} */ kind) => ({ take: take(kind), move, let_go });
  return html`
    <svg id="sheet" class="sheet" role="img" aria-label=${t("draw.sheet")} viewBox="${-SEEN.left_mm} ${-SEEN.top_mm} ${SEEN.width_mm} ${SEEN.height_mm}">
      ${reach_mm.map((radius) => svg`<circle class="reach" r=${radius}></circle>`)}
      ${paper(page)}
      ${planned && lies ? drawing(outline(planned), planned.lies, lies, { move: hand("move"), turn: hand("turn"), scale: hand("scale") }) : nothing}
    </svg>`;
}

/** @param {Context["page"]} page */
function paper({ around }) {
  const { from_mm, to_mm } = around?.paper ?? { from_mm: [150, -100], to_mm: [270, 100] };
  const [x0 = 0, y0 = 0] = from_mm, [x1 = 0, y1 = 0] = to_mm;
  return svg`<rect class="paper" x=${-Math.max(y0, y1)} y=${-Math.max(x0, x1)} width=${Math.abs(y1 - y0)} height=${Math.abs(x1 - x0)}></rect>`;
}

/**
 * @param {ReturnType<typeof outline>} lines @param {Lies} was @param {Lies} lies
 * @param {Record<"move" | "turn" | "scale", { take: (event: PointerEvent) => void, move: (event: PointerEvent) => void, let_go: () => void }>} hands
 */
function drawing({ path, left, right, top, bottom }, was, lies, hands) {
  if (!Number.isFinite(left)) return nothing;
  const larger = lies.scale / was.scale;
  const turned_deg = lies.rotate_deg - was.rotate_deg;
  const [x, y, width, height] = [left * larger, top * larger, (right - left) * larger, (bottom - top) * larger];
  const middle = x + width / 2;
  return svg`
    <g transform="translate(${-lies.y_mm} ${-lies.x_mm}) rotate(${-turned_deg})">
      <path class="ink" d=${path} transform="scale(${larger})"></path>
      <rect id="sheet-move" class="hold" x=${x - 2} y=${y - 2} width=${width + 4} height=${height + 4} @pointerdown=${hands.move.take} @pointermove=${hands.move.move} @pointerup=${hands.move.let_go} @pointercancel=${hands.move.let_go}></rect>
      <path class="stalk" d="M${middle} ${y - 2}v${-HANDLE_MM}"></path>
      <circle id="sheet-turn" class="handle" cx=${middle} cy=${y - 2 - HANDLE_MM} r=${HANDLE_MM / 2} @pointerdown=${hands.turn.take} @pointermove=${hands.turn.move} @pointerup=${hands.turn.let_go} @pointercancel=${hands.turn.let_go}></circle>
      <rect id="sheet-scale" class="handle" x=${x + width} y=${y + height} width=${HANDLE_MM} height=${HANDLE_MM} @pointerdown=${hands.scale.take} @pointermove=${hands.scale.move} @pointerup=${hands.scale.let_go} @pointercancel=${hands.scale.let_go}></rect>
    </g>`;
}
