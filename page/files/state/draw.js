// A drawing: source, placement and settings, and the station's plan.

import { paperOf } from "./paper.js";

/** @typedef {import("./types.js").Problem} Problem */
/** @typedef {import("./types.js").Schemas} Schemas */
/** @typedef {Schemas["DrawingPlan"]} Plan */
/** The supported formats. @typedef {readonly Schemas["Format"][]} Formats */
/** @typedef {{ x: string, y: string, scale: string, rotate: string, down: string }} Place The text of the fields; empty for the station's default. */
/** @typedef {{ tool: string, speed: string, tolerance: string, layers: "nothing" | "color" | "group" | "width", gcode: "file" | "laser" | "pen" | "mill", pens: Readonly<Record<string, string>>, hatch: boolean, clip: boolean, fit: boolean, height: string, font: string, wrap: string, border: boolean, sign: string }} Way */
/** @typedef {Place & Way} Settings */
/** @typedef {import("./files.js").StoredFile} StoredFile */
/** Placement of a drawing: centre, scale and rotation. @typedef {{ x_mm: number, y_mm: number, scale: number, rotate_deg: number }} Lies */

/**
 * @typedef {object} Draw
 * @property {"file" | "text"} what
 * @property {File | null} file A file that was chosen here.
 * @property {StoredFile | null} stored The file as the station stores it; instead of a chosen one, or as well.
 * @property {string} text
 * @property {Settings} set
 * @property {readonly Settings[]} past Earlier settings, the last one last.
 * @property {readonly Settings[]} future Undone settings, the next one last.
 * @property {string | null} changing The fields that are being changed, by one drag or while typing: one undo step.
 * @property {number} revision Revision of the drawing; results for earlier revisions are ignored.
 * @property {"nothing" | "planning" | "planned" | "failed"} phase
 * @property {number | null} drawing Its number, while the station knows it.
 * @property {Problem | null} problem
 * @property {{ plan: Plan, title: string, lies: Lies } | null} planned The last plan, kept while the next one is awaited.
 * @property {{ timeline: import("../preview/timeline.js").Timeline } | null} timeline The timeline shown: of the plan, or of a file.
 * @property {Schemas["PaperPlane"] | null} paper The measured paper surface.
 * @property {readonly Schemas["MaterialView"][]} materials
 * @property {Formats} formats
 */

/** The default centre of drawings. */
export const MIDDLE = { x_mm: 210, y_mm: 0 };
/** The extensions of what can be drawn, as a field for files takes them. @param {Formats} formats */
export const accepted = (formats) => formats.flatMap(({ extensions }) => extensions.map((extension) => `.${extension}`)).join(",");
/** The names of the supported formats. @param {Formats} formats */
export const formatNames = (formats) => formats.map(({ name }) => name).join(", ");
/** The largest file; Base64 adds a third. */
export const MOST_BYTES = 24_000_000;
/** The page's names of drawing options. @type {Readonly<Record<string, import("../i18n/i18n.js").TextKey>>} */
const FIELD_NAMES = {
  "what.hatch": "draw.hatch", "what.height": "draw.height", "what.layers": "draw.layers", "what.gcode": "draw.gcode", "what.wrap": "draw.wrap",
  "place.scale": "draw.scale", "place.rotate": "draw.rotate", "place.pen_down": "draw.down", "place.fit": "draw.fit", "place.clip": "draw.clip", "place.border": "draw.border", "place.sign": "draw.sign",
  "tool.pen": "draw.tool", "tool.laser": "draw.tool", "tool.speed": "draw.speed", "way.tolerance": "draw.tolerance",
};
/** The numeric fields. @type {readonly (keyof Settings)[]} */
const NUMBERS = ["x", "y", "scale", "rotate", "down", "speed", "tolerance", "height", "wrap"];

