// How the paper lies: three places of it that the tool has touched tell its plane.

/** @typedef {import("./types.js").Schemas} Schemas */
/** @typedef {import("../stage/view.js").Point} Point */

/** So many touches tell a plane. */
export const PLACES = 3;
/** The triangle of the touches is at least so large, in mm²: a smaller one tells no slope. */
const LEAST_MM2 = 500;

/**
 * @typedef {object} TouchPaper
 * @property {readonly Point[] | null} places Where the arm stood; nothing while nobody touches the paper.
 * @property {Schemas["PaperPlane"] | null} plane How the paper lies by them.
 */

/** @type {TouchPaper} */
export const NO_TOUCH_PAPER = { places: null, plane: null };

/** @typedef {{ type: "paper_begun" }
 * | { type: "paper_ended" }
 * | { type: "paper_touched", place: Point }
 * | { type: "paper_back" }} TouchPaperMessage */

/** The plane through three places, unless they lie in a line or near each other. @param {readonly Point[]} places @returns {Schemas["PaperPlane"] | null} */
export function planeThrough([a, b, c]) {
  if (!a || !b || !c) return null;
  const [bx, by, bz, cx, cy, cz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2], c[0] - a[0], c[1] - a[1], c[2] - a[2]];
  const twice_mm2 = bx * cy - cx * by;
  if (Math.abs(twice_mm2) < 2 * LEAST_MM2) return null;
  const slope_x = (bz * cy - cz * by) / twice_mm2, slope_y = (bx * cz - cx * bz) / twice_mm2;
  return { z_mm: a[2] - slope_x * a[0] - slope_y * a[1], slope_x, slope_y };
}

/** How steep a plane is, in degrees. @param {Schemas["PaperPlane"]} plane */
export const steep_deg = ({ slope_x, slope_y }) => (Math.atan(Math.hypot(slope_x, slope_y)) * 180) / Math.PI;

/** @param {readonly Point[] | null} places @returns {TouchPaper} */
const touched = (places) => ({ places, plane: places && planeThrough(places) });

/** @param {TouchPaper} paper @param {import("./message.js").Message} message @returns {TouchPaper} */
export function reduceTouchPaper(paper, message) {
  const { places } = paper;
  switch (message.type) {
    case "paper_begun":
      return touched([]);
    case "paper_ended":
      return touched(null);
    case "paper_touched":
      return places && places.length < PLACES ? touched([...places, message.place]) : paper;
    case "paper_back":
      return places?.length ? touched(places.slice(0, -1)) : paper;
    case "state":
      // An arm whose pose is not trusted does not know where it stood.
      return places?.length && !message.station.trust.trusted ? touched([]) : paper;
    default:
      return paper;
  }
}
