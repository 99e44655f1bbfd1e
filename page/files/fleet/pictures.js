// Draws the pictures of all visible tiles, each when its arm, size or theme changed.

import { Motion } from "../stage/motion.js";
import { createLimit } from "../stage/render_quality.js";
import { paint } from "./picture.js";

/** @typedef {import("./members.js").Member} Member */
/** @typedef {import("./picture.js").Size} Size */
/** What a picture was drawn from. @typedef {{ size: Size, drawn: string }} Canvas */

/** @param {{ isStill: () => boolean }} outside whether a person wants nothing to glide */
export function createPictures({ isStill }) {
  /** @type {Map<string, Motion>} */ const motions = new Map();
  /** @type {WeakMap<Element, Canvas>} */ const canvases = new WeakMap();
  /** @type {Set<HTMLCanvasElement>} */ const inSight = new Set();
  /** @type {{ members: ReadonlyMap<string, Member>, facts: import("./picture.js").Facts | null, dark: boolean, old: boolean }} */ let shown = { members: new Map(), facts: null, dark: false, old: false };
  const isDue = createLimit();
  let frame = 0;

  const sight = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) {
      if (isIntersecting) inSight.add(/** @type {HTMLCanvasElement} */ (target));
      else inSight.delete(/** @type {HTMLCanvasElement} */ (target));
    }
    soon();
  });
  const sizes = new ResizeObserver((entries) => {
    for (const { target } of entries) canvases.delete(target);
    soon();
  });

  const soon = () => (frame ||= requestAnimationFrame(draw));

  /** @param {number} now_ms */
  function draw(now_ms) {
    frame = 0;
    if (!isDue(now_ms)) return soon();
    let moving = false;
    for (const canvas of inSight) {
      if (!canvas.isConnected) forget(canvas);
      else moving = drawOne(canvas) || moving;
    }
    if (moving) soon();
  }

  /** @param {HTMLCanvasElement} canvas */
  function forget(canvas) {
    inSight.delete(canvas);
    sight.unobserve(canvas);
    sizes.unobserve(canvas);
  }

  /** @param {HTMLCanvasElement} canvas @returns {boolean} whether it is another one a moment later */
  function drawOne(canvas) {
    const member = shown.members.get(canvas.dataset.arm ?? ""), { facts } = shown;
    if (!member || !facts) return false;
    const known = canvases.get(canvas) ?? { size: fit(canvas), drawn: "" };
    canvases.set(canvas, known);
    const { joints, moving } = jointsOf(member);
    const old = shown.old || member.presence.type !== "present";
    const laser = member.state?.laser.on ? "burning" : "off";
    const drawn = [joints?.base_deg, joints?.rear_deg, joints?.fore_deg, shown.dark, old, laser].join();
    if (drawn !== known.drawn) paint(/** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d")), { facts, joints, dark: shown.dark, old, laser, size: known.size });
    known.drawn = drawn;
    return moving;
  }

  /** @param {Member} member */
  function jointsOf({ id, state }) {
    const arm = state?.arm ?? null;
    if (!arm || isStill()) return { joints: arm, moving: false };
    return motions.get(id)?.at(performance.now() / 1000) ?? { joints: arm, moving: false };
  }

  return {
    /** @param {readonly Member[]} members @param {import("./picture.js").Facts | null} facts nothing is drawn without @param {{ dark: boolean, old: boolean }} look */
    show(members, facts, { dark, old }) {
      shown = { members: new Map(members.map((member) => [member.id, member])), facts, dark, old };
      for (const { id, state } of members) {
        if (!state?.arm) continue;
        const motion = motions.get(id) ?? new Motion();
        motions.set(id, motion);
        motion.status_s = facts?.status_period_s ?? 0;
        motion.add({ at_s: state.at_s, joints: state.arm }, performance.now() / 1000);
      }
      soon();
    },
    /** Takes the canvases that a view has made. @param {ParentNode} root */
    take(root) {
      for (const canvas of root.querySelectorAll("canvas[data-arm]")) {
        sight.observe(canvas);
        sizes.observe(canvas);
      }
    },
  };
}

/** Sets the canvas to the resolution of the screen. @param {HTMLCanvasElement} canvas @returns {Size} */
function fit(canvas) {
  const { clientWidth: width, clientHeight: height } = canvas, density = Math.min(2, devicePixelRatio);
  canvas.width = Math.round(width * density);
  canvas.height = Math.round(height * density);
  return { width, height, density };
}
