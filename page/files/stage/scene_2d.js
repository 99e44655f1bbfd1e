// The stage without WebGL: the arm from above and from the side, on a canvas.

import { forward, inverse, links, rad } from "./kinematics.js";
import { css, colorsOf } from "./colors.js";

/** @typedef {import("./view.js").View} View */
/** @typedef {import("./view.js").Joints} Joints */
/** @typedef {import("./view.js").Pose} Pose */
/** Draws an arm. @typedef {(joints: Joints, shape: import("./view.js").ArmShape, color: number, wide: number) => void} Draw */
/** @typedef {{ left: number, top: number, width: number, height: number }} Frame */
/** @typedef {{ frame: Frame, scale: number, to(across: number, up: number): [number, number], from(px: number, py: number): [number, number] }} Plot */

/** The visible area in mm. From above: Y to the left and X up; from the side: reach and Z. */
const ABOVE = { across: [-350, 350], up: [-245, 345] };
const SIDE = { across: [-130, 350], up: [-130, 250] };
const HANDLE_PX = 18;

/**
 * @param {HTMLElement} element
 * @param {{ changed(): void, target(pose: import("./view.js").Target): void }} outside
 */
export function createScene2d(element, outside) {
  const canvas = document.createElement("canvas");

  const pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
  /** @type {View | null} */ let view = null;
  /** @type {Joints | null} */ let drawn = null;
  let [width, height, density] = [1, 1, 1];
  /** @type {{ plot: "above" | "side", last: Pose | null } | null} */ let held = null;

  /** The two pictures: side by side, or one above the other. */
  function plots() {
    const wide = width > height;
    const [w, h] = wide ? [width / 2, height] : [width, height / 2];
    return {
      above: plot({ left: 0, top: 0, width: w, height: h }, ABOVE),
      side: plot({ left: wide ? w : 0, top: wide ? 0 : h, width: w, height: h }, SIDE),
    };
  }

  function draw() {
    if (!view) return;
    const look = colorsOf(view.dark);
    pen.setTransform(density, 0, 0, density, 0, 0);
    pen.fillStyle = css(look.background);
    pen.fillRect(0, 0, width, height);
    const { above, side } = plots();
    within(above, () => drawAbove(above, /** @type {View} */ (view)));
    within(side, () => drawSide(side, /** @type {View} */ (view)));
  }

  /** @param {Plot} plot @param {() => void} action */
  function within({ frame }, action) {
    pen.save();
    pen.beginPath();
    pen.rect(frame.left, frame.top, frame.width, frame.height);
    pen.clip();
    action();
    pen.restore();
  }

  /** @param {readonly (readonly [number, number])[]} points @param {number | string} color @param {number} wide */
  function line(points, color, wide) {
    pen.beginPath();
    for (const [x, y] of points) pen.lineTo(x, y);
    pen.strokeStyle = typeof color === "string" ? color : css(color);
    pen.lineWidth = wide;
    pen.lineCap = pen.lineJoin = "round";
    pen.stroke();
  }

  /** @param {readonly [number, number]} at @param {number} radius @param {number} color @param {boolean} [full] */
  function dot([x, y], radius, color, full = true) {
    pen.beginPath();
    pen.arc(x, y, radius, 0, 2 * Math.PI);
    pen.lineWidth = 2;
    pen.fillStyle = pen.strokeStyle = css(color);
    if (full) pen.fill();
    else pen.stroke();
  }

  /** @param {Plot} plot @param {View} now */
  function drawAbove(plot, now) {
    const look = colorsOf(now.dark), at = (/** @type {number} */ x, /** @type {number} */ y) => plot.to(-y, x);
    if (now.limits) reach(plot, now, now.limits);
    if (now.paper) {
      const [x0, y0] = at(now.paper.to_mm[0], now.paper.to_mm[1]), [x1, y1] = at(now.paper.from_mm[0], now.paper.from_mm[1]);
      pen.fillStyle = css(look.paper);
      pen.fillRect(x0, y0, x1 - x0, y1 - y0);
    }
    if (now.marks) {
      const { ends_mm: ends } = now.marks;
      pen.beginPath();
      for (let n = 0; n + 3 < ends.length; n += 4) {
        pen.moveTo(...at(ends[n] ?? 0, ends[n + 1] ?? 0));
        pen.lineTo(...at(ends[n + 2] ?? 0, ends[n + 3] ?? 0));
      }
      pen.strokeStyle = css(now.tool.kind === "laser" ? look.burn : look.ink);
      pen.lineWidth = Math.max(0.7, now.marks.width_mm * plot.scale);
      pen.stroke();
    }
    for (const thing of now.things) {
      const size = thing.shape.type === "box" ? thing.shape.size_mm : [thing.shape.diameter_mm, thing.shape.diameter_mm];
      const [x = 0, y = 0] = size, turned = rad(thing.turn_deg);
      const corners = [[1, 1], [1, -1], [-1, -1], [-1, 1]].map(([i = 0, j = 0]) => at(
        thing.at_mm[0] + (i * x * Math.cos(turned) - j * y * Math.sin(turned)) / 2, thing.at_mm[1] + (i * x * Math.sin(turned) + j * y * Math.cos(turned)) / 2));
      pen.beginPath();
      if (thing.shape.type === "cylinder") pen.arc(...at(...thing.at_mm), (x / 2) * plot.scale, 0, 2 * Math.PI);
      else for (const corner of corners) pen.lineTo(...corner);
      pen.fillStyle = thing.color;
      pen.fill();
    }
    for (const keepOut of Object.values(now.keepOuts)) {
      pen.beginPath();
      if ("box" in keepOut) {
        const { x_mm: [x0, x1], y_mm: [y0, y1] } = keepOut.box, [left, top] = at(x1, y1), [right, bottom] = at(x0, y0);
        pen.rect(left, top, right - left, bottom - top);
      } else pen.arc(...at(keepOut.cylinder.x_mm, keepOut.cylinder.y_mm), keepOut.cylinder.radius_mm * plot.scale, 0, 2 * Math.PI);
      pen.fillStyle = `${css(look.keepOut)}44`;
      pen.strokeStyle = css(look.keepOut);
      pen.lineWidth = 1;
      pen.fill();
      pen.stroke();
    }
    if (now.drawing) {
      const { ends_mm: ends, inks, colors } = now.drawing;
      // Each colour is one path; the ways between come first.
      for (let ink = -1; ink < colors.length; ink += 1) {
        pen.beginPath();
        inks.forEach((it, n) => {
          if (it !== ink) return;
          pen.moveTo(...at(ends[6 * n] ?? 0, ends[6 * n + 1] ?? 0));
          pen.lineTo(...at(ends[6 * n + 3] ?? 0, ends[6 * n + 4] ?? 0));
        });
        pen.strokeStyle = colors[ink] ?? `${css(look.planned)}55`;
        pen.lineWidth = 1;
        pen.stroke();
      }
    }
    if (now.planned) line(now.planned.map(([x, y]) => at(x, y)), look.planned, 1);
    /** @type {Draw} */
    const from = (joints, shape, color, wide) => {
      const { elbow, wrist, tool } = links(joints, shape), base = rad(joints.base_deg);
      const points = [[0, 0], elbow, wrist, tool].map(([r = 0]) => at(r * Math.cos(base), r * Math.sin(base)));
      line(points, color, wide);
      dot(/** @type {[number, number]} */ (points[0]), wide * 1.1, look.dark);
      dot(/** @type {[number, number]} */ (points[3]), wide * 0.7, look.accent);
    };
    both(now, from);
    handle(now, (pose) => at(pose.x_mm, pose.y_mm));
  }

  /** @param {Plot} plot @param {View} now */
  function drawSide(plot, now) {
    const look = colorsOf(now.dark), { left, width: w } = plot.frame;
    const [, floor] = plot.to(0, now.table_z_mm);
    line([[left, floor], [left + w, floor]], look.grid, 1);
    for (const { quantity, bound } of now.near.limits) {
      if (quantity !== "z") continue;
      const [, up] = plot.to(0, bound);
      line([[left, up], [left + w, up]], look.near, 3);
    }
    /** @type {Draw} */
    const from = (joints, shape, color, wide) => {
      const it = links(joints, shape), at = (/** @type {number[]} */ [r = 0, z = 0]) => plot.to(r, z);
      const [x, foot] = at([0, now.table_z_mm]), [, pivot] = at([0, 0]);
      pen.fillStyle = css(look.dark);
      pen.fillRect(x - wide * 1.4, pivot, wide * 2.8, foot - pivot);
      for (const rod of [it.rearRod, it.frontRod, [it.crank, it.tail], [[0, 0], it.crank]]) line(rod.map(at), look.grid, Math.max(1, wide / 4));
      line([it.rearRod[1], it.elbow, it.frontRod[0], it.rearRod[1]].map(at), look.accent, Math.max(1, wide / 4));
      line([it.wrist, it.frontRod[1]].map(at), color, wide * 0.5);
      line([it.tail, it.elbow, it.wrist].map(at), color, wide);
      line([[0, 0], it.elbow].map(at), color, wide);
      line([it.wrist, it.tool].map(at), color, wide * 0.7);
      line([it.tool, [it.tool[0], it.tool[1] - now.tool.length_mm]].map(at), look.accent, wide * 0.45);
      for (const joint of [[0, 0], it.elbow, it.wrist]) dot(at(joint), wide * 0.32, look.dark);
    };
    both(now, from);
    handle(now, (pose) => plot.to(Math.hypot(pose.x_mm, pose.y_mm), pose.z_mm - now.tool.length_mm));
  }

  /** Draws the reach of the arm. @param {Plot} plot @param {View} now @param {NonNullable<View["limits"]>} limits */
  function reach(plot, now, { joints: { base_deg: [least = 0, most = 0] }, workspace: { reach_mm: [near = 0, far = 0] } }) {
    const look = colorsOf(now.dark), [x, y] = plot.to(0, 0);
    const close = now.near.limits.some(({ quantity }) => quantity === "reach" || quantity === "base");
    pen.beginPath();
    pen.arc(x, y, far * plot.scale, rad(-90 - most), rad(-90 - least));
    pen.arc(x, y, near * plot.scale, rad(-90 - least), rad(-90 - most), true);
    pen.closePath();
    pen.fillStyle = css(look.table);
    pen.fill();
    pen.strokeStyle = css(close ? look.near : look.tableEdge);
    pen.lineWidth = close ? 3 : 1;
    pen.stroke();
  }

  /** The arm, and its ghost. @param {View} now @param {Draw} from */
  function both(now, from) {
    const { shape } = now;
    if (!shape) return;
    const look = colorsOf(now.dark), aimed = now.ghost && inverse(now.ghost, shape);
    const wide = Math.max(6, Math.min(width, height) / 38);
    if (now.arm && drawn) from(drawn, shape, look.dark === colorsOf(true).dark ? look.metal : look.pin, wide);
    if (!aimed) return;
    pen.globalAlpha = 0.45;
    from(aimed, shape, now.ghost?.refused ? look.refused : look.ghost, wide);
    pen.globalAlpha = 1;
  }

  /** @param {View} now @param {(pose: Pose) => [number, number]} at */
  function handle(now, at) {
    const pose = targetOf(now), look = colorsOf(now.dark);
    if (pose && now.draggable) dot(at(pose), HANDLE_PX / 2, now.ghost?.refused ? look.refused : look.ghost, now.ghost !== null);
  }

  /** @param {View} now @returns {Pose | null} */
  function targetOf(now) {
    return now.ghost ?? (now.arm && drawn && now.shape ? forward(drawn, now.shape) : null);
  }

  /** @param {PointerEvent} event */
  const place = ({ offsetX, offsetY }) => ({ x: offsetX, y: offsetY });

  /** @param {PointerEvent} event */
  function down(event) {
    const pose = view?.draggable ? targetOf(view) : null;
    if (!pose || !view) return;
    const { above, side } = plots(), { x, y } = place(event);
    const [ax, ay] = above.to(-pose.y_mm, pose.x_mm), [sx, sy] = side.to(Math.hypot(pose.x_mm, pose.y_mm), pose.z_mm - view.tool.length_mm);
    const plot = Math.hypot(ax - x, ay - y) < HANDLE_PX ? "above" : Math.hypot(sx - x, sy - y) < HANDLE_PX ? "side" : null;
    if (!plot) return;
    canvas.setPointerCapture(event.pointerId);
    held = { plot, last: pose };
  }

  /** @param {PointerEvent} event */
  function move(event) {
    if (!held?.last || !view) return;
    const { x, y } = place(event), [across, up] = plots()[held.plot].from(x, y), pose = held.last;
    const round = (/** @type {number} */ value) => Math.round(value * 10) / 10;
    if (held.plot === "above") held.last = { ...pose, x_mm: round(up), y_mm: round(-across) };
    else {
      const direction = Math.atan2(pose.y_mm, pose.x_mm);
      held.last = { ...pose, x_mm: round(across * Math.cos(direction)), y_mm: round(across * Math.sin(direction)), z_mm: round(up + view.tool.length_mm) };
    }
    outside.target({ ...held.last, phase: "drag" });
  }

  function up() {
    if (held?.last) outside.target({ ...held.last, phase: "drop" });
    held = null;
  }

  canvas.addEventListener("pointerdown", down);
  canvas.addEventListener("pointermove", move);
  canvas.addEventListener("pointerup", up);
  canvas.addEventListener("pointercancel", up);

  return {
    kind: /** @type {const} */ ("2d"),
    canvas,
    /** @param {View} next */
    show(next) {
      view = next;
      outside.changed();
    },
    /** @param {Joints | null} joints */
    frame(joints) {
      drawn = joints ?? drawn;
      draw();
      return { rendered: true, again: false };
    },
    /** @param {number} newWidth @param {number} newHeight @param {number} newDensity */
    resize(newWidth, newHeight, newDensity) {
      [width, height, density] = [newWidth, newHeight, newDensity];
      canvas.width = Math.round(width * density);
      canvas.height = Math.round(height * density);
    },
    end: () => canvas.remove(),
  };
}

/** @param {Frame} frame @param {{ across: number[], up: number[] }} room @returns {Plot} */
function plot(frame, { across: [a0 = 0, a1 = 0], up: [u0 = 0, u1 = 0] }) {
  const scale = Math.min(frame.width / (a1 - a0), frame.height / (u1 - u0)) * 0.94;
  const [cx, cy] = [frame.left + frame.width / 2, frame.top + frame.height / 2], [am, um] = [(a0 + a1) / 2, (u0 + u1) / 2];
  return {
    frame,
    scale,
    to: (across, up) => [cx + (across - am) * scale, cy - (up - um) * scale],
    from: (px, py) => [am + (px - cx) / scale, um - (py - cy) / scale],
  };
}
