// The table, and the paper on it.

import { Group, Mesh, MeshLambertMaterial, PlaneGeometry, ShaderMaterial } from "../vendor/three/three.js";
import { block } from "./solid.js";

/** @typedef {import("./look.js").Look} Look */
/** @typedef {import("./view.js").View} View */

/** How far the table goes, in mm: from, to. */
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

/** Red, green and blue, from 0 to 1. @param {number} hex */
export const rgb = (hex) => /** @type {[number, number, number]} */ ([(hex >> 16) & 255, (hex >> 8) & 255, hex & 255].map((it) => it / 255));

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
