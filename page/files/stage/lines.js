// Thin lines: the trail of the tool, and planned paths.

import { BufferAttribute, BufferGeometry, Color, Line, LineBasicMaterial, LineSegments, Vector3 } from "../vendor/three/three.js";

/** @typedef {import("./colors.js").Look} Look */
/** @typedef {import("./view.js").Point} Point */
/** @typedef {import("./view.js").Drawing} Drawing */

const KEPT = 400;
const STEP_MM = 1.5;

/** The trail of the tip, fading with age. */
export function createTrail() {
  const places = new BufferAttribute(new Float32Array(KEPT * 3), 3);
  const colors = new BufferAttribute(new Float32Array(KEPT * 4), 4);
  const geometry = new BufferGeometry().setAttribute("position", places).setAttribute("color", colors);
  const line = new Line(geometry, new LineBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false }));
  line.frustumCulled = false;
  line.renderOrder = 2;
  /** @type {Vector3[]} */ let points = [];
  const color = { r: 0, g: 0, b: 0 };

  function write() {
    points.forEach((point, n) => {
      places.setXYZ(n, point.x, point.y, point.z);
      colors.setXYZW(n, color.r, color.g, color.b, 0.7 * ((n + 1) / points.length) ** 1.5);
    });
    places.needsUpdate = colors.needsUpdate = true;
    geometry.setDrawRange(0, points.length);
  }

  return {
    group: line,
    /** @param {Vector3} tip */
    follow(tip) {
      const last = points.at(-1);
      if (last && last.distanceTo(tip) < STEP_MM) return;
      // A jump is another arm, or a restarted one.
      if (last && last.distanceTo(tip) > 80) points = [];
      points.push(tip.clone());
      if (points.length > KEPT) points.shift();
      write();
    },
    /** @param {Look} look */
    paint(look) {
      Object.assign(color, { r: ((look.trail >> 16) & 255) / 255, g: ((look.trail >> 8) & 255) / 255, b: (look.trail & 255) / 255 });
      write();
    },
  };
}

/** A drawing that is planned, of the tip: ink in its colours, ways between in that of plans. */
export function createDrawing() {
  // Seen through whatever lies above it: what is to come must not hide.
  const material = new LineBasicMaterial({ vertexColors: true, transparent: true, depthTest: false, depthWrite: false });
  const lines = new LineSegments(new BufferGeometry(), material);
  lines.frustumCulled = false;
  lines.renderOrder = 3;
  return {
    group: lines,
    /** @param {Drawing | null} drawing of the wrist @param {number} length_mm of the tool @param {Look} look */
    show(drawing, length_mm, look) {
      lines.geometry.dispose();
      lines.geometry = new BufferGeometry();
      lines.visible = drawing !== null;
      if (!drawing) return;
      const { ends_mm, inks } = drawing;
      const palette = drawing.colors.map((color) => new Color(color));
      const way = new Color(look.planned);
      const colors = new Float32Array(inks.length * 8);
      inks.forEach((ink, n) => {
        const { r, g, b } = palette[ink] ?? way;
        const alpha = ink < 0 ? WAY : 1;
        colors.set([r, g, b, alpha, r, g, b, alpha], n * 8);
      });
      lines.geometry.setAttribute("position", new BufferAttribute(ends_mm, 3)).setAttribute("color", new BufferAttribute(colors, 4));
      lines.position.z = ABOVE_MM - length_mm;
    },
  };
}

/** Opacity of travel moves; height of planned ink above the paper. */
const WAY = 0.35;
const ABOVE_MM = 1.5;

/** The planned path of the tip. */
export function createPlanned() {
  const material = new LineBasicMaterial({ transparent: true, opacity: 0.9, depthWrite: false });
  const line = new Line(new BufferGeometry(), material);
  line.frustumCulled = false;
  line.renderOrder = 3;
  return {
    group: line,
    /** @param {readonly Point[] | null} path of the wrist @param {number} length_mm of the tool */
    show(path, length_mm) {
      line.geometry.dispose();
      line.geometry = new BufferGeometry().setFromPoints((path ?? []).map(([x, y, z]) => new Vector3(x, y, z - length_mm)));
      line.visible = path !== null && path.length > 1;
    },
    /** @param {Look} look */
    paint: (look) => material.color.set(look.planned),
  };
}
