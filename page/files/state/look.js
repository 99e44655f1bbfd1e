// What the camera sees, and what a person does with it. Nothing moves without a person's click, or a program that asks.

import { heightOfMarker, inPicture, onSheet, placeOfMarker } from "../vision/geometry.js";
import { paperOf } from "./paper.js";
import { blockedReason, mountedTool, rests } from "./selectors.js";

/** @typedef {import("./state.js").Page} Page */
/** @typedef {import("../vision/look.js").Seen} Seen */
/** @typedef {import("../vision/geometry.js").Place} Place */
/** An object that is seen: one with a marker, or a blob of the chosen colour. Its height is unknown until a person gives it, or accepts the one measured by the size of its marker. @typedef {Place & { name: string, marker: number | null, height_mm: number | null, measured_mm: number | null }} Thing */
/** Why nothing can be done with the picture: the end of a text key. @typedef {"no_picture" | "few_corners" | "blurred" | "sheet_moved"} UnseenReason */

/** The height above what it goes to, before a person sends the tool down. */
export const ABOVE_MM = 25;
/** The side of the markers that `dobot markers` prints, if not asked for another one. */
export const MARKER_MM = 20;
/** The hues that can be looked for, in degrees. */
export const HUES = /** @type {const} */ ({ red: 0, yellow: 55, green: 130, blue: 225 });

/**
 * @typedef {object} Look
 * @property {"off" | "asking" | "on"} camera
 * @property {string | null} refused Why there is no camera: the end of a text key, or the browser's words.
 * @property {readonly { id: string, label: string }[]} cameras
 * @property {string} chosen The camera; empty for any.
 * @property {keyof typeof HUES | ""} hue
 * @property {Seen | null} seen
 * @property {number} rate Pictures a second.
 * @property {Readonly<Record<string, number>>} heights The heights of objects by name, in mm.
 * @property {string | null} selected The name of the selected object.
 * @property {number} surface_mm The height above the sheet of what a person clicks on, such as a tray.
 * @property {{ x_mm: number, y_mm: number } | null} spot Where a person clicked.
 * @property {boolean} is_above Whether the tool was sent above the spot.
 * @property {boolean} is_sent Whether the tool was sent somewhere, and no state of the station shows it yet.
 * @property {string | null} held The object that was picked up.
 * @property {boolean} answers Whether a running program that asks where a marker is gets the answer.
 */

/** @type {Look} */
export const NO_LOOK = { camera: "off", refused: null, cameras: [], chosen: "", hue: "", seen: null, rate: 0, heights: {}, selected: null, surface_mm: 0, spot: null, is_above: false, is_sent: false, held: null, answers: false };

/** @typedef {{ type: "look_camera", camera: Look["camera"], refused?: string | null }
 * | { type: "look_cameras", cameras: Look["cameras"] }
 * | { type: "look_seen", seen: Seen, rate: number }
 * | { type: "look_set", set: Partial<Pick<Look, "chosen" | "hue" | "selected" | "spot" | "is_above" | "is_sent" | "held" | "answers">> }
 * | { type: "look_surface", surface_mm: number }
 * | { type: "look_height", name: string, height_mm: number }} LookMessage */

/** @param {Look} look @param {import("./message.js").Message} message @returns {Look} */
export function reduceLook(look, message) {
  switch (message.type) {
    case "look_camera":
      return { ...look, camera: message.camera, refused: message.refused ?? null, seen: null, ...(message.camera === "off" && { answers: false, spot: null, is_above: false, selected: null }) };
    case "look_cameras":
      return { ...look, cameras: message.cameras };
    case "look_seen":
      return look.camera === "on" ? { ...look, seen: message.seen, rate: message.rate } : look;
    case "look_set":
      return { ...look, ...message.set };
    case "look_surface":
      // At another height the pixel that was clicked shows another place.
      return { ...look, surface_mm: message.surface_mm, spot: null, is_above: false };
    case "look_height":
      return { ...look, heights: { ...look.heights, [message.name]: message.height_mm } };
    default:
      return look;
  }
}

/** Why the picture cannot be used. @param {Look} look @returns {UnseenReason | null} */
export function unseenReason({ seen }) {
  if (!seen) return "no_picture";
  for (const reason of /** @type {const} */ (["few_corners", "sheet_moved", "blurred"])) if (seen.troubles.includes(reason)) return reason;
  return null;
}

/** The objects of the picture, in the arm's frame. @param {Look} look @returns {Thing[]} */
export function thingsOf({ seen, heights, hue }) {
  if (!seen?.view) return [];
  const { view, markers, blob } = seen;
  const known = (/** @type {string} */ name) => heights[name] ?? null;
  /** @type {Thing[]} */
  const things = markers.filter(({ id }) => id > 3).map((marker) => {
    const name = `marker ${marker.id}`;
    return { name, marker: marker.id, height_mm: known(name), measured_mm: heightOfMarker(view, marker, MARKER_MM), ...placeOfMarker(view, marker, known(name) ?? 0) };
  });
  if (blob && hue) {
    const [x_mm, y_mm] = onSheet(view, blob, known(hue) ?? 0);
    things.push({ name: hue, marker: null, height_mm: known(hue), measured_mm: null, x_mm, y_mm, turn_deg: 0 });
  }
  return things.sort((a, b) => (a.name < b.name ? -1 : 1));
}

/** The height of the wrist with the tool's tip on the paper, in mm; null if it was not measured. @param {Page} page @param {{ x_mm: number, y_mm: number }} place */
export function paperHeight(page, { x_mm, y_mm }) {
  const { paper } = page.draw;
  if (paper) return paper.z_mm + paper.slope_x * x_mm + paper.slope_y * y_mm;
  return page.around ? paperOf(page) : null;
}

/** The pixel of the spot. @param {Look} look */
export const spotInPicture = ({ seen, spot, surface_mm }) => (seen?.view && spot ? inPicture(seen.view, [spot.x_mm, spot.y_mm], surface_mm) : null);

/** Why the arm cannot be sent where the camera looks: a text key. @param {Page} page */
export function lookBlockedReason(page) {
  const unseen = unseenReason(page.look), blocked = blockedReason(page);
  if (unseen) return /** @type {const} */ (`look.${unseen}`);
  if (blocked) return /** @type {const} */ (`blocked.${blocked}`);
  return page.draw.paper || page.around ? null : /** @type {const} */ ("look.no_paper");
}

/** Why nothing can be picked up or put down: a text key. Both are jobs, which start only with the arm at rest. @param {Page} page */
export function transferBlockedReason(page) {
  const { look, station } = page;
  return lookBlockedReason(page) ?? (station && rests(station) && !look.is_sent ? null : /** @type {const} */ ("blocked.moving"));
}

/** Whether the arm can pick things up. @param {Page} page */
export const hasCup = (page) => mountedTool(page) === "suction_cup";

/** What a running program asks for: the object with this marker, if it is seen and its height is known. @param {Page} page @returns {Thing | null} */
export function askedThing({ look, station }) {
  const question = station?.job?.question;
  if (question?.asks !== "place" || unseenReason(look)) return null;
  return thingsOf(look).find(({ name, height_mm }) => name === question.name && height_mm !== null) ?? null;
}
