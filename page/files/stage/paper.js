// The table, and the paper on it.

import { BufferAttribute, BufferGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial, MeshLambertMaterial, PlaneGeometry, ShaderMaterial, SphereGeometry } from "../vendor/three/three.js";
import { block } from "./solid.js";

/** @typedef {import("./colors.js").Look} Look */
/** @typedef {import("./view.js").View} View */

/** Extent of the table in mm: from, to. */
const TABLE = { x: [-300, 460], y: [-390, 390] };
const THICK_MM = 16;

/** A table with lines each 10 mm, and stronger ones each 100 mm. */
export function createTable() {
  const group = new Group();
  const [x0 = 0, x1 = 0] = TABLE.x, [y0 = 0, y1 = 0] = TABLE.y;
  const top = new MeshLambertMaterial();
  const slab = new Mesh(block([x1 - x0, y1 - y0, THICK_MM], [(x0 + x1) / 2, (y0 + y1) / 2, -THICK_MM / 2], 46), top);
  slab.receiveShadow = true;
  const grid = new ShaderMaterial({
    transparent: true, depthWrite: false, polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -2,
    uniforms: { color: { value: [0, 0, 0] } }, vertexShader: GRID_VERTEX, fragmentShader: GRID_FRAGMENT,
  });
  const lines = new Mesh(new PlaneGeometry(x1 - x0 - 12, y1 - y0 - 12).translate((x0 + x1) / 2, (y0 + y1) / 2, 0.15), grid);
  group.add(slab, lines);
  return {
    group,
    /** @param {Look} look */
    paint(look) {
      top.color.set(look.table);
      /** @type {{ value: unknown }} */ (grid.uniforms.color).value = rgb(look.grid);
    },
  };
}

/** The sheet. Its shade is that of the table. */
export function createPaper() {
  const material = new MeshLambertMaterial({ polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -4 });
  const sheet = new Mesh(new PlaneGeometry(1, 1), material);
  sheet.receiveShadow = true;
  sheet.position.z = 0.3;
  return {
    group: sheet,
    /** @param {View["paper"]} paper */
    show(paper) {
      sheet.visible = paper !== null;
      if (!paper) return;
      const [x0, y0] = paper.from_mm, [x1, y1] = paper.to_mm;
      sheet.position.set((x0 + x1) / 2, (y0 + y1) / 2, 0.3);
      sheet.scale.set(x1 - x0, y1 - y0, 1);
    },
    /** @param {Look} look */
    paint: (look) => material.color.set(look.paper),
  };
}

/** Extent of the shown plane, in mm. */
const PLANE = { x_mm: [140, 290], y_mm: [-110, 110] };

/** The measured paper surface: a pane, and a pin at each recorded point. */
export function createPlane() {
  const group = new Group();
  const glass = new MeshBasicMaterial({ transparent: true, opacity: 0.28, side: DoubleSide, depthWrite: false });
  const pins = new MeshBasicMaterial();
  const ball = new SphereGeometry(2.4, 16, 12);
  const pane = new Mesh(new BufferGeometry(), glass);
  pane.renderOrder = 2;
  return {
    group,
    /** @param {View["plane"]} plane @param {number} length_mm of the tool */
    show(plane, length_mm) {
      group.clear();
      if (!plane) return;
      for (const [x, y, z] of plane.touches) {
        const pin = new Mesh(ball, pins);
        pin.position.set(x, y, z - length_mm);
        group.add(pin);
      }
      if (!Number.isFinite(plane.z_mm)) return;
      const corners = PLANE.x_mm.flatMap((x) => PLANE.y_mm.map((y) => [x, y, plane.z_mm + plane.slope_x * x + plane.slope_y * y - length_mm + 0.6]));
      pane.geometry.dispose();
      pane.geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(new Float32Array(corners.flat()), 3)).setIndex([0, 2, 1, 1, 2, 3]);
      group.add(pane);
    },
    /** @param {Look} look */
    paint(look) {
      glass.color.set(look.ghost);
      pins.color.set(look.ghost);
    },
  };
}

/** Red, green and blue, from 0 to 1. @param {number} hex */
export const rgb = (hex) => /** @type {[number, number, number]} */ ([(hex >> 16) & 255, (hex >> 8) & 255, hex & 255].map((channel) => channel / 255));

const GRID_VERTEX = `
varying vec2 at;
void main() {
  at = position.xy;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

// Thin lines fade where they come nearer to each other than a few pixels.
const GRID_FRAGMENT = `
uniform vec3 color;
varying vec2 at;
float lines(float each) {
  vec2 scaled = at / each;
  vec2 wide = fwidth(scaled);
  vec2 off = abs(fract(scaled - 0.5) - 0.5) / wide;
  vec2 line = (1.0 - smoothstep(0.0, 1.1, off)) * (1.0 - smoothstep(0.06, 0.3, wide));
  return max(line.x, line.y);
}
void main() {
  float strength = max(lines(10.0) * 0.16, lines(100.0) * 0.42);
  gl_FragColor = vec4(color, strength);
}`;