/** @type {Draw} */
export const NO_DRAW = {
  what: "file",
  file: null,
  stored: null,
  text: "",
  set: { x: "", y: "", scale: "", rotate: "", down: "", tool: "fineliner", speed: "", tolerance: "", layers: "nothing", gcode: "file", pens: {}, hatch: false, clip: false, fit: false, height: "", font: "sans", wrap: "", border: false, sign: "" },
  past: [],
  future: [],
  changing: null,
  revision: 0,
  phase: "nothing",
  drawing: null,
  problem: null,
  planned: null,
  timeline: null,
  paper: null,
  materials: [],
  formats: [],
};

/** @typedef {{ type: "draw_file", file: File }
 * | { type: "draw_text", text: string }
 * | { type: "draw_stored", stored: StoredFile }
 * | { type: "draw_kept", file: File, stored: StoredFile }
 * | { type: "draw_saved", stored: StoredFile }
 * | { type: "draw_unstored" }
 * | { type: "draw_settled" }
 * | { type: "draw_undo" }
 * | { type: "draw_redo" }
 * | { type: "draw_what", what: Draw["what"] }
 * | { type: "draw_set", set: Partial<Settings> }
 * | { type: "draw_begun", revision: number, drawing: number }
 * | { type: "draw_planned", revision: number, title: string, plan: Plan, timeline: import("../preview/timeline.js").Timeline, set: Settings }
 * | { type: "draw_timeline", timeline: import("../preview/timeline.js").Timeline }
 * | { type: "draw_failed", revision: number, problem: Problem }
 * | { type: "draw_cancelled" }
 * | { type: "materials", materials: Draw["materials"] }
 * | { type: "formats", formats: Formats }} DrawMessage */

/** @param {string} text */
const numberOf = (text) => (text.trim() === "" ? null : Number(text));

/** A text of the station with the names that the page has for the options in it. @param {import("../i18n/i18n.js").Translate} t @param {string} text */
export const withFieldNames = (t, text) => text.replace(/(?<![\w./])`?\b((?:what|place|tool|way)\.\w+)`?/g, (all, /** @type {string} */ field) => (FIELD_NAMES[field] ? `“${t(FIELD_NAMES[field])}”` : all));

/** Whether the file is G-code, by its name. @param {Draw} draw */
export const isGcode = ({ what, file, stored, formats }) => {
  const extensions = formats.find(({ name }) => name === "G-code")?.extensions ?? [];
  const name = (file ?? stored)?.name.toLowerCase() ?? "";
  return what === "file" && extensions.some((extension) => name.endsWith(`.${extension}`));
};

/** Whether there is something to draw. @param {Draw} draw */
export const hasSubject = ({ what, file, stored, text }) => (what === "file" ? file !== null || stored !== null : text.trim() !== "");

/** The first field that holds no number. @param {Settings} set @returns {keyof Settings | null} */
export const wrongField = (set) => NUMBERS.find((name) => Number.isNaN(numberOf(/** @type {string} */ (set[name])) ?? 0)) ?? null;

/** The options for the station. @param {import("./state.js").Page} page @returns {Schemas["Options"]} */
export function optionsOf(page) {
  const { set, what, text } = page.draw;
  const { materials } = page.draw;
  const number = (/** @type {keyof Settings} */ name) => numberOf(/** @type {string} */ (set[name])) ?? undefined;
  const burns = materials.find(({ name }) => name === set.tool)?.tool === "laser";
  const layer = set.layers === "nothing" ? [] : Object.entries(set.pens).map(([name, pen]) => ({ name, pen }));
  // A text with a height is not scaled: its height is.
  const letters_mm = what === "text" && !set.fit ? number("height") : undefined;
  const scale = number("scale");
  return /** @type {Schemas["Options"]} */ ({
    what: {
      ...(what === "text" ? { text, font: set.font, height: letters_mm === undefined ? undefined : (letters_mm * (scale ?? 100)) / 100, wrap: number("wrap") } : {}),
      ...(set.layers === "nothing" ? {} : { layers: set.layers, layer }),
      ...(set.hatch ? { hatch: "auto" } : {}),
      ...(isGcode(page.draw) && set.gcode !== "file" ? { gcode: set.gcode } : {}),
    },
    place: {
      at: [number("x") ?? MIDDLE.x_mm, number("y") ?? MIDDLE.y_mm],
      rotate: number("rotate") ?? 0,
      ...(set.fit ? { fit: true } : scale === undefined || letters_mm !== undefined ? {} : { scale: scale / 100 }),
      clip: set.clip,
      border: set.border,
      ...(set.sign.trim() === "" ? {} : { sign: set.sign.trim() }),
      // The station knows the height of a measured paper.
      pen_down: number("down") ?? (page.draw.paper ? undefined : paperOf(page)),
    },
    tool: { ...(burns ? { laser: set.tool } : { pen: set.tool }), speed: number("speed") },
    way: { tolerance: number("tolerance") ?? 0.05 },
  });
}

