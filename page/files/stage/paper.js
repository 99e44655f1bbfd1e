// The table, the paper on it, and the lines of ink or burn: one buffer that grows.

import {
  BufferAttribute, DynamicDrawUsage, GLSL3, Group, InstancedBufferAttribute, InstancedBufferGeometry, Mesh, MeshLambertMaterial, PlaneGeometry, ShaderMaterial,
} from "../vendor/three/three.js";
import { block } from "./solid.js";

/** @typedef {import("./look.js").Look} Look */
/** @typedef {import("./view.js").View} View */
/** @typedef {import("./view.js").Marks} Marks */

/** How far the table goes, in mm: from, to. */
const TABLE = { x: [-300, 460], y: [-390, 390] };
const THICK_MM = 16;
const FIRST_ROOM = 4096;

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

/** All lines on the paper in one draw call, as wide as they are, and never thinner than a pixel. */
export function createMarks() {
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0]), 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  const uniforms = { width: { value: 0.5 }, pixel: { value: 0.001 }, color: { value: [0, 0, 0] } };
  const material = new ShaderMaterial({
    transparent: true, depthWrite: false, polygonOffset: true, polygonOffsetFactor: -3, polygonOffsetUnits: -6, side: 2,
    uniforms, glslVersion: GLSL3, vertexShader: MARK_VERTEX, fragmentShader: MARK_FRAGMENT,
  });
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  mesh.position.z = 0.4;
  mesh.renderOrder = 1;
  /** @type {Marks | null} */ let shown = null;
  let count = 0;
  let ends = room(0, 4), shades = room(0, 1);

  /**
   * Takes what was added since the last time, or all where they are others.
   * @param {Marks | null} marks
   * @returns {boolean} whether anything is new
   */
  function show(marks) {
    const before = count;
    const same = marks === shown;
    if (!same) count = 0;
    shown = marks;
    const wanted = marks ? marks.shades.length : 0;
    if (marks && wanted > shades.array.length) [ends, shades] = [grown(ends, wanted), grown(shades, wanted)];
    if (marks && wanted > count) {
      fill(ends, marks.ends_mm, count * 4);
      fill(shades, marks.shades, count);
      uniforms.width.value = marks.width_mm;
    }
    count = wanted;
    geometry.instanceCount = count;
    mesh.visible = count > 0;
    return !same || count !== before;
  }

  /** @param {InstancedBufferAttribute} attribute @param {number} wanted */
  function grown(attribute, wanted) {
    const larger = room(Math.max(FIRST_ROOM, 2 ** Math.ceil(Math.log2(wanted))), attribute.itemSize);
    larger.array.set(attribute.array);
    // The old buffers go, the card's too; the quad stays.
    geometry.dispose();
    geometry.setAttribute(attribute.itemSize === 4 ? "ends" : "shade", larger);
    return larger;
  }

  return {
    group: mesh,
    show,
    /** @param {Look} look @param {boolean} burnt */
    paint(look, burnt) {
      uniforms.color.value = rgb(burnt ? look.burn : look.ink);
    },
    /** How many mm a pixel is wide, one mm away from the camera. @param {number} mm */
    sharpen(mm) {
      uniforms.pixel.value = mm;
    },
  };
}

/** @param {number} count @param {number} size */
function room(count, size) {
  return new InstancedBufferAttribute(new Float32Array(count * size), size).setUsage(DynamicDrawUsage);
}

/**
 * Writes what is behind a place, and says that only this is new.
 * @param {InstancedBufferAttribute} attribute
 * @param {readonly number[]} numbers
 * @param {number} from
 */
function fill(attribute, numbers, from) {
  for (let n = from; n < numbers.length; n += 1) attribute.array[n] = numbers[n] ?? 0;
  attribute.addUpdateRange(from, numbers.length - from);
  attribute.needsUpdate = true;
}

/** @param {number} hex */
const rgb = (hex) => [(hex >> 16) & 255, (hex >> 8) & 255, hex & 255].map((it) => it / 255);

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

const MARK_VERTEX = `
uniform float width;
uniform float pixel;
in vec4 ends;
in float shade;
out float dark;
void main() {
  vec2 way = ends.zw - ends.xy;
  float far = length(way);
  vec2 along = far > 0.0 ? way / far : vec2(1.0, 0.0);
  vec4 middle = modelViewMatrix * vec4(mix(ends.xy, ends.zw, position.x), 0.0, 1.0);
  float least = 0.6 * pixel * -middle.z;
  float half_mm = max(width * 0.5, least);
  dark = shade * min(1.0, width * 0.5 / least + 0.35);
  vec2 place = mix(ends.xy, ends.zw, position.x);
  place += along * (position.x * 2.0 - 1.0) * half_mm + vec2(-along.y, along.x) * position.y * half_mm;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(place, 0.0, 1.0);
}`;

const MARK_FRAGMENT = `
uniform vec3 color;
in float dark;
out vec4 painted;
void main() {
  painted = vec4(color, dark);
}`;
