// The target: typed or dragged, checked by the station, approached with Go.

/** @typedef {import("./types.js").Problem} Problem */
/** @typedef {import("./types.js").Arm} Arm */
/** @typedef {import("./types.js").Station} Station */
/** @typedef {"movj" | "movl" | "jump"} Path */
/** A path of a target, or one line of a pen or laser (state 4). @typedef {Path | "vector"} TargetPath */
/** @typedef {"x_mm" | "y_mm" | "z_mm" | "rotation_deg"} Field */

/** @type {readonly Field[]} */
export const FIELDS = ["x_mm", "y_mm", "z_mm", "rotation_deg"];

/**
 * The station's check of the path: not checked, free with its duration, or refused.
 * @typedef {{ type: "unknown" } | { type: "free", takes_s: number | null } | { type: "refused", problem: Problem }} Check
 */

/**
 * @typedef {object} Target
 * @property {Record<Field, string> | null} typed The text of the fields; null without a target.
 * @property {TargetPath} path
 * @property {string} speed The text of a line's speed, in mm/s.
 * @property {boolean} burns Whether a line is burned with the laser.
 * @property {number} revision Revision of the target; results for earlier revisions are ignored.
 * @property {Check} check
 * @property {boolean} refused Whether the ghost is drawn as refused; kept during a new check, so that it does not flicker.
 * @property {boolean} goes Whether the arm is moving there.
 */

/** @type {Target} */
export const NO_TARGET = { typed: null, path: "movj", speed: "20", burns: false, revision: 0, check: { type: "unknown" }, refused: false, goes: false };

/** @typedef {{ type: "target_typed", field: Field, text: string }
 * | { type: "target_placed", place: Partial<Record<Field, number>> }
 * | { type: "target_path", path: TargetPath }
 * | { type: "target_speed", text: string }
 * | { type: "target_burns", burns: boolean }
 * | { type: "target_checked", revision: number, check: Check }
 * | { type: "target_goes" }
 * | { type: "target_cleared" }} TargetMessage */

/** The place that the fields hold, or nothing while one of them holds no number. @param {Target} target @returns {Record<Field, number> | null} */
export function placeOf({ typed }) {
  if (!typed) return null;
  const numbers = FIELDS.map((name) => (typed[name].trim() === "" ? NaN : Number(typed[name])));
  if (!numbers.every(Number.isFinite)) return null;
  return /** @type {Record<Field, number>} */ (Object.fromEntries(FIELDS.map((name, n) => [name, numbers[n]])));
}

/** The line to the target; nothing without a number or a speed above 0. @param {Target} target @param {Arm} arm */
export function lineOf(target, arm) {
  const place = placeOf(target), max_speed_mm_s = Number(target.speed);
  if (!place || !(max_speed_mm_s > 0)) return null;
  const [x_mm, y_mm, z_mm] = [place.x_mm - arm.x_mm, place.y_mm - arm.y_mm, place.z_mm - arm.z_mm];
  return { x_mm, y_mm, z_mm, max_speed_mm_s };
}

/** The arm's position as fields. @param {Arm | null} arm @returns {Record<Field, string>} */
const fieldsOf = (arm) => /** @type {Record<Field, string>} */ (Object.fromEntries(FIELDS.map((name) => [name, arm ? arm[name].toFixed(1) : ""])));

/** @param {Target} target @param {Partial<Target>} change @returns {Target} */
const changed = (target, change) => ({ ...target, ...change, revision: target.revision + 1, check: { type: "unknown" }, goes: false });

/** @param {Target} target @returns {Target} */
const cleared = ({ path, speed, revision }) => ({ ...NO_TARGET, path, speed, revision: revision + 1 });

/**
 * @param {Target} target
 * @param {import("./message.js").Message} message
 * @param {Station | null} before the station before the message
 * @param {Station | null} now the station after the message
 * @returns {Target}
 */
export function reduceTarget(target, message, before, now) {
  const arm = now?.arm ?? null;
  switch (message.type) {
    case "target_typed":
      // Empty fields keep the arm's position.
      return changed(target, { typed: { ...(target.typed ?? fieldsOf(arm)), [message.field]: message.text } });
    case "target_placed": {
      const place = Object.fromEntries(Object.entries(message.place).map(([name, value]) => [name, value.toFixed(1)]));
      return changed(target, { typed: { ...(target.typed ?? fieldsOf(arm)), ...place } });
    }
    case "target_path":
      return changed(target, { path: message.path });
    case "target_speed":
      return changed(target, { speed: message.text });
    case "target_burns":
      return changed(target, { burns: message.burns });
    case "target_checked":
      if (message.revision !== target.revision) return target;
      return { ...target, check: message.check, refused: message.check.type === "refused" };
    case "target_goes":
      return { ...target, goes: true };
    case "target_cleared":
      return cleared(target);
    case "hello":
      // Earlier requests were never answered.
      return target.typed ? changed(target, {}) : target;
    case "state":
      if (target.goes) return arm && isAt(target, arm) ? cleared(target) : target;
      return target.typed && groundOf(before) !== groundOf(now) ? changed(target, {}) : target;
    case "notice":
      // A new policy can change the result.
      return target.typed && !target.goes && message.notice.type === "policy_changed" ? changed(target, {}) : target;
    default:
      return target;
  }
}

/** What the check depends on besides the target and the policy. @param {Station | null} station */
const groundOf = (station) => JSON.stringify(station && [station.link.phase, station.arm !== null, station.trust.trusted, station.dialect]);

/** Whether the arm has arrived at the target. @param {Target} target @param {Arm} arm */
function isAt(target, arm) {
  const place = placeOf(target);
  if (!place) return false;
  const off_mm = Math.hypot(arm.x_mm - place.x_mm, arm.y_mm - place.y_mm, arm.z_mm - place.z_mm);
  return off_mm < 0.3 && (target.path === "vector" || Math.abs(arm.rotation_deg - place.rotation_deg) < 0.5);
}