/**
 * The options as they are stored with a file. The height of the pen is left out: it belongs to the paper that lay there, and
 * would be wrong for another one.
 * @param {import("./state.js").Page} page @returns {Schemas["Options"]}
 */
export const storedOptions = (page) => withoutHeight(optionsOf(page));

/** @param {Schemas["Options"]} options @returns {Schemas["Options"]} */
function withoutHeight(options) {
  const { pen_down: _, ...place } = /** @type {Record<string, unknown>} */ (options.place ?? {});
  return /** @type {Schemas["Options"]} */ ({ ...options, place });
}

/** Whether two drawings are placed and drawn alike, in what the page has fields for. @param {Schemas["Options"] | null | undefined} a @param {Schemas["Options"] | null | undefined} b */
export const sameOptions = (a, b) => a != null && b != null && JSON.stringify(settingsOf(a)) === JSON.stringify(settingsOf(b));

/** The fields for stored options; those of the page for what is not stored. @param {Schemas["Options"] | null | undefined} options @returns {Settings} */
export function settingsOf(options) {
  const none = NO_DRAW.set;
  if (!options) return none;
  const { what, place, tool, way } = /** @type {Record<string, Record<string, any>>} */ (/** @type {unknown} */ (options));
  const text = (/** @type {unknown} */ value, /** @type {number | undefined} */ usual = undefined) => (typeof value !== "number" || value === usual ? "" : String(Math.round(value * 1e4) / 1e4));
  const [x, y] = place?.at ?? [];
  return {
    ...none,
    x: text(x, MIDDLE.x_mm), y: text(y, MIDDLE.y_mm), rotate: text(place?.rotate, 0),
    scale: place?.scale == null ? "" : text(place.scale * 100),
    fit: place?.fit ?? false, clip: place?.clip ?? false,
    tool: tool?.pen ?? tool?.laser ?? none.tool, speed: text(tool?.speed), tolerance: text(way?.tolerance, 0.05),
    layers: LAYERS.find((layers) => layers === what?.layers) ?? "nothing",
    pens: Object.fromEntries((what?.layer ?? []).map((/** @type {{ name: string, pen?: string }} */ { name, pen }) => [name, pen ?? none.tool])),
    hatch: what?.hatch != null, gcode: GCODE.find((gcode) => gcode === what?.gcode) ?? "file",
  };
}

/** The choices of layers; of what G-code is for. */
export const LAYERS = /** @type {const} */ (["nothing", "color", "group", "width"]);
export const GCODE = /** @type {const} */ (["file", "laser", "pen", "mill"]);
/** The most undo steps. */
const MOST_UNDO = 100;

/** Placement from the fields; empty fields keep the planned values. @param {Draw} draw @returns {Lies | null} */
export function liesOf({ set, planned }) {
  if (!planned || wrongField(set)) return null;
  return liesBy(set, planned.plan);
}

/** @param {Settings} set @param {Plan} plan @returns {Lies} */
const liesBy = (set, { scale }) => ({
  x_mm: numberOf(set.x) ?? MIDDLE.x_mm, y_mm: numberOf(set.y) ?? MIDDLE.y_mm,
  scale: set.fit || set.scale.trim() === "" ? scale : Number(set.scale) / 100,
  rotate_deg: numberOf(set.rotate) ?? 0,
});

/** Nothing can be undone. @type {Pick<Draw, "past" | "future" | "changing">} */
const UNDONE = { past: [], future: [], changing: null };

