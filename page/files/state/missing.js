// What is missing before a drawing can start. Pure.

import { blockedReason, isVirtual, mountedTool } from "./selectors.js";

/** @typedef {import("./state.js").Page} Page */
/** @typedef {import("./selectors.js").BlockedReason} BlockedReason */
/** A condition of the drawing itself. @typedef {"laser-disarmed" | "not-laser" | "no-pen" | "no-height"} Condition */
/** @typedef {BlockedReason | Condition} Missing */

/** Whether a drawing can start without it: the page cannot see what is at the arm, and a job sets the tool that it needs. @type {Readonly<Record<Condition, boolean>>} */
const OPTIONAL = { "laser-disarmed": false, "not-laser": true, "no-pen": true, "no-height": true };

/** Whether it blocks every motion, not only a drawing. @param {Missing} missing @returns {missing is BlockedReason} */
export const isReason = (missing) => !(missing in OPTIONAL);

/** @param {Missing} missing */
export const isBlocking = (missing) => isReason(missing) || !OPTIONAL[missing];

/** In the order in which it is solved. @param {Page} page @returns {Missing[]} */
export function missingFor(page) {
  const { draw, station } = page;
  const why = blockedReason(page);
  const tool = mountedTool(page), virtual = isVirtual(page);
  const checks = draw.planned?.plan.burns ? burning() : drawing();
  return [...(why ? [why] : []), ...checks.flatMap(([isMissing, kind]) => (isMissing ? [kind] : []))];

  /** @returns {[boolean, Missing][]} */
  function burning() {
    return [[!virtual && tool !== "laser", "not-laser"], [station?.laser.armed_for_s === 0, "laser-disarmed"]];
  }

  /** @returns {[boolean, Missing][]} */
  function drawing() {
    return [[virtual && page.around !== null && tool !== "pen", "no-pen"], [!virtual && draw.paper === null && draw.set.down.trim() === "", "no-height"]];
  }
}
