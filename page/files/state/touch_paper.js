// The paper surface: recorded points, and the surface that the station calculates from them.

/** @typedef {import("./types.js").Schemas} Schemas */
/** @typedef {import("../stage/view.js").Point} Point */

/** The fewest points that define a plane. */
export const PLACES = 3;

/**
 * @typedef {object} TouchPaper
 * @property {readonly Point[] | null} places Recorded positions; null while no measurement runs.
 * @property {Schemas["PaperReport"] | null} found The calculated surface.
 * @property {import("./types.js").Problem | null} problem Why it could not be calculated.
 */

/** @type {TouchPaper} */
export const NO_TOUCH_PAPER = { places: null, found: null, problem: null };

/** @typedef {{ type: "paper_begun" }
 * | { type: "paper_ended" }
 * | { type: "paper_touched", place: Point }
 * | { type: "paper_back" }
 * | { type: "paper_judged", places: readonly Point[], found: Schemas["PaperReport"] | null, problem: import("./types.js").Problem | null }} TouchPaperMessage */

/** Slope of a plane, in degrees. @param {Schemas["PaperPlane"]} plane */
export const steep_deg = ({ slope_x, slope_y }) => (Math.atan(Math.hypot(slope_x, slope_y)) * 180) / Math.PI;

/** From the lowest touch to the highest, seen from the plane, in mm. @param {Schemas["PaperReport"]} found */
export const bent_mm = ({ away_mm }) => Math.max(...away_mm) - Math.min(...away_mm);

/** @param {readonly Point[] | null} places @returns {TouchPaper} */
const touched = (places) => ({ places, found: null, problem: null });

/** @param {TouchPaper} paper @param {import("./message.js").Message} message @returns {TouchPaper} */
export function reduceTouchPaper(paper, message) {
  const { places } = paper;
  switch (message.type) {
    case "paper_begun":
      return touched([]);
    case "paper_ended":
      return touched(null);
    case "paper_touched":
      return places ? touched([...places, message.place]) : paper;
    case "paper_back":
      return places?.length ? touched(places.slice(0, -1)) : paper;
    case "paper_judged":
      // An answer about other touches comes too late.
      return message.places === places ? { places, found: message.found, problem: message.problem } : paper;
    case "state":
      // An arm whose pose is not trusted does not know where it stood.
      return places?.length && !message.station.trust.trusted ? touched([]) : paper;
    default:
      return paper;
  }
}
