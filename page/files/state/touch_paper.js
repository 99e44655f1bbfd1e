// How the paper lies: places of it that the tool has touched; the station says what they tell.

/** @typedef {import("./types.js").Schemas} Schemas */
/** @typedef {import("../stage/view.js").Point} Point */

/** So many touches tell a plane. */
export const PLACES = 3;

/**
 * @typedef {object} TouchPaper
 * @property {readonly Point[] | null} places Where the arm stood; nothing while nobody touches the paper.
 * @property {Schemas["PaperReport"] | null} found How the paper lies by them.
 * @property {import("./types.js").Problem | null} problem Why they do not tell it.
 */

/** @type {TouchPaper} */
export const NO_TOUCH_PAPER = { places: null, found: null, problem: null };

/** @typedef {{ type: "paper_begun" }
 * | { type: "paper_ended" }
 * | { type: "paper_touched", place: Point }
 * | { type: "paper_back" }
 * | { type: "paper_judged", places: readonly Point[], found: Schemas["PaperReport"] | null, problem: import("./types.js").Problem | null }} TouchPaperMessage */

/** How steep a plane is, in degrees. @param {Schemas["PaperPlane"]} plane */
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
