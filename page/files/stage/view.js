// What the stage shows: one plain object, made from the state of the page, never changed after it was given. The stage
// compares its parts by identity: a part that is the same object as before costs nothing.
//
// Lengths are millimetres in the base frame (X ahead, Y to the left, Z up, origin in the rear arm's pivot), angles degrees,
// as in the API. `z` of a pose is the height of the wrist; the tip of the tool is `tool.length_mm` lower.
//
//   const stage = createStage(element);
//   stage.show({ ...EMPTY, arm, tool, paper });        as often as anything changed
//   stage.look("top");                                  a preset of the camera
//   element.addEventListener("target", (event) => ...)  event.detail is a `Target`: a person drags it
//   element.addEventListener("shown", (event) => ...)   event.detail is "3d", or "2d" where WebGL is missing or lost
//   stage.end();

/** @typedef {import("../api").components["schemas"]["Tool"]} Tool */
/** @typedef {import("../state/types.js").Schemas} Schemas */
/** The bounds and keep-outs that arm or ghost are near to, and how near: above 0, and 1 at them or beyond. @typedef {{ limits: readonly Schemas["NearLimit"][], keep_outs: Readonly<Record<string, number>> }} Near */
/** @typedef {"iso" | "top" | "side" | "tool"} Preset */
/** @typedef {[number, number]} Bounds The least and the most that is allowed. */
/** @typedef {[number, number]} Place */
/** @typedef {[number, number, number]} Point */

/** @typedef {{ base_deg: number, rear_deg: number, fore_deg: number, servo_deg: number }} Joints */
/** @typedef {{ x_mm: number, y_mm: number, z_mm: number, rotation_deg: number }} Pose */

/**
 * The reported arm, with the station's time.
 * @typedef {Joints & { at_s: number, suction: boolean, gripper_deg: number }} Reported
 */

/**
 * The target, drawn as a ghost: red if refused; only its handles if no arm can reach it.
 * @typedef {Pose & { refused: boolean }} Ghost
 */

/**
 * A drag of the target: `drag` while the pointer moves, `drop` on release.
 * @typedef {Pose & { phase: "drag" | "drop" }} Target
 */

/**
 * Lines of ink or burn: four numbers for each, `x0 y0 x1 y1`, and how dark it is, from 0 to 1. It only grows: more lines are
 * added to the same object. Other lines are another object.
 * @typedef {{ width_mm: number, ends_mm: number[], shades: number[] }} Marks
 */

/**
 * A drawing that is planned, line by line, places of the wrist: six numbers for each, `x0 y0 z0 x1 y1 z1`, and which of the
 * colours its ink has; -1 where the tool leaves none.
 * @typedef {{ ends_mm: Float32Array, inks: Int32Array, colors: readonly string[] }} Drawing
 */

/**
 * A plane, as heights of the wrist: at the axis of the base, and how much it rises with each mm ahead and to the left; and where
 * the wrist was when it was touched. @typedef {{ z_mm: number, slope_x: number, slope_y: number, touches: readonly Point[] }} Plane
 */

/** @typedef {{ type: "box", size_mm: Point } | { type: "cylinder", diameter_mm: number, height_mm: number }} Shape */
/** @typedef {{ name: string, shape: Shape, color: string, at_mm: Place, turn_deg: number, bottom_mm: number }} Thing */
/** @typedef {{ box: { x_mm: Bounds, y_mm: Bounds, z_mm: Bounds } }} Box */
/** @typedef {{ cylinder: { x_mm: number, y_mm: number, radius_mm: number, z_mm: Bounds } }} Cylinder */

/** The lengths of the arm, and from its wrist to the axis of its tool, level. @typedef {Schemas["Dimensions"] & { reach_mm: number }} ArmShape */

/**
 * The limits of the policy, as in the API.
 * @typedef {object} Limits
 * @property {{ base_deg: number[], rear_deg: number[], fore_deg: number[], servo_deg: number[], opening_deg: number[] }} joints
 * @property {{ x_mm: number[], y_mm: number[], z_mm: number[], reach_mm: number[] }} workspace
 */

/**
 * @typedef {object} View
 * @property {ArmShape | null} shape Null for no arm and no ghost.
 * @property {number} status_s From one status of the arm to the next.
 * @property {Reported | null} arm The solid arm; null before the first report.
 * @property {{ kind: Tool, length_mm: number }} tool
 * @property {"off" | "armed" | "burning"} laser
 * @property {number} table_z_mm
 * @property {{ from_mm: Place, to_mm: Place } | null} paper
 * @property {Plane | null} plane The measured paper surface.
 * @property {Marks | null} marks
 * @property {readonly Thing[]} things
 * @property {Readonly<Record<string, Box | Cylinder>>} keepOuts By their names.
 * @property {Limits | null} limits
 * @property {Near} near
 * @property {readonly Point[] | null} planned The planned path of the wrist, drawn as a thin line.
 * @property {Drawing | null} drawing
 * @property {Ghost | null} ghost
 * @property {boolean} draggable Whether the arm's tool or the ghost can be dragged to move the target.
 * @property {boolean} old Whether the data is outdated: the stage is grey.
 * @property {boolean} dark Whether the theme is dark.
 * @property {string} note Text on the stage, such as its age; may be empty.
 * @property {string} label The accessible label of the stage.
 */

/** A table without an arm. @type {View} */
export const EMPTY = {
  shape: null,
  status_s: 0,
  arm: null,
  tool: { kind: "suction_cup", length_mm: 40 },
  laser: "off",
  table_z_mm: -103,
  paper: null,
  plane: null,
  marks: null,
  things: [],
  keepOuts: {},
  limits: null,
  near: { limits: [], keep_outs: {} },
  planned: null,
  drawing: null,
  ghost: null,
  draggable: false,
  old: false,
  dark: false,
  note: "",
  label: "",
};