/** All changes of a drag, or while a field is typed in, are one undo step. @param {Draw} draw @param {Partial<Settings>} set @returns {Pick<Draw, "past" | "future" | "changing">} */
function undoStep(draw, set) {
  const changing = Object.keys(set).sort().join();
  const past = changing === draw.changing ? draw.past : [...draw.past, draw.set].slice(-MOST_UNDO);
  return { past, future: [], changing };
}

/** @param {Draw} draw @param {Partial<Draw>} change @returns {Draw} */
function changed(draw, change) {
  const next = { ...draw, ...change, revision: draw.revision + 1, problem: null };
  if (!hasSubject(next)) return { ...next, phase: "nothing", planned: null, timeline: null };
  return { ...next, phase: "planning" };
}

/** @param {Draw} draw @param {import("./message.js").Message} message @returns {Draw} */
export function reduceDraw(draw, message) {
  switch (message.type) {
    case "draw_file":
      return changed(draw, { what: "file", file: message.file, stored: null, planned: null, timeline: null, ...UNDONE });
    case "draw_stored":
      return changed(draw, { what: "file", file: null, stored: message.stored, set: settingsOf(message.stored.options), planned: null, timeline: null, ...UNDONE });
    case "draw_kept": {
      if (message.file !== draw.file || draw.stored?.file === message.stored.file) return draw;
      // A file that was drawn before is where it was placed.
      const set = message.stored.options && draw.past.length === 0 ? settingsOf(message.stored.options) : draw.set;
      return changed(draw, { stored: message.stored, set });
    }
    case "draw_saved":
      return message.stored.file === draw.stored?.file ? { ...draw, stored: message.stored } : draw;
    case "draw_unstored":
      // What was chosen here is still drawn.
      return changed(draw, { stored: null });
    case "draw_settled":
      return draw.changing === null ? draw : { ...draw, changing: null };
    case "draw_undo": {
      const set = draw.past.at(-1);
      return set ? changed(draw, { set, past: draw.past.slice(0, -1), future: [...draw.future, draw.set], changing: null }) : draw;
    }
    case "draw_redo": {
      const set = draw.future.at(-1);
      return set ? changed(draw, { set, past: [...draw.past, draw.set], future: draw.future.slice(0, -1), changing: null }) : draw;
    }
    case "draw_text":
      return changed(draw, { what: "text", text: message.text });
    case "draw_what":
      return message.what === draw.what ? draw : changed(draw, { what: message.what, planned: null, timeline: null });
    case "draw_set":
      return changed(draw, { set: { ...draw.set, ...message.set }, ...undoStep(draw, message.set) });
    case "draw_begun":
      return message.revision === draw.revision ? { ...draw, drawing: message.drawing } : draw;
    case "draw_planned":
      if (message.revision !== draw.revision) return draw;
      return { ...draw, phase: "planned", timeline: { timeline: message.timeline }, planned: { plan: message.plan, title: message.title, lies: liesBy(message.set, message.plan) } };
    case "draw_timeline":
      return { ...draw, ...UNDONE, revision: draw.revision + 1, phase: "nothing", file: null, stored: null, drawing: null, problem: null, planned: null, what: "file", timeline: { timeline: message.timeline } };
    case "draw_failed":
      return message.revision === draw.revision ? { ...draw, phase: "failed", drawing: null, problem: message.problem } : draw;
    case "draw_cancelled":
      return { ...draw, revision: draw.revision + 1, phase: "failed", problem: null, drawing: null };
    case "hello":
      // A restarted station has no drawings.
      return hasSubject(draw) ? changed(draw, { drawing: null }) : draw;
    case "calibrations": {
      const paper = message.known.calibration?.paper ?? null;
      if (JSON.stringify(paper) === JSON.stringify(draw.paper)) return draw;
      return hasSubject(draw) ? changed(draw, { paper }) : { ...draw, paper };
    }
    case "materials":
      return { ...draw, materials: message.materials };
    case "formats":
      return { ...draw, formats: message.formats };
    default:
      return draw;
  }
}
