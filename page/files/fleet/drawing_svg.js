// The ink of an arm as an SVG file, in millimetres, seen from behind the arm. Pure.

import { LASER_WIDTH_MM, darkness } from "../stage/ink.js";

/** @typedef {import("../state/types.js").Schemas["WorldState"]} WorldState */
/** @typedef {readonly number[]} Point */

const INK = "#16293f";
const BURN = "#4a2c14";
const EDGE_MM = 5;
/** Of a world without paper and ink: what lies before the arm. */
const NOWHERE = [[150, -75], [300, 75]];

/** An SVG of the ink and the burns of a world. @param {WorldState} world @param {string} title */
export function drawingOf({ paper, tool, strokes, burns, holes }, title) {
  const width_mm = tool.kind.type === "pen" ? tool.kind.width_mm : LASER_WIDTH_MM;
  const inked = [...strokes, ...burns].flatMap(({ points_mm }) => points_mm).concat(holes.map(({ at_mm }) => at_mm));
  const { left, top, width, height } = frame(paper ? [paper.from_mm, paper.to_mm] : inked.length ? inked : NOWHERE, paper ? 0 : EDGE_MM);
  const lines = [
    ...strokes.map(({ points_mm }) => `<path d="${pathOf(points_mm)}"/>`),
    ...burns.map(({ points_mm, power_w, speed_mm_s }) => `<path d="${pathOf(points_mm)}" stroke="${BURN}" stroke-opacity="${number(darkness(power_w / speed_mm_s))}"/>`),
    ...holes.map(({ at_mm }) => `<path d="${pathOf([at_mm])}" stroke="${BURN}"/>`),
  ];
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}mm" height="${height}mm" viewBox="${left} ${top} ${width} ${height}">
<title>${escaped(title)}</title>
<rect x="${left}" y="${top}" width="${width}" height="${height}" fill="#fff"/>
<g fill="none" stroke="${INK}" stroke-width="${number(width_mm)}" stroke-linecap="round" stroke-linejoin="round">
${lines.join("\n")}
</g>
</svg>
`;
}

/** From behind the arm, right is -Y and up is X. @param {readonly Point[]} points @param {number} edge_mm */
function frame(points, edge_mm) {
  const across = points.map(([, y = 0]) => -y), down = points.map(([x = 0]) => -x);
  const least = (/** @type {number[]} */ of) => of.reduce((a, b) => Math.min(a, b)), most = (/** @type {number[]} */ of) => of.reduce((a, b) => Math.max(a, b));
  const [left, top] = [least(across) - edge_mm, least(down) - edge_mm];
  return { left: number(left), top: number(top), width: number(most(across) + edge_mm - left), height: number(most(down) + edge_mm - top) };
}

/** A single point is a dot. @param {readonly Point[]} points */
function pathOf(points) {
  const at = (/** @type {Point} */ [x = 0, y = 0]) => `${number(-y)} ${number(-x)}`;
  const [first = [], ...rest] = points;
  return `M${at(first)}${rest.length ? rest.map((point) => `L${at(point)}`).join("") : "h0"}`;
}

/** A thousandth of a millimetre is enough. @param {number} value */
const number = (value) => Math.round(value * 1000) / 1000;

const ESCAPES = /** @type {Record<string, string>} */ ({ "&": "&amp;", "<": "&lt;", ">": "&gt;" });

/** @param {string} text */
const escaped = (text) => text.replace(/[&<>]/g, (character) => ESCAPES[character] ?? character);
