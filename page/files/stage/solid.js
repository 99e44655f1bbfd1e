// Solids for the stage: plates, boxes and turned parts, joined to a few meshes, one for each material.
//
// Parts are given in mm in the frame of their link: X along the link, Y to the left, Z up.

import {
  BoxGeometry, BufferAttribute, BufferGeometry, CylinderGeometry, ExtrudeGeometry, Group, LatheGeometry, Mesh, Path, Shape, Vector2,
} from "../vendor/three/three.js";

/** @typedef {import("../vendor/three/three.js").Material} Material */
/** @typedef {import("./view.js").Point} Point */
/** @typedef {readonly [number, number, number]} Circle Middle and radius, in the plane of a plate. */

const BEVEL_MM = 0.9;
const BEVEL = { bevelEnabled: true, bevelThickness: BEVEL_MM, bevelSize: BEVEL_MM, bevelOffset: -BEVEL_MM, bevelSegments: 1, curveSegments: 9 };

/**
 * A plate that stands along a link, in the X Z plane: the hull of some circles, with a hole in those of them that are bored.
 * @param {readonly Circle[]} circles counter-clockwise, seen from the right
 * @param {number} y_mm the middle of its thickness
 * @param {number} thick_mm
 * @param {readonly Circle[]} [holes]
 */
export function plate(circles, y_mm, thick_mm, holes = []) {
  const shape = hull(circles);
  shape.holes = holes.map(([x, z, radius]) => new Path().absarc(x, z, radius, 0, 2 * Math.PI, true));
  const geometry = new ExtrudeGeometry(shape, { depth: thick_mm - 2 * BEVEL_MM, ...BEVEL });
  // Extruded along its Z, which becomes Y to the right.
  return geometry.translate(0, 0, -(thick_mm / 2 - BEVEL_MM)).rotateX(Math.PI / 2).translate(0, y_mm, 0);
}

/**
 * A box with round edges along Z.
 * @param {Point} size_mm
 * @param {Point} middle_mm
 * @param {number} [radius_mm]
 */
export function block([x, y, z], [atX, atY, atZ], radius_mm = 3) {
  const [a, b] = [x / 2 - radius_mm, y / 2 - radius_mm];
  const shape = hull([[a, -b, radius_mm], [a, b, radius_mm], [-a, b, radius_mm], [-a, -b, radius_mm]]);
  const geometry = new ExtrudeGeometry(shape, { depth: z - 2 * BEVEL_MM, ...BEVEL, curveSegments: radius_mm > 8 ? 6 : 3 });
  return geometry.translate(atX, atY, atZ - z / 2 + BEVEL_MM);
}

/**
 * A round part along Y.
 * @param {number} radius_mm
 * @param {number} from_mm
 * @param {number} to_mm
 * @param {readonly [number, number]} [at_mm]
 */
export function pin(radius_mm, from_mm, to_mm, [x, z] = [0, 0]) {
  return new CylinderGeometry(radius_mm, radius_mm, to_mm - from_mm, 20).translate(x, (from_mm + to_mm) / 2, z);
}

/**
 * A turned part about Z: radius and height, from the bottom to the top.
 * @param {readonly (readonly [number, number])[]} outline
 */
export function turned(outline) {
  return new LatheGeometry(outline.map(([radius, z]) => new Vector2(radius, z)), 32).rotateX(Math.PI / 2);
}

/**
 * @param {Point} size_mm
 * @param {Point} middle_mm
 */
export const box = (size_mm, middle_mm) => new BoxGeometry(...size_mm).translate(...middle_mm);

/**
 * A group with a mesh for each material.
 * @param {readonly (readonly [Material, readonly BufferGeometry[]])[]} parts
 */
export function solid(parts) {
  const group = new Group();
  for (const [material, geometries] of parts) {
    const mesh = new Mesh(joined(geometries), material);
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    group.add(mesh);
  }
  return group;
}

/**
 * The outline around circles whose middles make a convex figure.
 * @param {readonly Circle[]} circles
 */
function hull(circles) {
  const shape = new Shape();
  circles.forEach(([x, y, radius], n) => {
    const before = /** @type {Circle} */ (circles.at(n - 1));
    const after = /** @type {Circle} */ (circles[(n + 1) % circles.length]);
    shape.absarc(x, y, radius, tangent(before, [x, y, radius]), tangent([x, y, radius], after), false);
  });
  return shape;
}

/**
 * In which direction the outline touches both circles.
 * @param {Circle} from
 * @param {Circle} to
 */
function tangent([x0, y0, r0], [x1, y1, r1]) {
  const dx = x1 - x0, dy = y1 - y0;
  return Math.atan2(dy, dx) - Math.acos((r0 - r1) / Math.hypot(dx, dy));
}

/** @param {readonly BufferGeometry[]} geometries */
function joined(geometries) {
  const plain = geometries.map((geometry) => (geometry.index ? geometry.toNonIndexed() : geometry));
  const whole = new BufferGeometry();
  for (const name of ["position", "normal"]) {
    const arrays = plain.map((geometry) => /** @type {Float32Array} */ (geometry.getAttribute(name).array));
    const all = new Float32Array(arrays.reduce((sum, it) => sum + it.length, 0));
    let at = 0;
    for (const array of arrays) all.set(array, at), at += array.length;
    whole.setAttribute(name, new BufferAttribute(all, 3));
  }
  for (const it of [...geometries, ...plain]) it.dispose();
  return whole;
}

/**
 * Rotates about Y so that X points along a direction in the link's plane.
 * @param {import("../vendor/three/three.js").Object3D} object
 * @param {readonly [number, number]} from
 * @param {readonly [number, number]} to
 */
export function lay(object, [r0, z0], [r1, z1]) {
  object.position.set(r0, 0, z0);
  object.rotation.y = -Math.atan2(z1 - z0, r1 - r0);
}
