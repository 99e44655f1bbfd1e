// A small picture of lines, from the station.

import { html, svg } from "../vendor/lit-html/lit-html.js";

/** The edge around the lines, as a part of their size. */
const EDGE = 0.06;

/** @param {import("../state/files.js").Sketch | null | undefined} sketch @param {string} label */
export function sketchPicture(sketch, label) {
  if (!sketch) return html`<span class="sketch" aria-hidden="true"></span>`;
  const [left = 0, top = 0, width = 0, height = 0] = sketch.view_mm;
  const edge = EDGE * Math.max(width, height, 1);
  return html`
    <svg class="sketch" role="img" aria-label=${label} viewBox="${left - edge} ${top - edge} ${width + 2 * edge} ${height + 2 * edge}">${svg`<path d=${sketch.path}></path>`}</svg>`;
}
